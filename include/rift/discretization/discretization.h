#ifndef rift_discretization_discretization_h
#define rift_discretization_discretization_h

#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/topology.h>

#include <deal.II/distributed/fully_distributed_tria.h>

namespace rift
{
  /** What the solver works on, made once from the triangulation. */
  struct Discretization
  {
    Topology          topology;
    ReferenceCellData reference;
    State             state;
  };

  /**
   * Takes cells, shape function gradients, volumes and lumped masses from
   * deal.II's linear simplex element FE_SimplexP(1) over all cells that this
   * rank sees, into the arrays that the step works on. deal.II is not needed
   * after that.
   *
   * @param densities kg/m^3 of each material id of the triangulation.
   */
  Discretization
  discretize(
    const dealii::parallel::fullydistributed::Triangulation<dim> &triangulation,
    const std::vector<double>                                    &densities);
} // namespace rift

#endif
