#ifndef rift_damping_local_damping_parameters_h
#define rift_damping_local_damping_parameters_h

#include <rift/module/module_parameters.h>

namespace rift
{
  /** Subsection `Local damping`. */
  class LocalDampingParameters : public ModuleParameters
  {
  public:
    std::string
    section() const override
    {
      return "Local damping";
    }

    std::string
    purpose() const override
    {
      return "Damping for quasi-static problems, which takes the motion out of "
             "a body and does not change its equilibrium.";
    }

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(const dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /** Null without a coefficient. */
    std::unique_ptr<Module>
    make(Discretization                        &body,
         const std::vector<MaterialParameters> &materials) const override;

  private:
    double coefficient = 0;
  };
} // namespace rift

#endif
