#ifndef rift_bonds_vertex_bonds_h
#define rift_bonds_vertex_bonds_h

#include <rift/bonds/bond_law.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /** Energy that bonds have used, J. */
  struct BondEnergy
  {
    /** By damage, by sliding under pressure, and by closing of open bonds, which
     * is an inelastic impact. */
    double fracture = 0, friction = 0, closing = 0;
  };

  /**
   * What holds two nodes together that a crack has parted at a vertex: all cut
   * faces between their cells are one bond, whose area and traction are those of
   * its crack plane (doc/theory.md, eq. 40 to 44). Here is what is read in each
   * step.
   */
  struct Bond
  {
    /** Its nodes among those of the vertex; the first has the smaller cell. */
    std::uint32_t parts[2];

    /** Unit normal of the crack plane, from the first node to the second. */
    Vector3<double> normal;

    /** Projected area, m^2. */
    double area;

    /** What the second node does to the first, per projected area, Pa. */
    Vector3<double> traction;

    /** What it bears at its present damage. */
    BondLaw::Envelope envelope;

    /** How far it is open, m: update_gap(). */
    double gap = 0;

    /** The part of its pressure that it had not left to contact when its
     * traction was last looked for bond by bond: pressure_share_of(). */
    double pressure_share = 1;

    /** Whether it has yet to go through its first step, which sets its excess;
     * whether its energy up to t_n is known already; whether its nodes have
     * moved as one since the last step. */
    bool is_new, is_counted, is_tied;

    /** Whether contact has taken over all of its faces: it bears nothing. */
    bool is_released;
  };

  /** What a bond remembers besides. */
  struct BondHistory
  {
    /** Unit normal of the crack plane in the undeformed body. */
    Vector3<double> plane;

    /** Root of the mean area of its faces, m. */
    double size;

    /** Strength of the plane, and what is left of it. */
    FaceStrength    strength;
    BondLaw::Memory memory;

    /** Its faces: a range of VertexBonds::fan. */
    std::uint32_t fan_begin, fan_end;
  };

  /** The bonds at one vertex. */
  struct VertexBonds
  {
    /** Where. */
    VertexIndex vertex;

    /** Whether a component of a node is prescribed: not known before the first
     * step of the group. */
    enum class Prescribed : std::uint8_t
    {
      unknown,
      no,
      yes
    };

    /** What is known of that. */
    Prescribed prescribed = Prescribed::unknown;

    /** Whether a bond was cut back in the last step. */
    bool is_yielding = false;

    /** A node here. */
    struct Part
    {
      /** Which. */
      NodeIndex node;

      /** The first of those that bonds connect it to. */
      std::uint32_t root;

      /** kg */
      double mass;
    };

    /** The nodes, by their smallest cells. */
    std::vector<Part> parts;

    /** The inverse of the Laplacian of the bonds with their areas as weights,
     * 1/m^2, row by row; see set_laplacian(). */
    std::vector<double> inverse;

    /** The bonds between them, and how many of them have not been released. */
    std::vector<Bond> bonds;
    std::size_t       n_active = 0;

    /** By bond. */
    std::vector<BondHistory> histories;

    /** Of all bonds here up to t_n. */
    BondEnergy energy;

    /** A face of a bond. */
    struct FanFace
    {
      /** Index in CrackFaces, and the corner of the face at this vertex. */
      std::uint32_t face;
      std::uint8_t  corner;

      /** Crack plane in the frame of the undeformed face, times its area. */
      Vector3<double> plane;
    };

    /** The faces of all bonds. */
    std::vector<FanFace> fan;
  };

  /** Displacement of the second node of a bond against the first, m. */
  inline Vector3<double>
  jump_of(const VertexBonds &group, const Bond &bond, const State &state)
  {
    return state.displacement[group.parts[bond.parts[1]].node].vector() -
           state.displacement[group.parts[bond.parts[0]].node].vector();
  }

  /** Velocity of the second node of a bond against the first, m/s. */
  inline Vector3<double>
  relative_velocity(const VertexBonds &group,
                    const Bond        &bond,
                    const State       &state)
  {
    return state.velocity[group.parts[bond.parts[1]].node].vector() -
           state.velocity[group.parts[bond.parts[0]].node].vector();
  }

  /**
   * Adds what a bond has used while its traction had a mean value.
   *
   * @param motion of the second node against the first, m.
   */
  void
  count_energy(BondEnergy            &energy,
               const Bond            &bond,
               const Vector3<double> &mean_traction,
               const Vector3<double> &motion);

  /** Slip over the size of a face from which a failed bond leaves pressure to
   * contact, and slip over which it does so. */
  constexpr double slip_to_contact = .1, slip_of_fading = .05;

  /** Looks how far the nodes of a bond have parted: its gap is 0 where they are
   * closed but for rounding. */
  void
  update_gap(const VertexBonds &group,
             Bond              &bond,
             const BondHistory &history,
             const State       &state);

  /** The part of its pressure that a bond keeps while there is contact: less than
   * 1 once it has failed and slid so far that contact takes over. */
  double
  pressure_share_of(const VertexBonds &group,
                    const Bond        &bond,
                    const BondHistory &history,
                    const State       &state);

  /**
   * Finds the parts that bonds connect, and the inverse of their Laplacian: in
   * the rows of roots, whose potential is zero, it is the unit matrix.
   */
  void
  set_laplacian(VertexBonds &group);
} // namespace rift

#endif
