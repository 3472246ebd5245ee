#ifndef rift_bonds_bond_solver_h
#define rift_bonds_bond_solver_h

#include <rift/base/simd.h>
#include <rift/bonds/vertex_bonds.h>
#include <rift/discretization/prescribed_acceleration.h>

#include <vector>

namespace rift
{
  /**
   * Finds the tractions of the bonds at one vertex (doc/theory.md, eq. 42): those
   * that keep all parts together, if the bonds bear them, otherwise those of the
   * envelopes.
   */
  class BondSolver
  {
  public:
    /**
     * Adds the forces of the bonds to the state's, and updates what the bonds
     * remember. All other forces are known.
     *
     * @param prescribed the acceleration of a component where it is prescribed.
     * @return whether a bond has failed in this step.
     */
    bool
    hold(VertexBonds                  &group,
         State                        &state,
         double                        time_step,
         const PrescribedAcceleration &prescribed);

    /** The law of all bonds. */
    const BondLaw law;

    /** Whether contact takes over from bonds that have failed. */
    bool has_contact = false;

  private:
    /** Finds the velocities after the step without bonds.
     * @return whether a component is prescribed. */
    bool
    find_free_velocities(VertexBonds                  &group,
                         const State                  &state,
                         double                        time_step,
                         const PrescribedAcceleration &prescribed);

    /**
     * Keeps all parts together, with the smallest mean square of traction.
     *
     * @return whether all bonds bear it; otherwise nothing has changed.
     */
    bool
    tie(VertexBonds &group, State &state, double time_step);

    /** Counts the energy of a bond and sets the excess of a new one, once its
     * traction is known. */
    static void
    finish(VertexBonds           &group,
           std::size_t            place,
           const Vector3<double> &traction_before,
           const State           &state,
           double                 time_step);

    /** A bond while solve() looks for its traction. */
    struct Unknown
    {
      /** Normal, and traction per projected area, Pa. */
      Row normal, traction;

      /** By component: traction that a relative velocity makes when it is stopped
       * within a step, Pa s/m. */
      Row stiffness;

      /** By component: velocity of the first node and of the second, against
       * it, per traction, m/(Pa s). */
      Row mobility[2];

      BondLaw::Envelope envelope;

      /** Normal traction that would close the gap within a step, and the largest
       * pressure that it bears, Pa. */
      double closing, largest_pressure;

      /** Difference of two tractions that is negligible, squared, Pa^2. */
      double negligible;

      /** Its nodes among those of the vertex. */
      std::uint32_t parts[2];

      /** Its place in the group, whether it bears whatever is needed, and whether
       * it has been cut back. */
      std::uint32_t place;
      bool          is_new, is_yielding;
    };

    /** The part of its pressure that a bond keeps now. */
    double
    pressure_share(const VertexBonds &group,
                   std::size_t        place,
                   const State       &state) const;

    /** Makes the unknowns of a group, with the tractions of the last step. */
    void
    prepare(VertexBonds &group, const State &state, double time_step);

    /** One of them but for its place. */
    Unknown
    unknown(const Bond &bond, double time_step) const;

    /** Finds the tractions, bond by bond and again until they agree. */
    void
    solve(const VertexBonds &group);

    /** Once for each bond; whether the tractions agree with those before, more
     * closely if some bond starts. */
    bool
    solve_once(bool is_start);

    /** Changes the velocities of the nodes of a bond by a traction. */
    void
    push(const Unknown &bond, const Row &traction)
    {
      velocity[bond.parts[0]] += bond.mobility[0] * traction;
      velocity[bond.parts[1]] -= bond.mobility[1] * traction;
    }

    /** Damages a bond by the motion of its nodes; whether it fails. */
    bool
    soften(Bond &bond, BondHistory &history, double time_step) const;

    /** By part: velocity after the step, force that keeps it with the others, and
     * potential of these forces; inverse mass by component. */
    std::vector<Row> velocity, bond_force, potential, inverse_mass;

    /** By part: sum of mass and of momentum over those with the same root. */
    std::vector<double> mass;
    std::vector<Row>    momentum;

    /** Of the bonds that bear something. */
    std::vector<Unknown> unknowns;
  };
} // namespace rift

#endif
