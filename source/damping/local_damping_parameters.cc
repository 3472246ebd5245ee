#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/damping/local_damping.h>
#include <rift/damping/local_damping_parameters.h>

namespace rift
{
  void
  LocalDampingParameters::declare(dealii::ParameterHandler &prm) const
  {
    declare_number(prm,
                   "Coefficient",
                   coefficient,
                   "Share of the out-of-balance force on a node that acts "
                   "against its velocity, component by component; 0: no "
                   "damping. Quasi-static problems take 0.5 to 0.8, waves "
                   "none. Units: 1.");
  }

  void
  LocalDampingParameters::parse(const dealii::ParameterHandler &prm)
  {
    coefficient = prm.get_double("Coefficient");
  }

  void
  LocalDampingParameters::check() const
  {
    if (!(coefficient >= 0 && coefficient < 1))
      throw ParameterError(section(),
                           "Coefficient",
                           "this must be 0 or more and less than 1. "
                           "Quasi-static problems take 0.5 to 0.8.");
  }

  std::unique_ptr<Module>
  LocalDampingParameters::make(
    Discretization                        &body,
    const std::vector<MaterialParameters> &materials) const
  {
    return coefficient > 0 ? std::make_unique<LocalDamping>(body.topology,
                                                            materials,
                                                            coefficient) :
                             nullptr;
  }
} // namespace rift
