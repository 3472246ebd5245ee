#ifndef rift_tests_contact_contact_interface_h
#define rift_tests_contact_contact_interface_h

#include <rift/contact/contact_force.h>

#include "../support/test_body.h"

namespace rift::test
{
  /** A body of two materials of the same density, kg/m^3, without friction and
   * damping: contact follows from the places of the cells alone. */
  inline ContactForce::Interface
  contact_interface(const DiscreteBody &body, const double density)
  {
    std::vector<double>               spare;
    std::vector<ContactCellConstants> cells;
    for (CellIndex cell = 0; cell < body.topology.n_cell_slots(); ++cell)
      {
        const double mass =
          density * body.reference[cell / batch_size].volume[cell % batch_size];
        spare.push_back(mass / n_corners * 1e14);
        cells.push_back({mass, invalid_index});
      }
    return {cells,
            ContactStiffnesses(body.topology, body.reference, spare, 0),
            {{0, 0}, {0, 0}},
            0};
  }
} // namespace rift::test

#endif
