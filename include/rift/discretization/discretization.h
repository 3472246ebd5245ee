#ifndef rift_discretization_discretization_h
#define rift_discretization_discretization_h

#include <rift/discretization/ghost_exchange.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/topology.h>

namespace rift
{
  /** What the solver works on, made once from the triangulation. */
  struct Discretization
  {
    Topology          topology;
    ReferenceCellData reference;
    State             state;
    GhostExchange     exchange;
  };
} // namespace rift

#endif
