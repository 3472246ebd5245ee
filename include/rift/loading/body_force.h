#ifndef rift_loading_body_force_h
#define rift_loading_body_force_h

#include <rift/discretization/state.h>
#include <rift/loading/loading_parameters.h>

namespace rift
{
  /** Gravity; not constructed where there is none. */
  class BodyForce
  {
  public:
    explicit BodyForce(const BodyForceParameters &parameters)
      : gravity(parameters.gravity)
    {
    }

    static bool
    is_needed(const BodyForceParameters &parameters)
    {
      return dot(parameters.gravity, parameters.gravity) > 0;
    }

    void
    add_to(State &state) const
    {
      for (std::size_t i = 0; i < state.n_nodes(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          state.force[i][d] += state.mass[i] * gravity[d];
    }

    /** Work since the start, J: that of the displacements. */
    double
    work(const State &state) const
    {
      double sum = 0;
      for (std::size_t i = 0; i < state.n_nodes(); ++i)
        sum += state.mass[i] * dot(gravity, state.displacement[i].vector());
      return sum;
    }

  private:
    const Vector3<double> gravity;
  };
} // namespace rift

#endif
