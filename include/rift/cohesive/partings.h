#ifndef rift_cohesive_partings_h
#define rift_cohesive_partings_h

#include <rift/discretization/ghost_exchange.h>
#include <rift/discretization/prescribed_acceleration.h>
#include <rift/discretization/reference_cell_data.h>
#include <rift/discretization/state.h>
#include <rift/mesh/node_splitter.h>

#include <functional>
#include <optional>
#include <vector>

namespace rift
{
  /** A corner of a face that has been cut, and its node on both sides. */
  struct CutCorner
  {
    /** The face, by its index in Topology::faces. */
    FaceIndex face;

    /** 0, 1, 2 as seen from the minus side; see face_corners. */
    std::uint8_t corner;

    /** The nodes of the cells on its minus and its plus side. */
    NodeIndex minus, plus;
  };

  /** The corners at a vertex of all faces that have been cut. */
  std::vector<CutCorner>
  cut_corners_at(const Topology &topology, VertexIndex vertex);

  /**
   * Nodes that part, and what holds them together until their step is over:
   * the bond forces, with which the faces between them then begin to open
   * (doc/theory.md, section 5).
   */
  class Partings
  {
  public:
    /** Both must outlive this object. */
    Partings(const Topology &topology, const ReferenceCellData &reference);

    /** Takes in which nodes have parted in this step. */
    void
    add(const TopologyChange &change);

    /**
     * Adds to each of these nodes the bond force m_A a - f_A with their common
     * acceleration a; they are then forgotten. To be called when all other
     * forces have been summed.
     *
     * @param prescribed see CohesiveForce::hold_partings().
     * @return the bond forces, shared over the faces between the nodes.
     */
    std::vector<OpeningCorner>
    hold(State &state, const PrescribedAcceleration &prescribed);

  private:
    /** An opening corner and its two nodes among those of its parting. */
    struct Opening
    {
      FaceIndex    face;
      std::uint8_t corner;
      std::size_t  minus, plus;
    };

    /** Nodes that were one until this step, and what has opened between. */
    struct Parting
    {
      std::vector<NodeIndex> nodes;
      std::vector<Opening>   openings;
    };

    /** m_A a - f_A of each of the nodes that have parted, N. */
    static std::vector<Vector3<double>>
    bond_forces(const State                  &state,
                const Parting                &parting,
                const PrescribedAcceleration &prescribed);

    /** Divides the bond forces of the nodes among the faces that open. */
    void
    distribute(const Parting                      &parting,
               const std::vector<Vector3<double>> &bond,
               std::vector<OpeningCorner>         &opening_forces) const;

    const Topology          &topology;
    const ReferenceCellData &reference;
    std::vector<Parting>     partings;
  };
} // namespace rift

#endif
