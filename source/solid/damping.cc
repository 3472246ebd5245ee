#include <rift/solid/cell_kernel.h>
#include <rift/solid/damping.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** Inverse of F = I + H. */
    Matrix3<Simd>
    inverse_deformation_gradient(const Matrix3<Simd> &h)
    {
      Matrix3<Simd> f = h;
      for (unsigned int d = 0; d < dim; ++d)
        f[d][d] += 1.;
      return inverse(f);
    }
  } // namespace

  Damping::Damping(const Topology          &topology,
                   const ReferenceCellData &reference,
                   std::vector<double>      viscosities)
    : ModuleWithWork(topology, "viscosity", "damping")
    , topology(topology)
    , reference(reference)
    , viscosities(std::move(viscosities))
  {
  }

  void
  Damping::add_to(State &state, const Activity &activity)
  {
    forces.assign(state.n_nodes(), {});
    for (const MaterialRange &range : topology.material_ranges)
      {
        const double eta = viscosities[range.material];
        for (std::size_t b = range.begin; b < range.end && eta > 0; ++b)
          {
            if (!activity.is_awake(b))
              continue;
            const auto h =
              gradient(reference[b], topology.batches[b], state.displacement);
            const auto rate =
              gradient(reference[b], topology.batches[b], state.velocity);
            const auto inverse = inverse_deformation_gradient(h);

            // L = dF/dt F^-1, d = sym L, P = J (eta d) F^-T
            Matrix3<Simd> l{}, p{};
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                for (unsigned int k = 0; k < dim; ++k)
                  l[i][j] += rate[i][k] * inverse[k][j];
            const Simd factor = (.5 * eta) * volume_ratio(h);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                for (unsigned int k = 0; k < dim; ++k)
                  p[i][j] += factor * (l[i][k] + l[k][i]) * inverse[j][k];
            scatter_stress_force(reference[b], topology.batches[b], p, forces);
          }
      }
    for (std::size_t i = 0; i < forces.size(); ++i)
      state.force[i].row() += forces[i].row();
  }

  void
  Damping::count_work(const State &state, const double time_step)
  {
    work_done.begin_step();
    for (NodeIndex i = 0; i < forces.size(); ++i)
      work_done.add(state, i, -1. * forces[i].vector(), time_step);
  }
} // namespace rift
