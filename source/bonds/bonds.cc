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
        VertexBonds &group = groups[place->second];
        for (Bond &bond : group.bonds)
          {
            count_energy(group.energy,
                         bond,
                         .5 * bond.traction,
                         time_step * relative_velocity(group, bond, state));
            bond.is_counted = true;
          }
        const VertexBonds old = std::move(group);
        group                 = make_group(state, vertex, heritage(old, here));
        group.energy          = old.energy;
        group.is_yielding     = old.is_yielding;
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
    return [&old, former](const NodeIndex first,
                          const NodeIndex second) -> std::optional<KnownBond> {
      const NodeIndex a = former(first), b = former(second);
      for (std::size_t i = 0; i < old.bonds.size(); ++i)
        {
          KnownBond       child{old.bonds[i], old.histories[i]};
          const NodeIndex nodes[2] = {old.parts[child.bond.parts[0]].node,
                                      old.parts[child.bond.parts[1]].node};
          const bool      is_same  = nodes[0] == a && nodes[1] == b;
          if (!is_same && (nodes[0] != b || nodes[1] != a))
            continue;
          child.bond.is_tied = false;
          if (!is_same)
            {
              child.history.plane = -1. * child.history.plane;
              child.bond.traction = -1. * child.bond.traction;
            }
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
    for (const NodeIndex node : nodes_at(topology, vertex))
      group.parts.push_back({node, 0, state.mass[node]});
    const auto part_of = [&group](const NodeIndex node) {
      return static_cast<std::uint32_t>(
        std::find_if(
          group.parts.begin(),
          group.parts.end(),
          [node](const VertexBonds::Part &part) { return part.node == node; }) -
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
          before(group.parts[pair.first].node, group.parts[pair.second].node);
        auto [bond, history] = known.value_or(KnownBond());
        bond.parts[0]        = pair.first;
        bond.parts[1]        = pair.second;
        bond.is_new          = !known;
        set_geometry(group, bond, history, corners, state);
        history.strength = strengths.strength(vertex, history.plane);
        bond.envelope    = BondLaw::envelope(history.strength, history.memory);
        group.bonds.push_back(bond);
        group.histories.push_back(history);
      }
    set_laplacian(group);
    update_normals(group, state);
    return group;
  }

  void
  Bonds::set_geometry(VertexBonds                  &group,
                      Bond                         &bond,
                      BondHistory                  &history,
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
          corner.minus == group.parts[bond.parts[0]].node ? 1. / 3 : -1. / 3;
        area_vector += sign * vector;
        area += norm(vector) / 3;
        const Vector3<double> &plane = planes.of_faces.at(corner.face);
        mean_plane += dot(plane, sign * vector) * plane;
      }
    if (bond.is_new)
      {
        // Faces that are folded back on each other may cancel.
        constexpr double least = 1e-3;
        history.plane          = norm(mean_plane) > least * area ?
                                   mean_plane :
                                   planes.of_faces.at(corners[0].face);
        if (dot(history.plane, area_vector) < 0)
          history.plane = -1. * history.plane;
        history.plane = (1 / norm(history.plane)) * history.plane;
      }
    bond.area =
      std::max(dot(area_vector, history.plane), least_projection * area);
    history.fan_begin = static_cast<std::uint32_t>(group.fan.size());
    for (const CutCorner &corner : corners)
      {
        const Face         &face   = topology.faces[corner.face];
        const std::uint32_t place  = crack_faces.add(corner.face, state.time);
        const double        weight = norm(
          reference_area_vector(reference, face.cells[0], face.local_faces[0]));
        group.fan.push_back({place,
                             corner.corner,
                             weight * crack_faces.undeformed_frame(state, place)
                                        .components(history.plane)});
      }
    history.fan_end = static_cast<std::uint32_t>(group.fan.size());
    history.size    = std::sqrt(3 * area / static_cast<double>(corners.size()));
  }

  void
  Bonds::release()
  {
    for (VertexBonds &group : groups)
      {
        bool any = false;
        for (std::size_t i = 0; i < group.bonds.size(); ++i)
          {
            Bond              &bond    = group.bonds[i];
            const BondHistory &history = group.histories[i];
            if (history.memory.damage < 1 || bond.is_released)
              continue;
            bool are_released = true;
            for (std::uint32_t f = history.fan_begin; f < history.fan_end; ++f)
              are_released &=
                topology
                  .face_states[crack_faces.faces[group.fan[f].face].index] ==
                FaceState::released;
            if (are_released &&
                (norm(bond.traction) <= bond.envelope.rounding ||
                 bond.pressure_share == 0))
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

  std::vector<NodeIndex>
  Bonds::nodes_held_with(const NodeIndex node) const
  {
    const auto place = group_of_vertex.find(topology.node_vertices[node]);
    if (place == group_of_vertex.end())
      return {node};
    const VertexBonds &group = groups[place->second];
    if (std::any_of(group.bonds.begin(),
                    group.bonds.end(),
                    [](const Bond &bond) {
                      return !bond.is_tied && !bond.is_new && !bond.is_released;
                    }))
      return {node};
    const auto here = std::find_if(
      group.parts.begin(),
      group.parts.end(),
      [node](const VertexBonds::Part &part) { return part.node == node; });
    rift_check(here != group.parts.end());
    std::vector<NodeIndex> result;
    for (const VertexBonds::Part &part : group.parts)
      if (part.root == here->root)
        result.push_back(part.node);
    return result;
  }

  void
  Bonds::update_normals(VertexBonds &group, const State &state) const
  {
    for (std::size_t b = 0; b < group.bonds.size(); ++b)
      {
        const BondHistory &history = group.histories[b];
        Vector3<double>    sum     = {{0, 0, 0}};
        for (std::uint32_t i = history.fan_begin; i < history.fan_end; ++i)
          sum += crack_faces.current_frame(state, group.fan[i].face)
                   .vector(group.fan[i].plane);
        group.bonds[b].normal = (1 / norm(sum)) * sum;
        update_gap(group, group.bonds[b], history, state);
      }
  }

  namespace
  {
    template <typename T>
    void
    prefetch(const std::vector<T> &list)
    {
      constexpr std::size_t line = 64;
      const char           *data = reinterpret_cast<const char *>(list.data());
      for (std::size_t i = 0; i < list.size() * sizeof(T); i += line)
        __builtin_prefetch(data + i);
    }

    void
    prefetch(const VertexBonds &group)
    {
      prefetch(group.parts);
      prefetch(group.inverse);
      prefetch(group.bonds);
      if (group.is_yielding)
        prefetch(group.histories);
    }

    void
    prefetch(const VertexBonds &group, const State &state)
    {
      for (const VertexBonds::Part &part : group.parts)
        {
          __builtin_prefetch(&state.velocity[part.node]);
          __builtin_prefetch(&state.force[part.node]);
          if (group.is_yielding)
            __builtin_prefetch(&state.displacement[part.node]);
        }
    }
  } // namespace

  void
  Bonds::hold(State                        &state,
              const double                  time_step,
              const PrescribedAcceleration &prescribed)
  {
    failed_corners.clear();
    // The forces of the cells have pushed all of it out of the caches.
    constexpr std::size_t ahead = 8;
    for (std::size_t i = 0; i < groups.size(); ++i)
      {
        if (i + 2 * ahead < groups.size())
          prefetch(groups[i + 2 * ahead]);
        if (i + ahead < groups.size())
          prefetch(groups[i + ahead], state);
        VertexBonds &group = groups[i];
        if (group.n_active == 0)
          continue;
        if (state.step % steps_of_normal == 0)
          update_normals(group, state);
        if (solver.hold(group, state, time_step, prescribed))
          for (const BondHistory &history : group.histories)
            if (history.memory.damage >= 1)
              for (auto f = history.fan_begin; f < history.fan_end; ++f)
                failed_corners.push_back(group.fan[f]);
      }
  }
} // namespace rift
