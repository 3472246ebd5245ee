#ifndef rift_io_output_parameters_h
#define rift_io_output_parameters_h

#include <rift/base/parameter_file.h>
#include <rift/discretization/field_list.h>

#include <string>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /** Subsection `Output` of the .prm. */
  struct OutputParameters
  {
    /** Where results go, relative to the folder in which rift is started. */
    std::string directory = "results";

    /** Time between two states in solid.pvd and fracture.pvd, s; 0: none. */
    double solution_interval = 0;

    /** Time between two rows of probes.csv and energy.csv, s; 0: each step. */
    double history_interval = 0;

    /** What is in solid.pvd and fracture.pvd. */
    FieldSelection fields;

    /** Whether results of an older run may be replaced. */
    bool overwrite = false;

    /** Ranks that write one file of a state together. */
    int ranks_per_file = 64;

    /** Declares the entries of subsection Output. */
    static void
    declare(dealii::ParameterHandler &prm);

    /** Reads subsection Output. */
    static OutputParameters
    parse(dealii::ParameterHandler &prm);

    /** Throws ParameterError for an empty directory, a negative interval or a
     * field that does not exist. */
    void
    check() const;
  };

  /** Subsection `Probe NAME`: one column of probes.csv. */
  struct ProbeParameters
  {
    /** A component of a field; see FieldList. */
    struct Component
    {
      /** Name, unit and place of the field, and which of its components. */
      std::string   name     = "velocity";
      std::string   unit     = "m/s";
      FieldLocation location = FieldLocation::node;
      std::size_t   index    = 0;
    };

    /** The column, and what it shows if no material is given. */
    std::string name;
    Component   field;

    /** Force on the rigid bodies of this material. */
    std::string material;

    /** Average over this surface; empty: at `point`. */
    std::string boundary;

    /** A point of the undeformed body, m. */
    Vector3<double> point = {{0, 0, 0}};

    /** Declares the entries of subsection `Probe NAME`. */
    static void
    declare(dealii::ParameterHandler &prm, const std::string &name);

    /**
     * Reads subsection `Probe NAME`. Throws ParameterError if it has no place:
     * a material for forces, else a boundary or a point.
     */
    static ProbeParameters
    parse(dealii::ParameterHandler &prm,
          const std::string        &name,
          const ParameterFile      &scene);

    /** Places that have no effect beside another. */
    std::vector<InertEntries>
    inert_entries() const;
  };
} // namespace rift

#endif
