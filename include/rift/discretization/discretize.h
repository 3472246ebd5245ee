#ifndef rift_discretization_discretize_h
#define rift_discretization_discretize_h

#include <rift/discretization/discretization.h>

#include <deal.II/distributed/fully_distributed_tria.h>

#include <vector>

namespace rift
{
  /**
   * Takes cells, shape function gradients, volumes and lumped masses from
   * deal.II's linear simplex element FE_SimplexP(1) over all cells that this
   * rank sees, into the arrays that the step works on. deal.II is not needed
   * after that. Collective.
   *
   * @param densities kg/m^3 of each material id of the triangulation.
   * @param parted for each material whether faces between cells of such
   *   materials are cut from the start; see separate_materials(). Empty: none
   *   are.
   */
  Discretization
  discretize(
    const dealii::parallel::fullydistributed::Triangulation<dim> &triangulation,
    const std::vector<double>                                    &densities,
    const Communicator                                           &communicator,
    const std::vector<bool>                                      &parted = {});
} // namespace rift

#endif
