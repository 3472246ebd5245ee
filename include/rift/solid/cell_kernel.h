#ifndef rift_solid_cell_kernel_h
#define rift_solid_cell_kernel_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/material/elasticity.h>

/**
 * @file
 *
 * The arithmetic of one batch of eight cells: displacement gradient, strain,
 * stress. Used by the internal force, the insertion check, the damping, the
 * ledger and the output, so that each formula stands once.
 */
namespace rift
{
  /**
   * Gradient by the reference position of a nodal field, G[i][d] = dv_i/dX_d
   * (doc/theory.md, eq. 1): constant in each cell.
   */
  inline Matrix3<Simd>
  gradient(const ReferenceBatch           &reference,
           const BatchNodes               &nodes,
           const std::vector<NodalVector> &field)
  {
    const Vector3<Simd> origin = gather(field.data(), nodes.corner[0]);
    Matrix3<Simd>       result{};
    for (unsigned int c = 1; c < n_corners; ++c)
      {
        const Vector3<Simd> difference =
          gather(field.data(), nodes.corner[c]) - origin;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int d = 0; d < dim; ++d)
            result[i][d] += difference[i] * reference.gradients[c - 1][d];
      }
    return result;
  }

  /**
   * Green-Lagrange strain from the displacement gradient,
   * E = (H + H^T + H^T H)/2 (eq. 2): exactly zero at rest, and without the
   * cancellation of F^T F - I.
   */
  template <typename Number>
  inline SymmetricTensor<Number>
  green_lagrange_strain(const Matrix3<Number> &h)
  {
    const auto column_product = [&h](const unsigned int i,
                                     const unsigned int j) {
      return h[0][i] * h[0][j] + h[1][i] * h[1][j] + h[2][i] * h[2][j];
    };
    return {{h[0][0] + .5 * column_product(0, 0),
             h[1][1] + .5 * column_product(1, 1),
             h[2][2] + .5 * column_product(2, 2),
             .5 * (h[1][2] + h[2][1] + column_product(1, 2)),
             .5 * (h[0][2] + h[2][0] + column_product(0, 2)),
             .5 * (h[0][1] + h[1][0] + column_product(0, 1))}};
  }

  /** Double contraction A : B of two symmetric tensors. */
  template <typename Number>
  inline Number
  contract(const SymmetricTensor<Number> &a, const SymmetricTensor<Number> &b)
  {
    const Number diagonal     = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const Number off_diagonal = a[3] * b[3] + a[4] * b[4] + a[5] * b[5];
    return diagonal + 2. * off_diagonal;
  }

  /** First Piola-Kirchhoff stress P = F S = S + H S (eq. 5). */
  template <typename Number>
  inline Matrix3<Number>
  first_piola_kirchhoff(const Matrix3<Number>         &h,
                        const SymmetricTensor<Number> &s)
  {
    Matrix3<Number> p;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        p[i][d] = s[voigt[i][d]] +
                  (h[i][0] * s[voigt[0][d]] + h[i][1] * s[voigt[1][d]] +
                   h[i][2] * s[voigt[2][d]]);
    return p;
  }

  /** Determinant of F = I + H, the ratio of the volumes. */
  template <typename Number>
  inline Number
  volume_ratio(const Matrix3<Number> &h)
  {
    Matrix3<Number> f = h;
    for (unsigned int d = 0; d < dim; ++d)
      f[d][d] = f[d][d] + 1.;
    return determinant(f);
  }

  /**
   * Adds -V P grad N_a to the force of corner a of each of the eight cells
   * (eq. 6), cell by cell and in each cell corner by corner.
   */
  inline void
  scatter_stress_force(const ReferenceBatch     &reference,
                       const BatchNodes         &nodes,
                       const Matrix3<Simd>      &p,
                       std::vector<NodalVector> &force)
  {
    std::array<std::array<Row, batch_size>, n_corners> rows;
    Vector3<Simd>                                      sum{};
    for (unsigned int c = 1; c < n_corners; ++c)
      {
        const Vector3<Simd> f =
          (-reference.volume) * (p * reference.gradients[c - 1]);
        sum -= f;
        rows[c] = transpose_to_rows(f);
      }
    rows[0] = transpose_to_rows(sum);
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      for (unsigned int c = 0; c < n_corners; ++c)
        force[nodes.corner[c][lane]].row() += rows[c][lane];
  }
} // namespace rift

#endif
