#include <rift/cohesive/cohesive_force.h>
#include <rift/mesh/mesh_data.h>
#include <rift/solid/cell_frequency.h>

#include <algorithm>
#include <limits>

// How cohesive elements come to life: the half of CohesiveForce that follows
// the changes of the topology.
namespace rift
{
  template <typename Function>
  void
  CohesiveForce::for_each_cut_face(const VertexIndex vertex,
                                   const Function   &f) const
  {
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      {
        const unsigned int here = topology.corner_at_vertex(*cell, vertex);
        for (unsigned int local = 0; local < n_corners; ++local)
          {
            const FaceIndex index = topology.cell_faces[*cell][local];
            if (local == here || index == invalid_index ||
                topology.face_states[index] == FaceState::intact)
              continue;
            // Each face once: from its minus side.
            const Face &face = topology.faces[index];
            if (face.cells[0] != *cell)
              continue;
            const auto &corners = face_corners[local];
            const auto  corner =
              std::find(corners.begin(), corners.end(), here) - corners.begin();
            f(index,
              static_cast<unsigned int>(corner),
              topology.node(*cell, here),
              topology.node(face.cells[1],
                            topology.corner_at_vertex(face.cells[1], vertex)));
          }
      }
  }

  void
  CohesiveForce::apply(const TopologyChange &change, const State &state)
  {
    const auto vertex_of = [&](const NodeSplit &split) {
      return topology.node_vertices[split.parts[0]];
    };

    std::vector<FaceIndex> newly_open;
    for (const NodeSplit &split : change.splits)
      for_each_cut_face(vertex_of(split),
                        [&](const FaceIndex face,
                            const unsigned int,
                            const NodeIndex minus,
                            const NodeIndex plus) {
                          if (minus != plus &&
                              index_of_face[face] == invalid_index)
                            newly_open.push_back(face);
                        });
    std::sort(newly_open.begin(), newly_open.end());
    newly_open.erase(std::unique(newly_open.begin(), newly_open.end()),
                     newly_open.end());
    for (const FaceIndex face : newly_open)
      activate(face, state);

    for (const NodeSplit &split : change.splits)
      {
        Parting parting;
        parting.nodes      = split.parts;
        const auto is_part = [&split](const NodeIndex node) {
          return std::find(split.parts.begin(), split.parts.end(), node) !=
                 split.parts.end();
        };
        for_each_cut_face(
          vertex_of(split),
          [&](const FaceIndex    face,
              const unsigned int corner,
              const NodeIndex    minus,
              const NodeIndex    plus) {
            // Another node at the same vertex may have split as well.
            const std::uint32_t index = index_of_face[face];
            if (index == invalid_index || !(is_part(minus) || is_part(plus)))
              return;
            CohesiveBatch &batch = cohesive_faces.batches[index / batch_size];
            const unsigned int lane      = index % batch_size;
            NodeIndex         &old_minus = batch.minus[corner][lane];
            NodeIndex         &old_plus  = batch.plus[corner][lane];
            if (minus != plus && old_minus == old_plus)
              parting.openings.push_back({index, corner});
            old_minus = minus;
            old_plus  = plus;
          });
        partings.push_back(std::move(parting));
      }
  }

  void
  CohesiveForce::activate(const FaceIndex index, const State &state)
  {
    const unsigned int lane = cohesive_faces.size() % batch_size;
    if (lane == 0)
      {
        // Lanes without a face are triangles of no area that never open.
        CohesiveBatch empty{};
        empty.edges[0][0] = empty.edges[1][1] = broadcast(1);
        empty.constants.stiffness             = broadcast(1);
        for (auto &point : empty.points)
          point.softening = broadcast(1);
        cohesive_faces.batches.push_back(empty);
      }
    index_of_face[index] = static_cast<std::uint32_t>(cohesive_faces.size());
    cohesive_faces.infos.push_back({index, state.time, -1});

    CohesiveBatch           &batch = cohesive_faces.batches.back();
    const Face              &face  = topology.faces[index];
    std::array<NodeIndex, 3> nodes;
    for (unsigned int c = 0; c < 3; ++c)
      {
        nodes[c] =
          topology.node(face.cells[0], face_corners[face.local_faces[0]][c]);
        batch.minus[c][lane] = batch.plus[c][lane] = nodes[c];
      }
    std::array<Vector3<double>, 2> edges;
    for (unsigned int e = 0; e < 2; ++e)
      {
        edges[e] = state.reference[nodes[e + 1]].vector() -
                   state.reference[nodes[0]].vector();
        for (unsigned int d = 0; d < dim; ++d)
          batch.edges[e][d][lane] = edges[e][d];
      }
    const double             area      = .5 * norm(cross(edges[0], edges[1]));
    const double             slope     = elastic_slope(index, area);
    const FaceStrength       strength  = strengths.strength(index);
    CohesiveConstants<Simd> &constants = batch.constants;
    batch.area[lane]                   = area;
    constants.stiffness[lane]          = slope;
    constants.tensile_strength[lane]   = strength.tensile_strength;
    constants.tan_friction_angle[lane] = strength.tan_friction_angle;
    for (unsigned int q = 0; q < n_face_points; ++q)
      set_point(batch, q, lane, make_cohesive_point(strength, slope));
    too_short += is_separation_too_short(strength, slope) ? 1 : 0;
    batch.n_faces = lane + 1;
  }

  double
  CohesiveForce::elastic_slope(const FaceIndex index, const double area) const
  {
    // A corner of mass m moves against the face with a stiffness of
    // k area / 3 on either side, hence omega^2 = 2 k area / (3 m). Three such
    // faces at a corner take what the cell itself leaves of the limit.
    const Face &face     = topology.faces[index];
    double      smallest = std::numeric_limits<double>::max();
    for (const CellIndex cell : face.cells)
      {
        const auto  &batch    = reference[cell / batch_size];
        const auto   lane     = cell % batch_size;
        const auto   material = topology.material(cell);
        const double mass =
          densities[material] * batch.volume[lane] / n_corners;
        const double of_cell = largest_frequency_squared(batch,
                                                         lane,
                                                         stiffnesses[material],
                                                         densities[material]);
        smallest = std::min(smallest, mass * (frequency_limit - of_cell) / 3);
      }
    return 1.5 * smallest / area;
  }

  void
  CohesiveForce::start_openings(State                        &state,
                                const PrescribedAcceleration &prescribed)
  {
    if (partings.empty())
      return;
    std::vector<CornerForce> shares;
    for (const Parting &parting : partings)
      share_bond_forces(state, parting, prescribed, shares);
    partings.clear();

    // An order that does not depend on how nodes are numbered here.
    std::sort(shares.begin(),
              shares.end(),
              [](const CornerForce &a, const CornerForce &b) {
                return std::make_pair(a.opening.index, a.opening.corner) <
                       std::make_pair(b.opening.index, b.opening.corner);
              });
    for (auto first = shares.begin(); first != shares.end();)
      {
        auto last = first;
        while (last != shares.end() &&
               last->opening.index == first->opening.index)
          ++last;
        hold(state, &*first, &*first + (last - first));
        first = last;
      }
  }

  std::vector<Vector3<double>>
  CohesiveForce::bond_forces(const State                  &state,
                             const Parting                &parting,
                             const PrescribedAcceleration &prescribed)
  {
    const std::size_t            n = parting.nodes.size();
    std::vector<Vector3<double>> bond(n);
    for (unsigned int d = 0; d < dim; ++d)
      {
        double                force = 0, mass = 0, held_mass = 0;
        std::optional<double> acceleration;
        std::vector<bool>     is_held(n, false);
        for (std::size_t i = 0; i < n; ++i)
          {
            const NodeIndex node = parting.nodes[i];
            force += state.force[node][d];
            mass += state.mass[node];
            if (const auto a = prescribed ? prescribed(node, d) : std::nullopt)
              {
                acceleration = a;
                is_held[i]   = true;
                held_mass += state.mass[node];
              }
          }
        double of_free_nodes = 0;
        for (std::size_t i = 0; i < n; ++i)
          if (!is_held[i])
            {
              const NodeIndex node = parting.nodes[i];
              bond[i][d] =
                state.mass[node] * acceleration.value_or(force / mass) -
                state.force[node][d];
              of_free_nodes += bond[i][d];
            }
        // What free nodes need comes from the held ones, by mass.
        for (std::size_t i = 0; i < n; ++i)
          if (is_held[i])
            bond[i][d] =
              -of_free_nodes * state.mass[parting.nodes[i]] / held_mass;
      }
    return bond;
  }

  void
  CohesiveForce::share_bond_forces(const State                  &state,
                                   const Parting                &parting,
                                   const PrescribedAcceleration &prescribed,
                                   std::vector<CornerForce>     &shares) const
  {
    // Forces of the faces F = area (lambda_minus - lambda_plus), with lambda
    // one vector per node, are the smallest (in the mean over the area) that
    // balance the bond forces. For two nodes that is a share by area.
    const std::size_t   n = parting.nodes.size();
    std::vector<double> matrix(n * n, 0.);
    auto                lambda   = bond_forces(state, parting, prescribed);
    const auto          position = [&](const NodeIndex node) {
      return std::find(parting.nodes.begin(), parting.nodes.end(), node) -
             parting.nodes.begin();
    };
    const auto ends = [&](const Opening &opening) {
      const CohesiveBatch &batch =
        cohesive_faces.batches[opening.index / batch_size];
      const unsigned int lane = opening.index % batch_size;
      return std::array<std::size_t, 2>{
        {static_cast<std::size_t>(position(batch.minus[opening.corner][lane])),
         static_cast<std::size_t>(position(batch.plus[opening.corner][lane]))}};
    };
    const auto area = [&](const Opening &opening) {
      return cohesive_faces.batches[opening.index / batch_size]
        .area[opening.index % batch_size];
    };
    for (const Opening &opening : parting.openings)
      {
        const auto [minus, plus] = ends(opening);
        matrix[minus * n + minus] += area(opening);
        matrix[plus * n + plus] += area(opening);
        matrix[minus * n + plus] -= area(opening);
        matrix[plus * n + minus] -= area(opening);
      }

    // Only differences of lambda count: that of node 0 is zero. The rest is a
    // symmetric positive definite system, solved by elimination.
    for (std::size_t k = 1; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i)
        {
          const double factor = matrix[i * n + k] / matrix[k * n + k];
          for (std::size_t j = k; j < n; ++j)
            matrix[i * n + j] -= factor * matrix[k * n + j];
          lambda[i] -= factor * lambda[k];
        }
    for (std::size_t i = n - 1; i > 0; --i)
      {
        for (std::size_t j = i + 1; j < n; ++j)
          lambda[i] -= matrix[i * n + j] * lambda[j];
        lambda[i] = (1 / matrix[i * n + i]) * lambda[i];
      }
    lambda[0] = {{0, 0, 0}};

    for (const Opening &opening : parting.openings)
      {
        const auto [minus, plus] = ends(opening);
        shares.push_back(
          {opening, area(opening) * (lambda[minus] - lambda[plus])});
      }
  }

  void
  CohesiveForce::hold(State             &state,
                      const CornerForce *first,
                      const CornerForce *last)
  {
    const std::uint32_t  index = first->opening.index;
    CohesiveBatch       &batch = cohesive_faces.batches[index / batch_size];
    const unsigned int   lane  = index % batch_size;
    const FaceKinematics kinematics(batch, state);
    const FaceForces     before = face_forces(batch, kinematics, quadrature);

    // In the frame of the face. Corners that are still bonded are given the
    // mean of the others: their own share will be a correction of that.
    std::array<Vector3<double>, 3> forces{};
    Vector3<double>                mean = {{0, 0, 0}};
    for (auto share = first; share != last; ++share)
      {
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            forces[share->opening.corner][i] +=
              kinematics.frame[i][d][lane] * share->force[d];
        mean += (1. / (last - first)) * forces[share->opening.corner];
      }
    for (unsigned int c = 0; c < 3; ++c)
      if (batch.minus[c][lane] == batch.plus[c][lane])
        forces[c] = mean;

    // The functions 4 N_c - 1 are dual to the N_c: each loads its own corner
    // alone.
    const double       area = batch.area[lane];
    const FaceStrength strength =
      strengths.strength(cohesive_faces.infos[index].face);
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        Vector3<double> more = {{0, 0, 0}}, jump;
        for (unsigned int c = 0; c < 3; ++c)
          more += (3 / area * (4 * quadrature.shape[q][c] - 1)) * forces[c];
        const auto jumps = kinematics.jump_at(quadrature, q);
        for (unsigned int d = 0; d < dim; ++d)
          jump[d] = jumps[d][lane];

        auto         point  = get_point(batch, q, lane);
        const double slope  = batch.constants.stiffness[lane];
        const double weight = quadrature.weight[q] * area;
        batch.initial[lane] +=
          weight * hold_traction(point, jump, more, strength, slope);
        set_point(batch, q, lane, point);
      }

    const FaceForces after = face_forces(batch, kinematics, quadrature);
    for (unsigned int c = 0; c < 3; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        {
          state.force[batch.minus[c][lane]][d] +=
            after.minus[c][d][lane] - before.minus[c][d][lane];
          state.force[batch.plus[c][lane]][d] +=
            after.plus[c][d][lane] - before.plus[c][d][lane];
        }
  }
} // namespace rift
