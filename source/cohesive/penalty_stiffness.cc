#include <rift/cohesive/penalty_stiffness.h>
#include <rift/mesh/mesh_data.h>
#include <rift/solid/cell_frequency.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    /**
     * Of a matrix without negative entries, from above: for any vector x > 0 no
     * eigenvalue exceeds the largest (A x)_i / x_i (Collatz and Wielandt). The
     * powers of A bring x near the eigenvector.
     */
    double
    largest_eigenvalue(
      const std::array<std::array<double, n_corners>, n_corners> &matrix)
    {
      constexpr unsigned int        n_iterations = 8;
      std::array<double, n_corners> x;
      x.fill(1);
      double bound = 0;
      for (unsigned int iteration = 0; iteration < n_iterations; ++iteration)
        {
          std::array<double, n_corners> product{};
          bound = 0;
          for (unsigned int i = 0; i < n_corners; ++i)
            {
              for (unsigned int j = 0; j < n_corners; ++j)
                product[i] += matrix[i][j] * x[j];
              // Corners without any face have nothing to do with the others.
              if (product[i] > 0)
                bound = std::max(bound, product[i] / x[i]);
            }
          if (bound > 0)
            for (unsigned int i = 0; i < n_corners; ++i)
              x[i] = product[i] / bound;
        }
      return bound;
    }
  } // namespace

  PenaltyStiffness
  stable_penalty_stiffness(const Topology              &topology,
                           const ReferenceCellData     &reference,
                           std::vector<StiffnessMatrix> stiffnesses,
                           std::vector<double>          densities,
                           const double                 frequency_limit)
  {
    return [&topology,
            &reference,
            stiffnesses = std::move(stiffnesses),
            densities   = std::move(densities),
            frequency_limit](const FaceIndex face) {
      // A corner of mass m moves against the face with a stiffness of
      // k area / 3 on either side, hence omega^2 = 2 k area / (3 m). Three such
      // faces at a corner take what the cell itself leaves of the limit.
      double smallest = std::numeric_limits<double>::max();
      for (const CellIndex cell : topology.faces[face].cells)
        {
          const auto  &batch    = reference[cell / batch_size];
          const auto   lane     = cell % batch_size;
          const auto   material = topology.material(cell);
          const double mass =
            densities[material] * batch.volume[lane] / n_corners;
          const double of_cell =
            largest_frequency_squared(batch,
                                      lane,
                                      stiffnesses[material],
                                      densities[material]);
          smallest = std::min(smallest, mass * (frequency_limit - of_cell) / 3);
        }
      return 1.5 * smallest / reference_area(topology, reference, face);
    };
  }

  IntrinsicPenalty::IntrinsicPenalty(
    const Topology                        &topology,
    const ReferenceCellData               &reference,
    const State                           &state,
    const Penalty                         &penalty,
    const std::vector<MaterialParameters> &materials,
    const std::vector<StiffnessMatrix>    &stiffnesses)
    : topology(topology)
    , reference(reference)
    , state(state)
  {
    for (std::size_t i = 0; i < materials.size(); ++i)
      {
        double value = materials[i].breakable ? penalty.value : 0;
        if (penalty.is_multiple && materials[i].breakable)
          value *= mean_youngs_modulus(stiffnesses[i]);
        if (!std::isfinite(value))
          throw ParameterError("Fracture",
                               "Cohesive penalty",
                               "this is too large for a number.");
        sides.push_back({value, materials[i].density});
      }
  }

  double
  IntrinsicPenalty::operator()(const FaceIndex face) const
  {
    const Face &f        = topology.faces[face];
    double      shortest = std::numeric_limits<double>::max();
    for (unsigned int c = 0; c < 3; ++c)
      {
        const auto corner = [&](const unsigned int i) {
          return state
            .reference[topology.node(f.cells[0],
                                     face_corners[f.local_faces[0]][i % 3])]
            .vector();
        };
        shortest = std::min(shortest, norm(corner(c + 1) - corner(c)));
      }
    return std::min(sides[topology.material(f.cells[0])].penalty,
                    sides[topology.material(f.cells[1])].penalty) /
           shortest;
  }

  double
  IntrinsicPenalty::frequency_squared(const CellIndex cell) const
  {
    // Since |u+ - u-|^2 <= 2 (|u+|^2 + |u-|^2), each side of a face has at most
    // a stiffness of its own, of twice the slope: for each component the matrix
    // k area / 6 (1 + delta) over the corners of the face.
    const double mass = sides[topology.material(cell)].density *
                        reference[cell / batch_size].volume[cell % batch_size] /
                        n_corners;
    std::array<std::array<double, n_corners>, n_corners> matrix{};
    for (unsigned int local = 0; local < n_corners; ++local)
      {
        const FaceIndex face = topology.cell_faces[cell][local];
        if (face == invalid_index)
          continue;
        const double of_face =
          (*this)(face)*reference_area(topology, reference, face) / (6 * mass);
        for (const unsigned int i : face_corners[local])
          for (const unsigned int j : face_corners[local])
            matrix[i][j] += i == j ? 2 * of_face : of_face;
      }
    return largest_eigenvalue(matrix);
  }
} // namespace rift
