#include <rift/cohesive/cohesive_force.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>

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
  CohesiveForce::apply(const TopologyChange &change)
  {
    std::vector<VertexIndex> vertices;
    for (const NodeSplit &split : change.splits)
      {
        vertices.push_back(topology.node_vertices[split.parts[0]]);
        Parting parting;
        parting.nodes       = split.parts;
        const auto position = [&split](const NodeIndex node) {
          return static_cast<std::size_t>(
            std::find(split.parts.begin(), split.parts.end(), node) -
            split.parts.begin());
        };
        for_each_cut_face(
          vertices.back(),
          [&](const FaceIndex    face,
              const unsigned int corner,
              const NodeIndex    minus,
              const NodeIndex    plus) {
            // Another node at the same vertex may have split
            // as well.
            const std::size_t m = position(minus);
            const std::size_t p = position(plus);
            if (m != p && m < split.parts.size() && p < split.parts.size())
              parting.openings.push_back(
                {face, static_cast<std::uint8_t>(corner), m, p});
          });
        partings.push_back(std::move(parting));
      }
    update_nodes(vertices);
  }

  void
  CohesiveForce::update_nodes(const std::vector<VertexIndex> &vertices)
  {
    for (const VertexIndex vertex : vertices)
      for_each_cut_face(vertex,
                        [this](const FaceIndex face,
                               const unsigned int,
                               const NodeIndex,
                               const NodeIndex) {
                          if (index_of_face[face] != invalid_index)
                            update_face(face);
                        });
  }

  void
  CohesiveForce::update_face(const FaceIndex index)
  {
    const std::uint32_t i     = index_of_face[index];
    CohesiveBatch      &batch = cohesive_faces.batches[i / batch_size];
    const Face         &face  = topology.faces[index];
    for (unsigned int c = 0; c < 3; ++c)
      {
        const unsigned int corner      = face_corners[face.local_faces[0]][c];
        const VertexIndex  vertex      = topology.vertex(face.cells[0], corner);
        batch.minus[c][i % batch_size] = topology.node(face.cells[0], corner);
        batch.plus[c][i % batch_size] =
          topology.node(face.cells[1],
                        topology.corner_at_vertex(face.cells[1], vertex));
      }
  }

  void
  CohesiveForce::start_all(const State &state)
  {
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.face_states[face] != FaceState::intact &&
          topology.needs_face(face))
        activate(face, state, 1);
    for (CohesiveFaceInfo &info : cohesive_faces.infos)
      info.start_time = 0;
  }

  void
  CohesiveForce::activate(const FaceIndex index,
                          const State    &state,
                          const double    share)
  {
    const std::size_t  i    = cohesive_faces.size();
    const unsigned int lane = i % batch_size;
    if (lane == 0)
      {
        // Lanes without a face are triangles of no area that never open.
        CohesiveBatch empty{};
        empty.edges[0][0] = empty.edges[1][1] = broadcast(1);
        empty.constants.stiffness             = broadcast(1);
        empty.memory                          = invalid_index;
        cohesive_faces.batches.push_back(empty);
      }
    index_of_face[index] = static_cast<std::uint32_t>(i);
    cohesive_faces.infos.push_back({index, state.time, -1, share});
    ++event_counter;

    CohesiveBatch &batch = cohesive_faces.batches.back();
    batch.n_faces        = lane + 1;
    update_face(index);
    for (unsigned int e = 0; e < 2; ++e)
      for (unsigned int d = 0; d < dim; ++d)
        batch.edges[e][d][lane] = state.reference[batch.minus[e + 1][lane]][d] -
                                  state.reference[batch.minus[0][lane]][d];
    const FaceStrength       strength  = strength_of(cohesive_faces.infos[i]);
    CohesiveConstants<Simd> &constants = batch.constants;
    batch.area[lane]          = reference_area(topology, reference, index);
    batch.cohesion[lane]      = strength.cohesion;
    constants.stiffness[lane] = slope(index);
    constants.tensile_strength[lane]   = strength.tensile_strength;
    constants.tan_friction_angle[lane] = strength.tan_friction_angle;
    constants.residual_friction[lane]  = strength.residual_friction;
    if (batch.memory != invalid_index)
      start_points(i);
  }

  void
  CohesiveForce::make_memory(const std::size_t b)
  {
    CohesiveBatch &batch = cohesive_faces.batches[b];
    batch.memory = static_cast<std::uint32_t>(cohesive_faces.memories.size());
    CohesiveMemory memory{};
    for (auto &point : memory.points)
      point.softening = broadcast(1);
    cohesive_faces.memories.push_back(memory);
    for (unsigned int lane = 0; lane < batch.n_faces; ++lane)
      start_points(b * batch_size + lane);
  }

  void
  CohesiveForce::start_points(const std::size_t i)
  {
    const CohesiveBatch &batch = cohesive_faces.batches[i / batch_size];
    const unsigned int   lane  = i % batch_size;
    const auto point = make_cohesive_point(strength_of(cohesive_faces.infos[i]),
                                           batch.constants.stiffness[lane],
                                           part_of_fracture);
    for (unsigned int q = 0; q < n_face_points; ++q)
      set_point(cohesive_faces.memories[batch.memory], q, lane, point);
  }

  std::vector<OpeningCorner>
  CohesiveForce::hold_partings(State                        &state,
                               const PrescribedAcceleration &prescribed)
  {
    std::vector<OpeningCorner> shares;
    for (const Parting &parting : partings)
      {
        auto bond = bond_forces(state, parting, prescribed);
        for (std::size_t i = 0; i < bond.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            state.force[parting.nodes[i]][d] += bond[i][d];
        share_bond_forces(parting, std::move(bond), shares);
      }
    partings.clear();
    return shares;
  }

  void
  CohesiveForce::start_openings(const State               &state,
                                std::vector<OpeningCorner> corners)
  {
    // An order that does not depend on where they come from.
    std::sort(corners.begin(),
              corners.end(),
              [](const OpeningCorner &a, const OpeningCorner &b) {
                return std::make_pair(a.face, a.corner) <
                       std::make_pair(b.face, b.corner);
              });
    for (auto first = corners.begin(); first != corners.end();)
      {
        auto last = first;
        while (last != corners.end() && last->face == first->face)
          ++last;
        if (index_of_face[first->face] == invalid_index)
          {
            activate(first->face,
                     state,
                     share_at_start(state, &*first, &*first + (last - first)));
            if (cohesive_faces.batches.back().memory == invalid_index)
              make_memory(cohesive_faces.batches.size() - 1);
          }
        hold(state, &*first, &*first + (last - first));
        first = last;
      }
  }

  double
  CohesiveForce::share_at_start(const State         &state,
                                const OpeningCorner *first,
                                const OpeningCorner *last) const
  {
    if (least_share == 1)
      return 1;
    Vector3<double> traction = {{0, 0, 0}};
    for (auto corner = first; corner != last; ++corner)
      traction += corner->force;
    traction = (3 / (reference_area(topology, reference, first->face) *
                     (last - first))) *
               traction;
    const Vector3<double> normal =
      current_normal(topology, state, topology.faces[first->face]);
    const double normal_stress = dot(traction, normal);
    const double share =
      strengths.strength(first->face)
        .share_of(normal_stress, norm(traction - normal_stress * normal));
    return std::clamp(share, least_share, 1.);
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
  CohesiveForce::share_bond_forces(const Parting               &parting,
                                   std::vector<Vector3<double>> lambda,
                                   std::vector<OpeningCorner>  &shares) const
  {
    // Forces of the faces F = area (lambda_minus - lambda_plus), with lambda
    // one vector per node, are the smallest (in the mean over the area) that
    // balance the bond forces. For two nodes that is a share by area.
    const std::size_t   n = parting.nodes.size();
    std::vector<double> matrix(n * n, 0.);
    for (const Opening &opening : parting.openings)
      {
        const auto [face, corner, minus, plus] = opening;
        const double area = reference_area(topology, reference, face);
        matrix[minus * n + minus] += area;
        matrix[plus * n + plus] += area;
        matrix[minus * n + plus] -= area;
        matrix[plus * n + minus] -= area;
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
      shares.push_back({opening.face,
                        opening.corner,
                        reference_area(topology, reference, opening.face) *
                          (lambda[opening.minus] - lambda[opening.plus])});
  }

  void
  CohesiveForce::hold(const State         &state,
                      const OpeningCorner *first,
                      const OpeningCorner *last)
  {
    const std::uint32_t index = index_of_face[first->face];
    CohesiveBatch      &batch = cohesive_faces.batches[index / batch_size];
    const unsigned int  lane  = index % batch_size;
    // Let go of: see release_distant_faces().
    if (batch.area[lane] == 0)
      return;
    CohesiveMemory      &memory = cohesive_faces.memories[batch.memory];
    const FaceKinematics kinematics(batch, state);

    // In the frame of the face. Corners that are still bonded are given the
    // mean of the others: their own share will be a correction of that.
    std::array<Vector3<double>, 3> forces{};
    Vector3<double>                mean = {{0, 0, 0}};
    for (auto share = first; share != last; ++share)
      {
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            forces[share->corner][i] +=
              kinematics.frame[i][d][lane] * share->force[d];
        mean += (1. / (last - first)) * forces[share->corner];
      }
    for (unsigned int c = 0; c < 3; ++c)
      if (batch.minus[c][lane] == batch.plus[c][lane])
        forces[c] = mean;

    // The functions 4 N_c - 1 are dual to the N_c: each loads its own corner
    // alone.
    const double       area     = batch.area[lane];
    const FaceStrength strength = strength_of(cohesive_faces.infos[index]);
    for (unsigned int q = 0; q < n_face_points; ++q)
      {
        Vector3<double> more = {{0, 0, 0}}, jump;
        for (unsigned int c = 0; c < 3; ++c)
          more += (3 / area * (4 * quadrature.shape[q][c] - 1)) * forces[c];
        const auto jumps = kinematics.jump_at(quadrature, q);
        for (unsigned int d = 0; d < dim; ++d)
          jump[d] = jumps[d][lane];

        auto         point     = get_point(memory, q, lane);
        const double stiffness = batch.constants.stiffness[lane];
        memory.given[lane] +=
          quadrature.weight[q] * area *
          hold_traction(point, jump, more, strength, stiffness);
        set_point(memory, q, lane, point);
      }
  }
} // namespace rift
