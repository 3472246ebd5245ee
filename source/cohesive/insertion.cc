#include <rift/cohesive/insertion.h>
#include <rift/mesh/mesh_data.h>
#include <rift/solid/cell_kernel.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  Insertion::Insertion(const Topology          &topology,
                       const ReferenceCellData &reference,
                       const InternalForce     &internal_force,
                       const FaceStrengths     &strengths,
                       const StressBounds      &bounds)
    : topology(topology)
    , reference(reference)
    , strengths(strengths)
    , bounds(bounds)
    , stresses(topology, internal_force)
  {
  }

  std::vector<FaceIndex>
  Insertion::find_faces(const State                  &state,
                        const std::vector<CellIndex> &hot_cells)
  {
    std::vector<FaceIndex>              faces;
    std::uint32_t                       current_batch = invalid_index;
    std::array<std::uint8_t, n_corners> near{};
    for (const CellIndex cell : hot_cells)
      {
        const std::uint32_t batch = cell / batch_size;
        if (batch != current_batch)
          near = near_strength(batch, stresses.of_batch(state, batch));
        current_batch = batch;
        for (unsigned int f = 0; f < n_corners; ++f)
          {
            const FaceIndex face = topology.cell_faces[cell][f];
            if (((near[f] >> (cell % batch_size)) & 1) &&
                face != invalid_index &&
                topology.face_states[face] == FaceState::intact &&
                strengths.is_breakable(face) && breaks(state, face))
              faces.push_back(face);
          }
      }
    stresses.clear();

    // A face may have been found from both of its sides.
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  std::array<std::uint8_t, n_corners>
  Insertion::near_strength(const std::uint32_t               batch,
                           const InternalForce::BatchStress &stress) const
  {
    // Along the normals of the undeformed faces: the bound covers the difference
    // to the current ones, as long as strains are small.
    const StressBound &bound =
      *bounds.materials[topology.batch_materials[batch]];
    const Simd factor =
      bounds.factors.empty() ? broadcast(1) : bounds.factors[batch];
    const Simd     tensile_strength = bound.tensile_strength * factor;
    const Simd     cohesion         = bound.cohesion * factor;
    const Simd     strain_squared   = contract(stress.strain, stress.strain);
    const SimdMask is_large =
      strain_squared > StressBound::small_strain_squared;
    const Simd friction_under_pressure =
      bound.friction_under_pressure().at(strain_squared);
    const Matrix3<Simd> &g = reference[batch].gradients;
    const Simd           zero{};

    std::array<std::uint8_t, n_corners> result{};
    for (unsigned int f = 0; f < n_corners; ++f)
      {
        const Vector3<Simd> n =
          f > 0 ? g[f - 1] : (zero - 1.) * (g[0] + g[1] + g[2]);
        Vector3<Simd> traction;
        for (unsigned int i = 0; i < dim; ++i)
          traction[i] = stress.second[voigt[i][0]] * n[0] +
                        stress.second[voigt[i][1]] * n[1] +
                        stress.second[voigt[i][2]] * n[2];
        // n is not of unit length: all stresses times its square.
        const Simd square = dot(n, n);
        const Simd normal = dot(traction, n);
        const Simd shear_squared =
          dot(traction, traction) * square - normal * normal;
        // Friction counts in tension, too: only then is the bound convex, so
        // that the mean of two cells within it is within it.
        const Simd shear_limit =
          cohesion * square - max(bound.tan_friction_angle * normal,
                                  friction_under_pressure * normal);
        const SimdMask mask =
          (normal >= tensile_strength * square) | (shear_limit <= 0.) |
          (shear_squared >= shear_limit * shear_limit) | is_large;
        for (unsigned int lane = 0; lane < batch_size; ++lane)
          result[f] |= (mask[lane] & 1) << lane;
      }
    return result;
  }

  Matrix3<double>
  Insertion::stress(const State &state, const CellIndex cell)
  {
    const Matrix3<Simd> &p = stresses.of_batch(state, cell / batch_size).first;
    Matrix3<double>      result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        result[i][d] = p[i][d][cell % batch_size];
    return result;
  }

  bool
  Insertion::breaks(const State &state, const FaceIndex face)
  {
    const Face           &f = topology.faces[face];
    const Vector3<double> area =
      reference_area_vector(reference, f.cells[0], f.local_faces[0]);
    const std::array<Matrix3<double>, 2> of_sides = {
      {stress(state, f.cells[0]), stress(state, f.cells[1])}};
    const Vector3<double> traction =
      (.5 / norm(area)) * (of_sides[0] * area + of_sides[1] * area);

    const Vector3<double> normal = current_normal(topology, state, f);

    const double normal_stress = dot(traction, normal);
    return strengths.strength(face).is_reached(
      normal_stress,
      norm(traction - normal_stress * normal));
  }
} // namespace rift
