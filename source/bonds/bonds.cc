#include <rift/base/check.h>
#include <rift/bonds/bonds.h>
#include <rift/discretization/discretization.h>
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
    std::map<VertexIndex, std::vector<NodeSplit>> splits_at;
    for (const NodeSplit &split : splits)
      splits_at[topology.node_vertices[split.parts[0]]].push_back(split);
    crack_faces.update_nodes(vertices_of(topology, splits));
    for (const auto &[vertex, here] : splits_at)
      {
        const auto [place, is_new] = group_of_vertex.insert(
          {vertex, static_cast<std::uint32_t>(groups.size())});
        if (is_new)
          groups.emplace_back();
        for (Bond &bond : groups[place->second].bonds)
          {
            count_energy(bond,
                         .5 * bond.traction,
                         time_step * relative_velocity(groups[place->second],
                                                       bond,
                                                       state));
            bond.is_counted = true;
          }
        const VertexBonds old = std::move(groups[place->second]);
        groups[place->second] = make_group(state, vertex, heritage(old, here));
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
    VertexBonds group;
    group.vertex = vertex;
    group.parts  = nodes_at(topology, vertex);
    for (const NodeIndex node : group.parts)
      group.masses.push_back(state.mass[node]);
    const auto part_of = [&group](const NodeIndex node) {
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
        mean_plane += dot(plane, sign * vector) * plane;
      }
    if (bond.is_new)
      {
        // Faces that are folded back on each other may cancel.
        constexpr double least = 1e-3;
        bond.plane             = norm(mean_plane) > least * area ?
                                   mean_plane :
                                   planes.of_faces.at(corners[0].face);
        if (dot(bond.plane, area_vector) < 0)
          bond.plane = -1. * bond.plane;
        bond.plane = (1 / norm(bond.plane)) * bond.plane;
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
        if (group.n_active == 0)
          continue;
        if (state.step % steps_of_normal == 0)
          update_normals(group, state);
        if (solver.hold(group, state, time_step, prescribed))
          for (const Bond &bond : group.bonds)
            if (bond.memory.damage >= 1)
              for (std::uint32_t f = bond.fan_begin; f < bond.fan_end; ++f)
                failed_corners.push_back(group.fan[f]);
      }
  }
} // namespace rift
