#ifndef rift_contact_contact_penalty_h
#define rift_contact_contact_penalty_h

#include <rift/discretization/reference_cell_data.h>

#include <vector>

namespace rift
{
  /** What contact may do to a cell (doc/theory.md, eq. 27a). */
  struct ContactStiffness
  {
    /** Pa/m: traction per depth of overlap that the time step allows at any of
     * its faces if the partner cannot move; infinite where nothing can move the
     * cell. */
    double per_area;

    /** m: least height. */
    double height;
  };

  /** Penalty of a pair of cells, Pa (eq. 27b): the same in either order. */
  inline double
  pair_penalty(const ContactStiffness &a, const ContactStiffness &b)
  {
    return 1 /
           ((1 / a.per_area + 1 / b.per_area) * (1 / a.height + 1 / b.height));
  }

  /**
   * Divides what the time step leaves to the nodes among the faces around them
   * that may be touched (doc/theory.md, section 8). A node has what all the
   * cells around it leave, a face as much as the poorest of its nodes. Faces
   * may be touched at the surface of the body and where their cohesive element
   * has been released; elements that act on others have a share of their own.
   *
   * It looks at the nodes and faces as they are. Sums run over the cells around
   * complete vertices in their order, so that all ranks get the same bits.
   */
  class ContactStiffnesses
  {
  public:
    /**
     * @param topology, reference of the body: referred to from now on.
     * @param spare_stiffness of each cell slot, N/m: mass at a corner times
     *   what is left to the square of a frequency of the loose cell.
     * @param share_of_bond of a cell's spare stiffness that the cohesive element of
     *   each face that has been cut takes at a corner: 1/3 in the extrinsic
     *   model, 0 where the spare stiffness is without them already.
     */
    ContactStiffnesses(const Topology          &topology,
                       const ReferenceCellData &reference,
                       std::vector<double>      spare_stiffness,
                       double                   share_of_bond);

    /**
     * Of a cell all whose vertices are complete. One without a face that may be
     * touched meets others by edges and corners or behind other cells: see
     * per_area_inside().
     */
    ContactStiffness
    of_cell(CellIndex cell) const;

    /** Stiffnesses of nodes, Pa/m, kept for of_cell(): per_area_of_node() and
     * per_area_inside(); not a number where it is not known. */
    struct KnownNodes
    {
      /** Has a node be computed anew: faces or cells around it have changed. */
      void
      forget(NodeIndex node);

      /** By node; nodes beyond the end are not known. */
      std::vector<double> touched, inside;
    };

    /** Likewise, where nodes are known. */
    ContactStiffness
    of_cell(CellIndex cell, KnownNodes &known) const;

  private:
    /** Of a cell by functions of its nodes. */
    template <typename PerAreaOfNode, typename PerAreaInside>
    ContactStiffness
    of_cell(CellIndex            cell,
            const PerAreaOfNode &of_node,
            const PerAreaInside &inside) const;

    /** Pa/m: of a node at a face that may be touched. */
    double
    per_area_of_node(NodeIndex node) const;

    /** Pa/m: likewise, if all faces may be touched that are cut or at the
     * surface, and half of those that are intact, each from one side. */
    double
    per_area_inside(NodeIndex node) const;

    /** Whether nothing but contact acts between a face and what touches it. */
    bool
    is_exposed(CellIndex cell, unsigned int face) const;

    /** Whether a cohesive element acts on a face or may do so from the next
     * step on. */
    bool
    is_bonded(CellIndex cell, unsigned int face) const;

    /** Whether neither. */
    bool
    is_intact(CellIndex cell, unsigned int face) const;

    /** m */
    double
    height(CellIndex cell, unsigned int face) const;

    /**
     * What faces that are touched with 1 Pa/m add to the stiffness of one of
     * their nodes, m^2.
     *
     * @param share of them that is touched.
     */
    void
    add_face(CellIndex        cell,
             unsigned int     face,
             Matrix3<double> &sum,
             double           share = 1) const;

    const Topology          &topology;
    const ReferenceCellData &reference;
    std::vector<double>      spare_stiffness;
    double                   share_of_bond;
  };
} // namespace rift

#endif
