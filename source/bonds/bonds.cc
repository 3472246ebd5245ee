#include <rift/base/check.h>
#include <rift/bonds/bonds.h>
#include <rift/bonds/node_star.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rift
{
  namespace
  {
    /** Share of its faces' area that a bond has at least, however they are
     * folded. */
    constexpr double least_projection = .3;

    /** Steps after which normals are turned again: no body turns far within
     * them. */
    constexpr std::uint64_t steps_of_normal = 16;

    /**
     * Adds what a bond has used while its traction had a mean value.
     *
     * @param motion of the second node against the first, m.
     */
    void
    count(Bond                  &bond,
          const Vector3<double> &mean_traction,
          const Vector3<double> &motion)
    {
      const BondLaw::Traction t    = BondLaw::split(mean_traction, bond.normal);
      const double            work = bond.area * dot(mean_traction, motion);
      double                  friction = 0, closing = 0;
      if (t.normal < 0)
        {
          const double shear = norm(t.shear);
          closing            = bond.area * t.normal * dot(bond.normal, motion);
          if (shear > 0)
            friction = std::min(1.,
                                -BondLaw::friction(bond.strength, bond.memory) *
                                  t.normal / shear) *
                       std::max(0., bond.area * dot(t.shear, motion));
        }
      bond.energy.friction += friction;
      bond.energy.closing += closing;
      bond.energy.fracture += work - friction - closing;
    }

    /** Whether a bond bears a traction. */
    bool
    bears(const Bond            &bond,
          const Vector3<double> &traction,
          const double           pressure_share)
    {
      const double limit  = bond.memory.softening + bond.memory.excess;
      const double normal = dot(traction, bond.normal);
      if (normal < 0 && pressure_share < 1)
        return false;
      const double shear =
        std::sqrt(std::max(0., dot(traction, traction) - normal * normal));
      return BondLaw::demand(bond.strength,
                             normal,
                             shear,
                             BondLaw::friction(bond.strength, bond.memory)) <=
             limit;
    }

    /** Displacement of the second node against the first, m. */
    Vector3<double>
    jump_of(const VertexBonds &group, const Bond &bond, const State &state)
    {
      return state.displacement[group.parts[bond.parts[1]]].vector() -
             state.displacement[group.parts[bond.parts[0]]].vector();
    }

    Vector3<double>
    relative_velocity(const VertexBonds &group,
                      const Bond        &bond,
                      const State       &state)
    {
      return state.velocity[group.parts[bond.parts[1]]].vector() -
             state.velocity[group.parts[bond.parts[0]]].vector();
    }

    /** The nodes at a vertex, by their smallest cells. */
    std::vector<NodeIndex>
    nodes_at(const Topology &topology, const VertexIndex vertex)
    {
      std::vector<NodeIndex> nodes;
      for (auto cell = topology.vertex_cells_first(vertex);
           cell != topology.vertex_cells_last(vertex);
           ++cell)
        {
          const NodeIndex node =
            topology.node(*cell, topology.corner_at_vertex(*cell, vertex));
          if (std::find(nodes.begin(), nodes.end(), node) == nodes.end())
            nodes.push_back(node);
        }
      return nodes;
    }

    /** Whether one of the cells around a vertex has a face there that belongs to
     * the surface of the body. */
    bool
    is_on_surface(const Topology &topology, const VertexIndex vertex)
    {
      for (auto cell = topology.vertex_cells_first(vertex);
           cell != topology.vertex_cells_last(vertex);
           ++cell)
        for (unsigned int local = 0; local < n_corners; ++local)
          if (local != topology.corner_at_vertex(*cell, vertex) &&
              topology.cell_faces[*cell][local] == invalid_index)
            return true;
      return false;
    }
  } // namespace

  Bonds::Bonds(const Topology          &topology,
               const ReferenceCellData &reference,
               const NodeStrengths     &strengths,
               const CrackPlanes       &planes)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , planes(planes)
    , crack_faces(topology)
  {
  }

  void
  Bonds::rebuild(const State                  &state,
                 const std::vector<NodeSplit> &splits,
                 const double                  time_step)
  {
    std::vector<VertexIndex> vertices;
    for (const NodeSplit &split : splits)
      vertices.push_back(topology.node_vertices[split.parts[0]]);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
    crack_faces.update_nodes(vertices);
    for (const VertexIndex vertex : vertices)
      {
        const auto [place, is_new] = group_of_vertex.insert(
          {vertex, static_cast<std::uint32_t>(groups.size())});
        if (is_new)
          groups.emplace_back();
        for (Bond &bond : groups[place->second].bonds)
          {
            count(bond,
                  .5 * bond.traction,
                  time_step *
                    relative_velocity(groups[place->second], bond, state));
            bond.is_counted = true;
          }
        const VertexBonds old = std::move(groups[place->second]);
        groups[place->second] =
          make_group(state, vertex, heritage(old, splits));
      }
  }

  Bonds::Heritage
  Bonds::heritage(const VertexBonds &old, const std::vector<NodeSplit> &splits)
  {
    const auto former = [&splits](const NodeIndex node) {
      for (const NodeSplit &split : splits)
        if (std::find(split.parts.begin(), split.parts.end(), node) !=
            split.parts.end())
          return split.parts[0];
      return node;
    };
    return [&old, former, has_passed_on_energy = std::vector<const Bond *>()](
             const NodeIndex first,
             const NodeIndex second) mutable -> std::optional<Bond> {
      const NodeIndex a = former(first), b = former(second);
      for (const Bond &bond : old.bonds)
        {
          const NodeIndex nodes[2] = {old.parts[bond.parts[0]],
                                      old.parts[bond.parts[1]]};
          const bool      is_same  = nodes[0] == a && nodes[1] == b;
          if (!is_same && (nodes[0] != b || nodes[1] != a))
            continue;
          Bond child    = bond;
          child.is_tied = false;
          if (!is_same)
            {
              child.plane    = -1. * child.plane;
              child.traction = -1. * child.traction;
            }
          // The first of several children has the energy.
          if (std::find(has_passed_on_energy.begin(),
                        has_passed_on_energy.end(),
                        &bond) != has_passed_on_energy.end())
            child.energy = {};
          has_passed_on_energy.push_back(&bond);
          return child;
        }
      return {};
    };
  }

  VertexBonds
  Bonds::make_group(const State      &state,
                    const VertexIndex vertex,
                    const Heritage   &before)
  {
    VertexBonds group{vertex,
                      is_on_surface(topology, vertex),
                      nodes_at(topology, vertex),
                      {},
                      {},
                      {},
                      {}};
    const auto  part_of = [&group](const NodeIndex node) {
      return static_cast<std::uint32_t>(
        std::find(group.parts.begin(), group.parts.end(), node) -
        group.parts.begin());
    };
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Pair, std::vector<CutCorner>> between;
    for (const CutCorner &corner : cut_corners_at(topology, vertex))
      if (corner.minus != corner.plus)
        {
          const std::uint32_t a = part_of(corner.minus),
                              b = part_of(corner.plus);
          between[{std::min(a, b), std::max(a, b)}].push_back(corner);
        }
    for (const auto &[pair, corners] : between)
      {
        const auto known =
          before(group.parts[pair.first], group.parts[pair.second]);
        Bond bond     = known.value_or(Bond());
        bond.parts[0] = pair.first;
        bond.parts[1] = pair.second;
        bond.is_new   = !known;
        set_geometry(group, bond, corners, state);
        bond.strength = strengths.strength(vertex, bond.plane);
        group.bonds.push_back(bond);
      }
    set_laplacian(group);
    update_normals(group, state);
    return group;
  }

  void
  Bonds::set_geometry(VertexBonds                  &group,
                      Bond                         &bond,
                      const std::vector<CutCorner> &corners,
                      const State                  &state)
  {
    // From the first part to the second.
    Vector3<double> area_vector = {{0, 0, 0}}, mean_plane = {{0, 0, 0}};
    double          area = 0;
    for (const CutCorner &corner : corners)
      {
        const Face           &face = topology.faces[corner.face];
        const Vector3<double> vector =
          reference_area_vector(reference, face.cells[0], face.local_faces[0]);
        const double sign =
          corner.minus == group.parts[bond.parts[0]] ? 1. / 3 : -1. / 3;
        area_vector += sign * vector;
        area += norm(vector) / 3;
        const Vector3<double> &plane = planes.of_faces.at(corner.face);
        mean_plane +=
          (norm(vector) * (sign * dot(plane, vector) < 0 ? -1. : 1.)) * plane;
      }
    if (bond.is_new)
      {
        bond.plane = (1 / norm(mean_plane)) * mean_plane;
        if (dot(bond.plane, area_vector) < 0)
          bond.plane = -1. * bond.plane;
      }
    bond.area = std::max(dot(area_vector, bond.plane), least_projection * area);
    bond.fan_begin = static_cast<std::uint32_t>(group.fan.size());
    for (const CutCorner &corner : corners)
      {
        const Face         &face   = topology.faces[corner.face];
        const std::uint32_t place  = crack_faces.add(corner.face, state.time);
        const double        weight = norm(
          reference_area_vector(reference, face.cells[0], face.local_faces[0]));
        group.fan.push_back({place,
                             corner.corner,
                             weight * crack_faces.undeformed_frame(state, place)
                                        .components(bond.plane)});
      }
    bond.fan_end = static_cast<std::uint32_t>(group.fan.size());
    bond.size    = std::sqrt(3 * area / static_cast<double>(corners.size()));
  }

  std::vector<BondRecord>
  Bonds::records() const
  {
    std::vector<BondRecord> result;
    for (const VertexBonds &group : groups)
      for (const Bond &bond : group.bonds)
        if (topology.owns_node(group.parts[0]))
          {
            BondRecord record{};
            for (unsigned int side = 0; side < 2; ++side)
              {
                const StarCell first =
                  cells_at_node(topology, group.parts[bond.parts[side]])[0];
                record.cells[side]   = topology.cell_global_indices[first.cell];
                record.corners[side] = first.corner;
              }
            record.is_tied     = bond.is_tied ? 1 : 0;
            record.is_released = bond.is_released ? 1 : 0;
            record.plane       = bond.plane;
            record.normal      = bond.normal;
            record.traction    = bond.traction;
            record.damage      = bond.memory.damage;
            record.excess      = bond.memory.excess;
            record.fracture    = bond.energy.fracture;
            record.friction    = bond.energy.friction;
            record.closing     = bond.energy.closing;
            result.push_back(record);
          }
    return result;
  }

  void
  Bonds::restore(const State &state, const std::vector<BondRecord> &records)
  {
    std::map<std::pair<NodeIndex, NodeIndex>, const BondRecord *> by_nodes;
    std::vector<VertexIndex>                                      vertices;
    for (const BondRecord &record : records)
      {
        const CellIndex a = topology.find_cell(record.cells[0]),
                        b = topology.find_cell(record.cells[1]);
        if (a == invalid_index || b == invalid_index)
          continue;
        const NodeIndex nodes[2] = {topology.node(a, record.corners[0]),
                                    topology.node(b, record.corners[1])};
        if (!topology.is_complete(topology.node_vertices[nodes[0]]))
          continue;
        by_nodes[{nodes[0], nodes[1]}] = &record;
        vertices.push_back(topology.node_vertices[nodes[0]]);
      }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
    for (const VertexIndex vertex : vertices)
      {
        group_of_vertex[vertex] = static_cast<std::uint32_t>(groups.size());
        groups.push_back(make_group(
          state,
          vertex,
          [&](const NodeIndex first,
              const NodeIndex second) -> std::optional<Bond> {
            const BondRecord &record = *by_nodes.at({first, second});
            Bond              bond{};
            bond.plane            = record.plane;
            bond.traction         = record.traction;
            bond.memory.damage    = record.damage;
            bond.memory.excess    = record.excess;
            bond.memory.softening = law.softening_at(record.damage);
            bond.energy  = {record.fracture, record.friction, record.closing};
            bond.is_tied = record.is_tied != 0;
            bond.is_released = record.is_released != 0;
            return bond;
          }));
        // They are as of the step in which they were turned last.
        VertexBonds &group = groups.back();
        for (Bond &bond : group.bonds)
          bond.normal =
            by_nodes
              .at({group.parts[bond.parts[0]], group.parts[bond.parts[1]]})
              ->normal;
      }
  }

  void
  Bonds::set_laplacian(VertexBonds &group)
  {
    const std::size_t n = group.parts.size();
    group.root.resize(n);
    for (std::uint32_t p = 0; p < n; ++p)
      group.root[p] = p;
    for (bool changes = true; changes;)
      {
        changes = false;
        for (const Bond &bond : group.bonds)
          {
            if (bond.is_released)
              continue;
            std::uint32_t &a = group.root[bond.parts[0]];
            std::uint32_t &b = group.root[bond.parts[1]];
            changes |= a != b;
            a = b = std::min(a, b);
          }
      }
    // Roots have a potential of zero: their rows are those of the unit matrix.
    std::vector<double> matrix(n * n, 0);
    for (std::uint32_t p = 0; p < n; ++p)
      if (group.root[p] == p)
        matrix[p * n + p] = 1;
    for (const Bond &bond : group.bonds)
      for (unsigned int side = 0; side < 2 && !bond.is_released; ++side)
        {
          const std::uint32_t p = bond.parts[side], q = bond.parts[1 - side];
          if (group.root[p] == p)
            continue;
          matrix[p * n + p] += bond.area;
          if (group.root[q] != q)
            matrix[p * n + q] -= bond.area;
        }
    // Gauss and Jordan: positive definite, no pivots are needed.
    group.inverse.assign(n * n, 0);
    for (std::uint32_t p = 0; p < n; ++p)
      group.inverse[p * n + p] = 1;
    for (std::size_t k = 0; k < n; ++k)
      {
        rift_check(matrix[k * n + k] > 0);
        const double pivot = 1 / matrix[k * n + k];
        for (std::size_t j = 0; j < n; ++j)
          {
            matrix[k * n + j] *= pivot;
            group.inverse[k * n + j] *= pivot;
          }
        for (std::size_t i = 0; i < n; ++i)
          if (const double factor = matrix[i * n + k]; i != k && factor != 0)
            for (std::size_t j = 0; j < n; ++j)
              {
                matrix[i * n + j] -= factor * matrix[k * n + j];
                group.inverse[i * n + j] -= factor * group.inverse[k * n + j];
              }
      }
  }

  double
  Bonds::pressure_share(const VertexBonds &group,
                        const Bond        &bond,
                        const State       &state) const
  {
    if (bond.memory.damage < 1)
      return 1;
    const Vector3<double> jump = jump_of(group, bond, state);
    const double slip = norm(jump - dot(jump, bond.normal) * bond.normal);
    return std::clamp(1 - (slip / bond.size - slip_to_contact) / slip_of_fading,
                      0.,
                      1.);
  }

  void
  Bonds::release(const State &state)
  {
    for (VertexBonds &group : groups)
      {
        bool any = false;
        for (Bond &bond : group.bonds)
          {
            if (bond.memory.damage < 1 || bond.is_released)
              continue;
            bool are_released = true;
            for (std::uint32_t f = bond.fan_begin; f < bond.fan_end; ++f)
              are_released &=
                topology
                  .face_states[crack_faces.faces[group.fan[f].face].index] ==
                FaceState::released;
            if (are_released &&
                (dot(jump_of(group, bond, state), bond.normal) > 0 ||
                 pressure_share(group, bond, state) == 0))
              {
                bond.is_released = true;
                bond.traction    = {{0, 0, 0}};
                any              = true;
              }
          }
        if (any)
          set_laplacian(group);
      }
  }

  void
  Bonds::update_normals(VertexBonds &group, const State &state) const
  {
    for (Bond &bond : group.bonds)
      {
        Vector3<double> sum = {{0, 0, 0}};
        for (std::uint32_t i = bond.fan_begin; i < bond.fan_end; ++i)
          sum += crack_faces.current_frame(state, group.fan[i].face)
                   .vector(group.fan[i].plane);
        bond.normal = (1 / norm(sum)) * sum;
      }
  }

  void
  Bonds::hold(State                        &state,
              const double                  time_step,
              const PrescribedAcceleration &prescribed)
  {
    failed_corners.clear();
    for (VertexBonds &group : groups)
      {
        if (state.step % steps_of_normal == 0)
          update_normals(group, state);
        const bool is_moved = kick(group, state, time_step, prescribed);
        work.before.resize(group.bonds.size());
        work.pressure_share.resize(group.bonds.size());
        for (std::size_t i = 0; i < group.bonds.size(); ++i)
          {
            work.before[i] = group.bonds[i].traction;
            work.pressure_share[i] =
              pressure_share(group, group.bonds[i], state);
          }
        const bool is_tied = !is_moved && tie(group, state, time_step);
        if (!is_tied)
          {
            prepare(group, state, time_step);
            solve(group, time_step);
          }
        finish(group, state, time_step, is_tied);
      }
  }

  bool
  Bonds::kick(const VertexBonds            &group,
              const State                  &state,
              const double                  time_step,
              const PrescribedAcceleration &prescribed)
  {
    const std::size_t n = group.parts.size();
    work.velocity.resize(n);
    work.inverse_mass.resize(n);
    bool is_moved = false;
    for (std::size_t p = 0; p < n; ++p)
      {
        const NodeIndex node    = group.parts[p];
        const double    inverse = 1 / state.mass[node];
        work.velocity[p]        = state.velocity[node].vector() +
                           (time_step * inverse) * state.force[node].vector();
        work.inverse_mass[p] = {{inverse, inverse, inverse}};
        if (!group.is_on_surface || !prescribed)
          continue;
        for (unsigned int d = 0; d < dim; ++d)
          if (const auto acceleration = prescribed(node, d))
            {
              work.velocity[p][d] =
                state.velocity[node][d] + time_step * *acceleration;
              work.inverse_mass[p][d] = 0;
              is_moved                = true;
            }
      }
    return is_moved;
  }

  bool
  Bonds::tie(VertexBonds &group, const State &state, const double time_step)
  {
    const std::size_t n = group.parts.size();
    work.mass.assign(n, 0);
    work.momentum.assign(n, {{0, 0, 0}});
    for (std::size_t p = 0; p < n; ++p)
      {
        const double mass = state.mass[group.parts[p]];
        work.mass[group.root[p]] += mass;
        work.momentum[group.root[p]] += mass * work.velocity[p];
      }
    work.bond_force.resize(n);
    work.potential.assign(n, {{0, 0, 0}});
    for (std::size_t p = 0; p < n; ++p)
      {
        const std::uint32_t root = group.root[p];
        work.bond_force[p] =
          (state.mass[group.parts[p]] / time_step) *
          ((1 / work.mass[root]) * work.momentum[root] - work.velocity[p]);
      }
    for (std::size_t p = 0; p < n; ++p)
      if (group.root[p] != p)
        for (std::size_t q = 0; q < n; ++q)
          if (group.root[q] != q)
            work.potential[p] += group.inverse[p * n + q] * work.bond_force[q];
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      if (const Bond &bond = group.bonds[i];
          !bond.is_new && !bond.is_released &&
          !bears(bond,
                 work.potential[bond.parts[0]] - work.potential[bond.parts[1]],
                 work.pressure_share[i]))
        return false;
    for (Bond &bond : group.bonds)
      if (!bond.is_released)
        bond.traction =
          work.potential[bond.parts[0]] - work.potential[bond.parts[1]];
    return true;
  }

  void
  Bonds::prepare(VertexBonds &group, const State &state, const double time_step)
  {
    work.stiffness.resize(group.bonds.size());
    work.gap.resize(group.bonds.size());
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        const Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        const auto [a, b] = bond.parts;
        work.gap[i] =
          std::max(0., dot(jump_of(group, bond, state), bond.normal));
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double mobility =
              bond.area * time_step *
              (work.inverse_mass[a][d] + work.inverse_mass[b][d]);
            // Where both nodes are moved, nothing moves them but that.
            work.stiffness[i][d] = mobility > 0 ? 1 / mobility : 0;
          }
        push(bond, bond.traction, time_step);
      }
  }

  void
  Bonds::push(const Bond            &bond,
              const Vector3<double> &traction,
              const double           time_step)
  {
    const double factor = time_step * bond.area;
    const auto [a, b]   = bond.parts;
    for (unsigned int d = 0; d < dim; ++d)
      {
        work.velocity[a][d] += factor * work.inverse_mass[a][d] * traction[d];
        work.velocity[b][d] -= factor * work.inverse_mass[b][d] * traction[d];
      }
  }

  void
  Bonds::solve(VertexBonds &group, const double time_step)
  {
    // One bond alone is exact at once.
    const unsigned int most_turns = group.bonds.size() > 1 ? 30 : 1;
    const bool         any_new    = std::any_of(group.bonds.begin(),
                                     group.bonds.end(),
                                     [](const Bond &b) { return b.is_new; });
    const double       tolerance  = any_new ? 1e-6 : 1e-3;
    for (unsigned int turn = 0; turn < most_turns; ++turn)
      {
        double change = 0, scale = 0;
        for (std::size_t i = 0; i < group.bonds.size(); ++i)
          {
            Bond &bond = group.bonds[i];
            if (bond.is_released)
              continue;
            const Vector3<double> &normal = bond.normal;
            const Vector3<double>  relative =
              work.velocity[bond.parts[1]] - work.velocity[bond.parts[0]];
            Vector3<double> trial = bond.traction;
            double          along = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                trial[d] += work.stiffness[i][d] * relative[d];
                along += normal[d] * normal[d] * work.stiffness[i][d];
              }
            if (!bond.is_new)
              {
                BondLaw::Traction parts = BondLaw::split(trial, normal);
                if (parts.normal < 0)
                  parts.normal *= work.pressure_share[i];
                const BondLaw::Traction borne =
                  BondLaw::bear(bond.strength,
                                bond.memory,
                                parts,
                                parts.normal + along * work.gap[i] / time_step);
                trial = borne.normal * normal + borne.shear;
              }
            const Vector3<double> difference = trial - bond.traction;
            push(bond, difference, time_step);
            bond.traction = trial;
            change        = std::max(change, dot(difference, difference));
            scale         = std::max(scale,
                             dot(trial, trial) +
                               1e-6 * bond.strength.tensile_strength *
                                 bond.strength.tensile_strength);
          }
        if (change <= tolerance * tolerance * scale)
          break;
      }
  }

  void
  Bonds::finish(VertexBonds &group,
                State       &state,
                const double time_step,
                const bool   is_tied)
  {
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        const auto [a, b] = bond.parts;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double force = bond.area * bond.traction[d];
            state.force[group.parts[a]][d] += force;
            state.force[group.parts[b]][d] -= force;
          }
        if (!bond.is_tied)
          count(bond,
                .5 * (bond.is_counted ? bond.traction :
                                        bond.traction + work.before[i]),
                time_step * relative_velocity(group, bond, state));
        if (bond.is_new)
          {
            const auto t = BondLaw::split(bond.traction, bond.normal);
            bond.memory.excess =
              std::max(0.,
                       BondLaw::demand(bond.strength,
                                       t.normal,
                                       norm(t.shear),
                                       bond.strength.tan_friction_angle) -
                         1);
          }
        bond.is_new = bond.is_counted = false;
        bond.is_tied                  = is_tied;
        if (!is_tied)
          soften(group, bond, time_step);
      }
  }

  void
  Bonds::soften(const VertexBonds &group, Bond &bond, const double time_step)
  {
    const Vector3<double> motion =
      time_step * (work.velocity[bond.parts[1]] - work.velocity[bond.parts[0]]);
    const double opening = dot(motion, bond.normal);
    const double before  = bond.memory.damage;
    law.soften(bond.strength,
               bond.memory,
               BondLaw::split(bond.traction, bond.normal),
               opening,
               motion - opening * bond.normal);
    if (bond.memory.damage >= 1 && before < 1)
      for (std::uint32_t f = bond.fan_begin; f < bond.fan_end; ++f)
        failed_corners.push_back(group.fan[f]);
  }
} // namespace rift
