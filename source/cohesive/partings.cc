#include <rift/base/check.h>
#include <rift/cohesive/partings.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>

namespace rift
{
  std::vector<CutCorner>
  cut_corners_at(const Topology &topology, const VertexIndex vertex)
  {
    std::vector<CutCorner> result;
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
            result.push_back(
              {index,
               static_cast<std::uint8_t>(corner),
               topology.node(*cell, here),
               topology.node(
                 face.cells[1],
                 topology.corner_at_vertex(face.cells[1], vertex))});
          }
      }
    return result;
  }

  namespace
  {
    /** Whether forces cancel but for rounding; `scale` is that of their terms.
     * Forces that are not numbers pass. */
    bool
    cancel(const std::vector<Vector3<double>> &forces, const double scale)
    {
      Vector3<double> sum{};
      for (const Vector3<double> &force : forces)
        sum += force;
      return !(norm(sum) > 1e-12 * scale);
    }

    /** Sum of the magnitudes of forces. */
    double
    sum_of_norms(const std::vector<Vector3<double>> &forces)
    {
      double sum = 0;
      for (const Vector3<double> &force : forces)
        sum += norm(force);
      return sum;
    }

    /** What the bond forces of nodes are differences of, N. */
    double
    scale_of_bond(const State                        &state,
                  const std::vector<NodeIndex>       &nodes,
                  const std::vector<Vector3<double>> &bond)
    {
      double scale = sum_of_norms(bond);
      for (const NodeIndex node : nodes)
        scale += norm(state.force[node].vector());
      return scale;
    }
  } // namespace

  Partings::Partings(const Topology          &topology,
                     const ReferenceCellData &reference)
    : topology(topology)
    , reference(reference)
  {
  }

  void
  Partings::add(const TopologyChange &change)
  {
    for (const NodeSplit &split : change.splits)
      {
        Parting parting;
        parting.nodes       = split.parts;
        const auto position = [&split](const NodeIndex node) {
          return static_cast<std::size_t>(
            std::find(split.parts.begin(), split.parts.end(), node) -
            split.parts.begin());
        };
        for (const CutCorner &corner :
             cut_corners_at(topology, topology.node_vertices[split.parts[0]]))
          {
            // Another node at the same vertex may have split as well.
            const std::size_t m = position(corner.minus);
            const std::size_t p = position(corner.plus);
            if (m != p && m < split.parts.size() && p < split.parts.size())
              parting.openings.push_back({corner.face, corner.corner, m, p});
          }
        partings.push_back(std::move(parting));
      }
  }

  std::vector<OpeningCorner>
  Partings::hold(State &state, const PrescribedAcceleration &prescribed)
  {
    std::vector<OpeningCorner> opening_forces;
    for (const Parting &parting : partings)
      {
        const auto bond = bond_forces(state, parting, prescribed);
        rift_check(cancel(bond, scale_of_bond(state, parting.nodes, bond)));
        for (std::size_t i = 0; i < bond.size(); ++i)
          for (unsigned int d = 0; d < dim; ++d)
            state.force[parting.nodes[i]][d] += bond[i][d];
        distribute(parting, bond, opening_forces);
      }
    partings.clear();
    return opening_forces;
  }

  std::vector<Vector3<double>>
  Partings::bond_forces(const State                  &state,
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

  namespace
  {
    /**
     * Solves M x = b, where M is the Laplacian of a connected graph, of n x n
     * numbers row by row. Only differences of the x count: that of node 0 is
     * zero. The rest is a symmetric positive definite system, solved by
     * elimination.
     *
     * @param[in,out] x holds b before and x after.
     */
    void
    solve_laplacian(std::vector<double> matrix, std::vector<Vector3<double>> &x)
    {
      const std::size_t n = x.size();
      for (std::size_t k = 1; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i)
          {
            rift_check(matrix[k * n + k] > 0);
            const double factor = matrix[i * n + k] / matrix[k * n + k];
            for (std::size_t j = k; j < n; ++j)
              matrix[i * n + j] -= factor * matrix[k * n + j];
            x[i] -= factor * x[k];
          }
      for (std::size_t i = n - 1; i > 0; --i)
        {
          for (std::size_t j = i + 1; j < n; ++j)
            x[i] -= matrix[i * n + j] * x[j];
          x[i] = (1 / matrix[i * n + i]) * x[i];
        }
      x[0] = {{0, 0, 0}};
    }

    /** Whether the forces of the last corners, those of `openings`, give each
     * node its bond force but for rounding. */
    template <typename Opening>
    bool
    are_balanced(const std::vector<Opening>       &openings,
                 const std::vector<OpeningCorner> &corners,
                 std::vector<Vector3<double>>      bond,
                 const double                      scale)
    {
      auto corner =
        corners.end() - static_cast<std::ptrdiff_t>(openings.size());
      for (const Opening &opening : openings)
        {
          bond[opening.minus] -= corner->force;
          bond[opening.plus] += corner->force;
          ++corner;
        }
      for (const Vector3<double> &left : bond)
        if (norm(left) > 1e-9 * scale)
          return false;
      return true;
    }
  } // namespace

  void
  Partings::distribute(const Parting                      &parting,
                       const std::vector<Vector3<double>> &bond,
                       std::vector<OpeningCorner>         &opening_forces) const
  {
    // Forces of the faces F = area (lambda_minus - lambda_plus), with lambda
    // one vector per node, are the smallest (in the mean over the area) that
    // balance the bond forces. For two nodes that is a share by area.
    const std::size_t   n = parting.nodes.size();
    std::vector<double> matrix(n * n, 0.);
    for (const auto &[face, corner, minus, plus] : parting.openings)
      {
        const double area = reference_area(topology, reference, face);
        matrix[minus * n + minus] += area;
        matrix[plus * n + plus] += area;
        matrix[minus * n + plus] -= area;
        matrix[plus * n + minus] -= area;
      }
    std::vector<Vector3<double>> lambda = bond;
    solve_laplacian(std::move(matrix), lambda);
    for (const auto &[face, corner, minus, plus] : parting.openings)
      opening_forces.push_back({face,
                                corner,
                                reference_area(topology, reference, face) *
                                  (lambda[minus] - lambda[plus])});
    rift_check(
      are_balanced(parting.openings, opening_forces, bond, sum_of_norms(bond)));
  }
} // namespace rift
