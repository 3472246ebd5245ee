#ifndef rift_loading_body_force_parameters_h
#define rift_loading_body_force_parameters_h

#include <rift/module/module_parameters.h>

namespace rift
{
  /** Subsection `Body force`. */
  class BodyForceParameters : public ModuleParameters
  {
  public:
    std::string
    section() const override
    {
      return "Body force";
    }

    std::string
    purpose() const override
    {
      return "What acts on every point of the body.";
    }

    void
    declare(dealii::ParameterHandler &prm) const override;

    void
    parse(const dealii::ParameterHandler &prm) override;

    /** Null without gravity. */
    std::unique_ptr<Module>
    make(Discretization                        &body,
         const std::vector<MaterialParameters> &materials) const override;

  private:
    /** Acceleration of gravity, m/s^2. */
    Vector3<double> gravity = {{0, 0, 0}};
  };
} // namespace rift

#endif
