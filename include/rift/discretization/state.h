#ifndef rift_discretization_state_h
#define rift_discretization_state_h

#include <rift/base/simd.h>
#include <rift/mesh/mesh_data.h>
#include <rift/mesh/node_splitter.h>

#include <vector>

namespace rift
{
  /**
   * The unknowns, one entry per node. The displacement is kept, not the
   * position: a body at rest then has a strain of exactly zero, and small
   * strains are not lost among large coordinates.
   */
  struct State
  {
    /** Position in the undeformed body, m. */
    std::vector<NodalVector> reference;

    /** Displacement at t_n, m. */
    std::vector<NodalVector> displacement;

    /** Velocity at t_n - dt/2 (after the kick: at t_n + dt/2), m/s. */
    std::vector<NodalVector> velocity;

    /** Sum of the forces of the step, N; zero outside of the step. */
    std::vector<NodalVector> force;

    /**
     * Lumped mass, kg; infinite at incomplete vertices, whose nodes go where
     * GhostExchange takes them.
     */
    std::vector<double> mass;

    /** Time t_n, s, and its number n. */
    double        time = 0;
    std::uint64_t step = 0;

    /** Number of nodes; it grows as nodes split. */
    std::size_t
    n_nodes() const
    {
      return mass.size();
    }

    /** Makes room for this many nodes; new ones are zero. */
    void
    resize(const std::size_t n_nodes)
    {
      for_each_vector([n_nodes](auto &v) { v.resize(n_nodes); });
      mass.resize(n_nodes);
    }

    /** Where a node is now, m. */
    Vector3<double>
    position(const NodeIndex node) const
    {
      return reference[node].vector() + displacement[node].vector();
    }

    /** Calls `f` on each of the vectors that new nodes inherit. */
    template <typename Function>
    void
    for_each_vector(const Function &f)
    {
      f(reference);
      f(displacement);
      f(velocity);
      f(force);
    }

    /**
     * Makes the nodes of a split: they inherit everything but mass and force,
     * which are sums over the cells around.
     */
    void
    grow(const TopologyChange &change)
    {
      std::size_t n_new = n_nodes();
      for (const NodeSplit &split : change.splits)
        n_new += split.parts.size() - 1;
      resize(n_new);
      for (const NodeSplit &split : change.splits)
        for (const NodeIndex part : split.parts)
          for_each_vector([&](auto &v) { v[part] = v[split.parts[0]]; });
    }
  };

  /**
   * Velocity of a node at t_n, m/s: half a kick after that of
   * `state.velocity`. Holds between the last force and the kick.
   */
  inline Vector3<double>
  velocity_at_step(const State    &state,
                   const double    time_step,
                   const NodeIndex node)
  {
    return state.velocity[node].vector() +
           (.5 * time_step / state.mass[node]) * state.force[node].vector();
  }

  /** Unit normal of the current place of an interior face, as its first cell
   * has it: outward from that cell. */
  inline Vector3<double>
  current_normal(const Topology &topology, const State &state, const Face &face)
  {
    std::array<Vector3<double>, 3> x;
    for (unsigned int c = 0; c < 3; ++c)
      x[c] = state.position(
        topology.node(face.cells[0], face_corners[face.local_faces[0]][c]));
    const Vector3<double> normal = cross(x[1] - x[0], x[2] - x[0]);
    return (1 / norm(normal)) * normal;
  }
} // namespace rift

#endif
