#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/loading/body_force.h>
#include <rift/loading/body_force_parameters.h>

namespace rift
{
  void
  BodyForceParameters::declare(dealii::ParameterHandler &prm) const
  {
    declare_vector(prm,
                   "Gravity",
                   gravity,
                   "Acceleration of gravity along x, y, z. Units: m/s^2.");
  }

  void
  BodyForceParameters::parse(const dealii::ParameterHandler &prm)
  {
    gravity = get_vector(prm, "Gravity");
  }

  std::unique_ptr<Module>
  BodyForceParameters::make(Discretization &,
                            const std::vector<MaterialParameters> &) const
  {
    return dot(gravity, gravity) > 0 ? std::make_unique<BodyForce>(gravity) :
                                       nullptr;
  }
} // namespace rift
