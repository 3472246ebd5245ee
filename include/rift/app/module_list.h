#ifndef rift_app_module_list_h
#define rift_app_module_list_h

#include <rift/app/body.h>
#include <rift/app/parameters.h>
#include <rift/contact/contact.h>
#include <rift/rigid/rigid_bodies.h>
#include <rift/solid/solid.h>

#include <memory>

namespace rift
{
  /**
   * The modules with a subsection of their own in the .prm, in the order of
   * doc/parameters.md. To add one is to add a line here.
   */
  std::vector<std::unique_ptr<ModuleParameters>>
  module_parameters();

  /** The physics of a scene. */
  struct Modules
  {
    /** In the order in which they act. */
    std::vector<std::unique_ptr<Module>> list;

    /** Those of them that output looks at; null where a scene has none. */
    Solid       *solid        = nullptr;
    Fracture    *fracture     = nullptr;
    Contact     *contact      = nullptr;
    RigidBodies *rigid_bodies = nullptr;

    /** All modules, in the order in which they act. */
    auto
    begin() const
    {
      return list.begin();
    }

    /** One past the last module. */
    auto
    end() const
    {
      return list.end();
    }
  };

  /**
   * Makes the modules that a scene needs and no others. Collective.
   *
   * @param body must outlive them.
   * @param mesh of rank 0 counts.
   */
  Modules
  make_modules(const Parameters &parameters, Body &body, const MeshData &mesh);
} // namespace rift

#endif
