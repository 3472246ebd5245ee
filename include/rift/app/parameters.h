#ifndef rift_app_parameters_h
#define rift_app_parameters_h

#include <rift/cohesive/cohesive_parameters.h>
#include <rift/contact/contact_parameters.h>
#include <rift/io/checkpoint_parameters.h>
#include <rift/io/output_parameters.h>
#include <rift/loading/loading_parameters.h>
#include <rift/material/material_parameters.h>
#include <rift/mesh/mesh_parameters.h>
#include <rift/module/module_parameters.h>
#include <rift/time_integration/time_parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace rift
{
  /** All that a .prm says, in the order of its file. */
  struct Parameters
  {
    /** The entry Title; copied to the results. */
    std::string title;

    /** The subsections, with those that have a name in the order of the
     * file. */
    MeshParameters                  mesh;
    std::vector<MaterialParameters> materials;
    std::vector<BoundaryParameters> boundaries;
    CohesiveParameters              cohesive;
    ContactParameters               contact;
    TimeParameters                  time;
    OutputParameters                output;
    CheckpointParameters            checkpoint;
    std::vector<ProbeParameters>    probes;

    /** Of the modules that have a subsection of their own. */
    std::vector<std::shared_ptr<const ModuleParameters>> modules;

    /** The same as the text of a .prm; see used_parameters(). */
    std::string used_text;
  };

  /** The first words of the subsections that a scene names itself. */
  std::vector<std::string>
  section_kinds();

  /** The names that a scene gives to its subsections of each kind. */
  struct SectionNames
  {
    /** Of subsections Material, Boundary and Probe, in the order of the
     * file. */
    std::vector<std::string> materials;
    std::vector<std::string> boundaries;
    std::vector<std::string> probes;
  };

  /** Declares everything that a scene with these names may set. */
  void
  declare_parameters(dealii::ParameterHandler &prm, const SectionNames &names);

  /**
   * Reads and checks a scene. Each of `overrides` is a text
   * `Section/Name=value` that takes the place of what the file says, as if it
   * stood there: paths in it start from the folder of the scene.
   *
   * Throws InputError, with file, line, the value and what to do, for whatever
   * is wrong without looking into the mesh and the tables.
   */
  Parameters
  read_parameters(const std::string              &prm_file,
                  const std::vector<std::string> &overrides = {});

  /**
   * The text of a .prm with all values as used: those of the scene, of the
   * overrides and the defaults, without what has no effect. Paths are
   * absolute, so that it can be read from anywhere and then gives the same
   * parameters again.
   */
  std::string
  used_parameters(const Parameters &parameters);

  /** Sentences about what may not be meant, for warnings. */
  std::vector<std::string>
  warnings(const Parameters &parameters);

  /** Says in a few lines what a scene is, for `rift --validate`. */
  void
  print_summary(std::ostream &out, const Parameters &parameters);
} // namespace rift

#endif
