#ifndef rift_io_solution_fields_h
#define rift_io_solution_fields_h

#include <rift/base/communicator.h>
#include <rift/cohesive/fracture.h>
#include <rift/discretization/field_list.h>
#include <rift/io/vtu_output.h>

#include <string>
#include <vector>

namespace rift
{
  /**
   * The names of all fields that modules can have, without values: those that
   * probes know and, of cohesive faces, those of fracture.pvd.
   */
  FieldList
  known_fields();

  /**
   * Declares what tells cells apart in solid.pvd: material and fragment.
   *
   * @param fragments number for each cell slot; see find_fragments(). They
   *   are looked at only when values are asked for.
   */
  void
  declare_labels(FieldList                        &list,
                 const Topology                   *topology,
                 const std::vector<std::uint32_t> *fragments);

  /** Names of all fields that solid.pvd and fracture.pvd can have. */
  FieldList
  known_output_fields();

  /**
   * The cells that this rank owns: nodes of the undeformed body, and the
   * wanted fields of nodes and cells.
   */
  Solution
  solid_solution(const Topology       &topology,
                 const FieldList      &fields,
                 const FieldSelection &wanted);

  /**
   * The cohesive elements of this rank that have begun to open, each a triangle
   * at its place in the undeformed body: the wanted fields of cohesive faces,
   * and the displacement halfway between their sides.
   */
  Solution
  fracture_solution(const Topology       &topology,
                    const Fracture       &fracture,
                    const FieldList      &fields,
                    const FieldSelection &wanted);

  /**
   * Hash of displacements and velocities of all corners of all cells, as
   * hexadecimal text: equal if and only if two states are, on any number of
   * ranks. Collective.
   */
  std::string
  state_hash(const Topology     &topology,
             const State        &state,
             const Communicator &communicator = {});
} // namespace rift

#endif
