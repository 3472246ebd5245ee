#include <rift/cohesive/cohesive_faces.h>

#include <cmath>

namespace rift
{
  FaceQuadrature::FaceQuadrature()
  {
    shape[0].fill(1. / 3.);
    weight[0]          = 9. / 40.;
    const double root  = std::sqrt(15.);
    const double at[2] = {(6 - root) / 21, (6 + root) / 21};
    const double w[2]  = {(155 - root) / 1200, (155 + root) / 1200};
    for (unsigned int orbit = 0; orbit < 2; ++orbit)
      for (unsigned int corner = 0; corner < 3; ++corner)
        {
          const unsigned int q = 1 + 3 * orbit + corner;
          shape[q].fill(at[orbit]);
          shape[q][corner] = 1 - 2 * at[orbit];
          weight[q]        = w[orbit];
        }
  }

  namespace
  {
    /** Calls f(field of the batch, field of the single point). */
    template <typename SimdPoint, typename Point, typename Function>
    void
    for_each_field(SimdPoint &a, Point &b, const Function &f)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          f(a.offset[d], b.offset[d]);
          f(a.traction[d], b.traction[d]);
        }
      f(a.opening, b.opening);
      f(a.slip, b.slip);
      f(a.softening, b.softening);
      f(a.cohesion, b.cohesion);
      f(a.normal_excess, b.normal_excess);
      f(a.shear_excess, b.shear_excess);
      f(a.inverse_opening, b.inverse_opening);
      f(a.inverse_slip, b.inverse_slip);
      f(a.debt, b.debt);
      f(a.given_opening, b.given_opening);
      f(a.given_sliding, b.given_sliding);
    }
  } // namespace

  CohesivePoint<double>
  get_point(const CohesiveMemory &memory,
            const unsigned int    point,
            const unsigned int    lane)
  {
    CohesivePoint<double> result;
    for_each_field(
      memory.points[point],
      result,
      [lane](const Simd &field, double &value) { value = field[lane]; });
    return result;
  }

  void
  set_point(CohesiveMemory              &memory,
            const unsigned int           point,
            const unsigned int           lane,
            const CohesivePoint<double> &value)
  {
    for_each_field(memory.points[point],
                   value,
                   [lane](Simd &field, const double v) { field[lane] = v; });
  }
} // namespace rift
