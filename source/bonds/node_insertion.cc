#include <rift/base/check.h>
#include <rift/bonds/node_insertion.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** A candidate beside a crack waits until its demand is larger by so
     * much. */
    constexpr double margin_beside_crack = .5;

    /** A plane of a crack around is taken if it bears at most this much less
     * than the weakest one. */
    constexpr double tolerance_in_tension = .01, tolerance_in_shear = .3;

    /** Cosine of the angle between planes that count as parallel. */
    constexpr double cosine_of_parallel = .8;

    /** Steps from one search for candidates to the next: those that are chosen
     * have been cut by then. */
    constexpr std::uint64_t steps_per_look = 2;

    /** Steps after which a node is tried again whose star could not be cut. */
    constexpr std::uint64_t steps_to_next_look = 50;
  } // namespace

  NodeInsertion::NodeInsertion(const Topology          &topology,
                               const ReferenceCellData &reference,
                               const InternalForce     &internal_force,
                               const NodeStrengths     &strengths,
                               CrackPlanes             &planes)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , planes(planes)
    , stresses(topology, internal_force)
  {
  }

  std::vector<FaceIndex>
  NodeInsertion::take_due_faces()
  {
    std::vector<FaceIndex> faces;
    for (const DueFace &next : due)
      if (topology.face_states[next.face] == FaceState::intact &&
          planes.of_faces.insert({next.face, next.plane}).second)
        faces.push_back(next.face);
    due.clear();
    for (const auto &[vertex, parts] : due_planes)
      {
        auto &all = planes.at_vertices[vertex];
        all.insert(all.end(), parts.begin(), parts.end());
      }
    due_planes.clear();
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void
  NodeInsertion::set_demand(const NodeIndex node, const double demand)
  {
    if (demands.size() <= node)
      demands.resize(topology.n_nodes(), 0);
    demands[node] = demand;
    with_demand.push_back(node);
  }

  void
  NodeInsertion::look(const State                  &state,
                      const std::vector<CellIndex> &hot_cells,
                      std::vector<CornerNews>      &news)
  {
    demands.resize(topology.n_nodes(), 0);
    next_look.resize(topology.n_nodes(), 0);
    last_look.resize(topology.n_nodes(), invalid_index);
    for (const CrackCandidate &candidate : candidates)
      {
        const auto cells = cells_at_node(topology, candidate.node);
        if (is_largest(state, candidate, cells) &&
            (candidate.demand >= 1 + margin_beside_crack ||
             is_on_front(candidate.node, cells) || !is_beside_crack(cells)))
          cut(state, candidate, cells, news);
      }
    candidates.clear();
    if (state.step % steps_per_look == 0)
      find_candidates(state, hot_cells);
    for (const CrackCandidate &candidate : candidates)
      for (const auto &[cell, corner] : cells_at_node(topology, candidate.node))
        news.push_back({cell,
                        corner,
                        n_corners,
                        CornerNews::Kind::candidate,
                        {{candidate.demand, 0, 0, 0}}});
  }

  void
  NodeInsertion::take_in(const std::vector<CornerNews> &news)
  {
    for (const CornerNews &item : news)
      {
        const auto &v = item.values;
        switch (item.kind)
          {
          case CornerNews::Kind::candidate:
            set_demand(topology.node(item.cell, item.corner), v[0]);
            break;
          case CornerNews::Kind::cut:
            {
              const FaceIndex face =
                topology.cell_faces[item.cell][item.local_face];
              if (face != invalid_index)
                due.push_back({face, {{v[0], v[1], v[2]}}});
              else
                planes.beside_remote_cuts.insert(item.cell);
              break;
            }
          case CornerNews::Kind::plane:
            add_plane(topology.vertex(item.cell, item.corner),
                      {{{v[0], v[1], v[2]}}, v[3]});
            break;
          default:
            break;
          }
      }
  }

  void
  NodeInsertion::add_plane(const VertexIndex        vertex,
                           const CrackPlanes::Part &part)
  {
    // Other ranks tell of it once for each cell.
    auto &parts = due_planes[vertex];
    if (std::none_of(parts.begin(),
                     parts.end(),
                     [&part](const CrackPlanes::Part &known) {
                       return known.normal == part.normal;
                     }))
      parts.push_back(part);
  }

  SymmetricTensor<double>
  NodeInsertion::mean_stress(const State                 &state,
                             const std::vector<StarCell> &cells)
  {
    SymmetricTensor<double> sum{};
    double                  volume = 0;
    for (const auto &[cell, corner] : cells)
      {
        const std::uint32_t batch = cell / batch_size, lane = cell % batch_size;
        const SymmetricTensor<Simd> &second =
          stresses.of_batch(state, batch).second;
        const double v = reference[batch].volume[lane];
        volume += v;
        for (std::size_t i = 0; i < sum.size(); ++i)
          sum[i] += v * second[i][lane];
      }
    for (double &s : sum)
      s /= volume;
    return sum;
  }

  void
  NodeInsertion::find_candidates(const State                  &state,
                                 const std::vector<CellIndex> &hot_cells)
  {
    for (const NodeIndex node : with_demand)
      demands[node] = 0;
    with_demand.clear();
    for (const CellIndex hot : hot_cells)
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex   node   = topology.node(hot, c);
          const VertexIndex vertex = topology.node_vertices[node];
          if (last_look[node] == state.step || state.step < next_look[node] ||
              !topology.is_complete(vertex) || !strengths.is_breakable(vertex))
            continue;
          last_look[node] = state.step;
          cells_at_node(topology, node, star);
          const auto   stress = mean_stress(state, star);
          const double demand = strengths.largest_demand(vertex, stress);
          if (demand >= 1 + margin_beside_crack ||
              (demand >= 1 &&
               (is_on_front(node, star) || !is_beside_crack(star))))
            {
              candidates.push_back({node, demand, stress});
              set_demand(node, demand);
            }
        }
    stresses.clear();
  }

  bool
  NodeInsertion::is_largest(const State                 &state,
                            const CrackCandidate        &candidate,
                            const std::vector<StarCell> &cells) const
  {
    const auto place = [&state](const NodeIndex node) {
      return state.reference[node].vector();
    };
    for (const auto &[cell, corner] : cells)
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex other = topology.node(cell, c);
          if (demands[other] > candidate.demand ||
              (demands[other] == candidate.demand &&
               place(other) < place(candidate.node)))
            return false;
        }
    return true;
  }

  bool
  NodeInsertion::is_on_front(const NodeIndex              node,
                             const std::vector<StarCell> &cells) const
  {
    const VertexIndex vertex = topology.node_vertices[node];
    for (const auto &[cell, corner] : cells)
      for (unsigned int local = 0; local < n_corners; ++local)
        {
          const FaceIndex face = topology.cell_faces[cell][local];
          if (face == invalid_index || local == corner ||
              topology.face_states[face] == FaceState::intact)
            continue;
          const CellIndex other = topology.neighbour(face, cell);
          if (topology.node(other, topology.corner_at_vertex(other, vertex)) ==
              node)
            return true;
        }
    return false;
  }

  bool
  NodeInsertion::is_beside_crack(const std::vector<StarCell> &cells) const
  {
    for (const auto &[cell, corner] : cells)
      {
        if (planes.beside_remote_cuts.count(cell) > 0)
          return true;
        for (const FaceIndex face : topology.cell_faces[cell])
          if (face != invalid_index &&
              topology.face_states[face] != FaceState::intact)
            return true;
      }
    return false;
  }

  std::vector<Vector3<double>>
  NodeInsertion::possible_planes(const CrackCandidate        &candidate,
                                 const std::vector<StarCell> &cells) const
  {
    const VertexIndex vertex = topology.node_vertices[candidate.node];
    const auto weakest = strengths.weakest_planes(vertex, candidate.stress);
    if (weakest.by_shear)
      {
        if (const auto mean =
              plane_of_cracks_around(candidate, cells, weakest.normals))
          return {*mean};
        return weakest.normals;
      }
    // The planes of faces that end here.
    std::vector<Vector3<double>> of_cracks;
    for (const auto &[cell, corner] : cells)
      for (unsigned int local = 0; local < n_corners; ++local)
        {
          const FaceIndex face = topology.cell_faces[cell][local];
          if (face == invalid_index || local == corner ||
              topology.face_states[face] == FaceState::intact ||
              topology.faces[face].cells[0] != cell)
            continue;
          const CellIndex other = topology.neighbour(face, cell);
          if (topology.node(other, topology.corner_at_vertex(other, vertex)) !=
              candidate.node)
            continue;
          const Vector3<double> &plane = planes.of_faces.at(face);
          const bool             is_known =
            std::any_of(of_cracks.begin(),
                        of_cracks.end(),
                        [&](const Vector3<double> &m) {
                          return std::abs(dot(m, plane)) > .99;
                        });
          if (!is_known && demand_on(traction_on(candidate.stress, plane),
                                     strengths.strength(vertex, plane)) >=
                             (1 - tolerance_in_tension) * weakest.demand)
            of_cracks.push_back(plane);
        }
    return of_cracks.empty() ? weakest.normals : of_cracks;
  }

  std::optional<Vector3<double>>
  NodeInsertion::plane_of_cracks_around(
    const CrackCandidate               &candidate,
    const std::vector<StarCell>        &cells,
    const std::vector<Vector3<double>> &conjugate) const
  {
    const VertexIndex        vertex = topology.node_vertices[candidate.node];
    std::vector<VertexIndex> around;
    for (const auto &[cell, corner] : cells)
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const VertexIndex v = topology.vertex(cell, c);
          if (std::find(around.begin(), around.end(), v) == around.end())
            around.push_back(v);
        }
    struct Sum
    {
      Vector3<double> normal = {{0, 0, 0}};
      double          area   = 0;
    };
    std::vector<Sum> sums(conjugate.size());
    for (const VertexIndex v : around)
      if (const auto of_vertex = planes.at_vertices.find(v);
          of_vertex != planes.at_vertices.end())
        for (const CrackPlanes::Part &part : of_vertex->second)
          for (std::size_t k = 0; k < conjugate.size(); ++k)
            {
              const double cosine = dot(part.normal, conjugate[k]);
              if (std::abs(cosine) < cosine_of_parallel)
                continue;
              sums[k].area += part.area;
              sums[k].normal +=
                (cosine > 0 ? part.area : -part.area) * part.normal;
            }
    std::stable_sort(sums.begin(), sums.end(), [](const Sum &a, const Sum &b) {
      return a.area > b.area;
    });
    for (const Sum &sum : sums)
      if (sum.area > 0)
        {
          const Vector3<double> normal = (1 / norm(sum.normal)) * sum.normal;
          if (demand_on(traction_on(candidate.stress, normal),
                        strengths.strength(vertex, normal)) >=
              (1 - tolerance_in_shear) * candidate.demand)
            return normal;
        }
    return {};
  }

  void
  NodeInsertion::cut(const State                 &state,
                     const CrackCandidate        &candidate,
                     const std::vector<StarCell> &cells,
                     std::vector<CornerNews>     &news)
  {
    const VertexIndex      vertex = topology.node_vertices[candidate.node];
    std::optional<StarCut> best;
    Vector3<double>        plane{};
    for (const Vector3<double> &normal : possible_planes(candidate, cells))
      {
        const auto cut = cut_star(topology,
                                  reference,
                                  state,
                                  candidate.node,
                                  normal,
                                  [this](const FaceIndex face) {
                                    return strengths.is_breakable_face(face);
                                  });
        if (cut && (!best || cut->new_area / cut->projected_area <
                               best->new_area / best->projected_area))
          {
            best  = cut;
            plane = normal;
          }
      }
    if (!best)
      {
        next_look[candidate.node] = state.step + steps_to_next_look;
        return;
      }
    const CrackPlanes::Part part = {plane, best->projected_area / 3};
    add_plane(vertex, part);
    // Also to those that know other parts of the vertex alone.
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      news.push_back(
        {*cell,
         static_cast<std::uint8_t>(topology.corner_at_vertex(*cell, vertex)),
         n_corners,
         CornerNews::Kind::plane,
         {{plane[0], plane[1], plane[2], part.area}}});
    for (const FaceIndex face : best->faces)
      {
        due.push_back({face, plane});
        tell(face, vertex, plane, news);
      }
  }

  void
  NodeInsertion::tell(const FaceIndex          face,
                      const VertexIndex        vertex,
                      const Vector3<double>   &plane,
                      std::vector<CornerNews> &news) const
  {
    const Face &f = topology.faces[face];
    for (unsigned int side = 0; side < 2; ++side)
      news.push_back({f.cells[side],
                      static_cast<std::uint8_t>(
                        topology.corner_at_vertex(f.cells[side], vertex)),
                      f.local_faces[side],
                      CornerNews::Kind::cut,
                      {{plane[0], plane[1], plane[2], 0}}});
  }
} // namespace rift
