#ifndef rift_module_module_parameters_h
#define rift_module_module_parameters_h

#include <rift/base/parameter_errors.h>
#include <rift/material/material_parameters.h>
#include <rift/module/module.h>

#include <memory>

namespace rift
{
  /**
   * The subsection of the .prm that belongs to a module, and the module that it
   * asks for. A module with parameters derives one class from this and stands
   * in the list of module_parameters() (app/module_list.h); nothing else needs
   * to know of it.
   */
  class ModuleParameters
  {
  public:
    virtual ~ModuleParameters() = default;

    /** Name of the subsection. */
    virtual std::string
    section() const = 0;

    /** A sentence for doc/parameters.md: what the subsection is for. */
    virtual std::string
    purpose() const = 0;

    /** Declares the entries; the subsection has been entered. */
    virtual void
    declare(dealii::ParameterHandler &prm) const = 0;

    /** Reads the entries; the subsection has been entered. */
    virtual void
    parse(const dealii::ParameterHandler &prm) = 0;

    /** @throws ParameterError for what cannot be meant. */
    virtual void
    check() const
    {
    }

    /** Entries without effect at these values. */
    virtual std::vector<InertEntries>
    inert_entries() const
    {
      return {};
    }

    /** The module; null if the scene does not need it.
     * @param materials by material index. */
    virtual std::unique_ptr<Module>
    make(Discretization                        &body,
         const std::vector<MaterialParameters> &materials) const = 0;
  };
} // namespace rift

#endif
