#ifndef rift_loading_loading_parameters_h
#define rift_loading_loading_parameters_h

#include <rift/base/parameter_errors.h>
#include <rift/base/parameter_file.h>
#include <rift/base/vector3.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /**
   * What acts on a named surface: subsection `Boundary NAME` of the .prm. Each
   * entry is the text of a function of time (an expression in t, or a .csv
   * table, whose path is already made relative to the .prm's folder); empty
   * where nothing is prescribed.
   */
  struct BoundaryParameters
  {
    /** Name of the surface. */
    std::string name;

    /** Pressure on the current surface, positive in compression, Pa. */
    std::string pressure;

    /** Components of a traction per reference area, Pa. */
    std::array<std::string, 3> traction;

    /** Prescribed components of the velocity, m/s. */
    std::array<std::string, 3> velocity;

    /** Whether pressure and traction end on a face whose piece of the body has
     * left its place; see Fragments::has_left(). */
    bool acts_while_in_place = false;

    /** Whether waves leave the body here. */
    bool absorbs = false;

    /** Declares the entries of subsection `Boundary NAME`. */
    static void
    declare(dealii::ParameterHandler &prm, const std::string &name);

    /** Reads `Boundary NAME`; `scene` tells from where paths start. */
    static BoundaryParameters
    parse(dealii::ParameterHandler &prm,
          const std::string        &name,
          const ParameterFile      &scene);

    /**
     * Throws ParameterError for a boundary without any condition, a component
     * with both traction and velocity, a pressure with all three velocities, a
     * velocity on an absorbing boundary, and a table that does not exist.
     */
    void
    check() const;

    /** Entries without effect at these values. */
    std::vector<InertEntries>
    inert_entries() const;
  };
} // namespace rift

#endif
