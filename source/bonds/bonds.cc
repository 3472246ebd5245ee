#include <rift/base/check.h>
#include <rift/bonds/bonds.h>
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

    /** Adds what a bond has used in half a step.
     * @param velocity of the second node against the first, m/s. */
    void
    count_half_step(Bond                  &bond,
                    const Vector3<double> &normal,
                    const Vector3<double> &velocity,
                    const double           time_step)
    {
      const BondLaw::Traction t        = BondLaw::split(bond.traction, normal);
      const double            factor   = .5 * time_step * bond.area;
      const double            work     = factor * dot(bond.traction, velocity);
      double                  friction = 0, closing = 0;
      if (t.normal < 0)
        {
          const double along = dot(normal, velocity);
          const double shear = norm(t.shear);
          closing            = factor * t.normal * along;
          if (shear > 0)
            friction = std::min(1.,
                                -BondLaw::friction(bond.strength, bond.memory) *
                                  t.normal / shear) *
                       std::max(0., factor * dot(t.shear, velocity));
        }
      bond.energy.friction += friction;
      bond.energy.closing += closing;
      bond.energy.fracture += work - friction - closing;
    }

    /** The current normal of the crack plane: it turns with its faces. */
    Vector3<double>
    current_normal(const VertexBonds            &group,
                   const Bond                   &bond,
                   const std::vector<FaceFrame> &frames)
    {
      Vector3<double> sum = {{0, 0, 0}};
      for (std::uint32_t i = bond.fan_begin; i < bond.fan_end; ++i)
        sum += frames[group.fan[i].face].vector(group.fan[i].plane);
      return (1 / norm(sum)) * sum;
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
        else
          for (Bond &bond : groups[place->second].bonds)
            {
              const VertexBonds &group = groups[place->second];
              count_half_step(bond,
                              current_normal(group, bond, crack_faces.frames()),
                              relative_velocity(group, bond, state),
                              time_step);
              bond.is_counted = true;
            }
        groups[place->second] =
          make_group(state,
                     vertex,
                     splits,
                     is_new ? nullptr : &groups[place->second]);
      }
  }

  VertexBonds
  Bonds::make_group(const State                  &state,
                    const VertexIndex             vertex,
                    const std::vector<NodeSplit> &splits,
                    const VertexBonds            *old)
  {
    VertexBonds group{vertex,
                      is_on_surface(topology, vertex),
                      nodes_at(topology, vertex),
                      {},
                      {}};
    const auto  part_of = [&group](const NodeIndex node) {
      return static_cast<std::uint32_t>(
        std::find(group.parts.begin(), group.parts.end(), node) -
        group.parts.begin());
    };
    const auto former = [&](const std::uint32_t part) {
      for (const NodeSplit &split : splits)
        if (std::find(split.parts.begin(),
                      split.parts.end(),
                      group.parts[part]) != split.parts.end())
          return split.parts[0];
      return group.parts[part];
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
    std::vector<const Bond *> has_passed_on_energy;
    for (const auto &[pair, corners] : between)
      {
        Bond            bond{};
        const NodeIndex first  = former(pair.first),
                        second = former(pair.second);
        const Bond *before     = nullptr;
        double      sign       = 1;
        if (old != nullptr && first != second)
          for (const Bond &candidate : old->bonds)
            {
              const NodeIndex a = old->parts[candidate.parts[0]],
                              b = old->parts[candidate.parts[1]];
              if ((a == first && b == second) || (a == second && b == first))
                {
                  before = &candidate;
                  sign   = a == first ? 1 : -1;
                }
            }
        if (before != nullptr)
          {
            bond          = *before;
            bond.plane    = sign * bond.plane;
            bond.traction = sign * bond.traction;
            if (std::find(has_passed_on_energy.begin(),
                          has_passed_on_energy.end(),
                          before) != has_passed_on_energy.end())
              bond.energy = {};
            has_passed_on_energy.push_back(before);
          }
        bond.parts[0] = pair.first;
        bond.parts[1] = pair.second;
        bond.is_new   = before == nullptr;
        set_geometry(group, bond, corners, state);
        if (bond.is_new)
          bond.strength = strengths.strength(vertex, bond.plane);
        group.bonds.push_back(bond);
      }
    rift_check(
      old == nullptr ||
      std::all_of(old->bonds.begin(), old->bonds.end(), [&](const Bond &bond) {
        return std::find(has_passed_on_energy.begin(),
                         has_passed_on_energy.end(),
                         &bond) != has_passed_on_energy.end();
      }));
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
  }

  void
  Bonds::hold(State                        &state,
              const double                  time_step,
              const PrescribedAcceleration &prescribed)
  {
    crack_faces.update_frames(state);
    failed_corners.clear();
    for (VertexBonds &group : groups)
      {
        prepare(group, state, time_step, prescribed);
        solve(group, time_step);
        finish(group, state, time_step);
      }
  }

  void
  Bonds::prepare(VertexBonds                  &group,
                 const State                  &state,
                 const double                  time_step,
                 const PrescribedAcceleration &prescribed)
  {
    work.velocity.resize(group.parts.size());
    work.inverse_mass.resize(group.parts.size());
    for (std::size_t p = 0; p < group.parts.size(); ++p)
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
            }
      }
    work.normal.resize(group.bonds.size());
    work.stiffness.resize(group.bonds.size());
    work.gap.resize(group.bonds.size());
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond     = group.bonds[i];
        work.normal[i] = current_normal(group, bond, crack_faces.frames());
        if (!bond.is_counted && !bond.is_new)
          count_half_step(bond,
                          work.normal[i],
                          relative_velocity(group, bond, state),
                          time_step);
        const auto [a, b] = bond.parts;
        const Vector3<double> jump =
          state.displacement[group.parts[b]].vector() -
          state.displacement[group.parts[a]].vector();
        work.gap[i] = std::max(0., dot(jump, work.normal[i]));
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
            Bond                  &bond   = group.bonds[i];
            const Vector3<double> &normal = work.normal[i];
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
                const BondLaw::Traction parts = BondLaw::split(trial, normal);
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
  Bonds::finish(VertexBonds &group, State &state, const double time_step)
  {
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond        = group.bonds[i];
        const auto [a, b] = bond.parts;
        const BondLaw::Traction t =
          BondLaw::split(bond.traction, work.normal[i]);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double force = bond.area * bond.traction[d];
            state.force[group.parts[a]][d] += force;
            state.force[group.parts[b]][d] -= force;
          }
        if (bond.is_new)
          bond.memory.excess =
            std::max(0.,
                     BondLaw::demand(bond.strength,
                                     t.normal,
                                     norm(t.shear),
                                     bond.strength.tan_friction_angle) -
                       1);
        count_half_step(bond,
                        work.normal[i],
                        relative_velocity(group, bond, state),
                        time_step);
        bond.is_new = bond.is_counted = false;
        const Vector3<double> motion =
          time_step * (work.velocity[b] - work.velocity[a]);
        const double opening = dot(motion, work.normal[i]);
        const double before  = bond.memory.damage;
        law.soften(bond.strength,
                   bond.memory,
                   t,
                   opening,
                   motion - opening * work.normal[i]);
        if (bond.memory.damage >= 1 && before < 1)
          for (std::uint32_t f = bond.fan_begin; f < bond.fan_end; ++f)
            failed_corners.push_back(group.fan[f]);
      }
  }
} // namespace rift
