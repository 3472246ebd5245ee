#ifndef rift_contact_contact_force_h
#define rift_contact_contact_force_h

#include <rift/base/archive.h>
#include <rift/base/exact_sum.h>
#include <rift/contact/contact_pair.h>
#include <rift/contact/contact_surface.h>
#include <rift/contact/rendezvous.h>
#include <rift/discretization/activity.h>
#include <rift/material/material_parameters.h>

#include <functional>
#include <optional>
#include <vector>

namespace rift
{
  /** Energies of the pairs that this rank owns, J. */
  struct ContactEnergy
  {
    /** Of overlaps and springs now; used up by friction and by damping. */
    ExactSum elastic, friction, damping;
  };

  /** Two cells that lie in each other so deep that contact no longer tells
   * their outsides apart. */
  struct DeepOverlap
  {
    /** Global indices of the two cells. */
    GlobalCellIndex a, b;
  };

  /**
   * Contact at work: the surface, the search and the forces of the pairs.
   *
   * The positions at t_n and the pairs are made at the end of the step before,
   * by follow(); add_to() then needs no other rank. Each rank computes all
   * pairs of the cells that it sees, in the order of these, so that the sums at
   * its nodes are the same on any number of ranks; of cells that it does not
   * own it is told by their owners.
   *
   * Pairs are searched for anew when a corner would have moved by half of the
   * skin in the next step, and every `crack_interval` steps when something has
   * broken. A pair whose cells overlap already when it is found, which happens
   * at cracks, starts without force and energy.
   */
  class ContactForce
  {
  public:
    /** Steps between two searches when something has broken. */
    static constexpr std::uint64_t crack_interval = 10;

    /** What contact has to know of the body, the cracks and the materials. */
    struct Interface
    {
      /** By cell slot. */
      std::vector<ContactCellConstants> cells;

      /** Coefficient of friction of each two materials. */
      std::vector<std::vector<double>> friction;

      /** Damping over the critical one. */
      double damping;

      /** Whether something else holds the two sides of a face. */
      ContactSurface::IsHeld is_held;

      /** Changes with all that has happened to cracks. */
      std::function<std::uint64_t()> n_crack_events;

      /** Calls its argument with all faces that have opened. */
      std::function<void(const std::function<void(FaceIndex)> &)>
        for_each_open_face;
    };

    /** Collective. @param state of the undeformed body. */
    ContactForce(const Topology     &topology,
                 const State        &state,
                 const Communicator &communicator,
                 Interface           interface);

    ContactForce(const ContactForce &) = delete;
    ContactForce &
    operator=(const ContactForce &) = delete;

    /** The least and the largest penalty of cells at outer surfaces, Pa.
     * Collective. */
    std::pair<double, double>
    penalty_range() const;

    /**
     * Takes in where the cells are now, on all ranks, and finds the pairs
     * anew when that is due. To be called once before the first step and after
     * each drift, when the nodes of ghost cells have followed. Collective.
     *
     * @param time_step s.
     * @throws RunError or CollectiveError, on all ranks, when something moves
     *   too fast to be found or too many cells lie at one place.
     */
    void
    follow(const State &state, double time_step);

    /** Adds the forces at the positions of the last follow().
     * @param time_step that has led there, s; zero at the start.
     * @return the first pair that lies in each other too deep, if any. */
    std::optional<DeepOverlap>
    add_to(State &state, Activity &activity, double time_step);

    /** Energies at the last add_to(). */
    const ContactEnergy &
    energy() const
    {
      return energies;
    }

    /** Number of pairs of the whole body that touch. Collective. */
    std::uint64_t
    count_touching() const;

    /**
     * @throws InputError on all ranks if cells overlap that did not grow from
     *   a crack: to be called at the start, after follow(). Collective.
     */
    void
    refuse_overlaps(const std::vector<MaterialParameters> &materials) const;

    /** Adds 1 to the first cell of each pair that this rank owns. */
    void
    count_pairs(const Topology &topology, std::vector<std::uint32_t> &n) const;

    /** Writes pairs, and the cells of the last search with their places.
     * Collective. */
    void
    save(Archive &archive) const;

    /** Continues in place of the first follow(). Collective. */
    void
    load(const State &state, const Archive &archive);

  private:
    /** A cell of a pair that is computed here. */
    struct Member
    {
      ContactCell cell;

      /** Here; invalid_index if this rank does not see it. */
      CellIndex local;
    };

    struct Pair
    {
      /** Positions in `members`. */
      std::uint32_t    a, b;
      ContactConstants constants;
      ContactMemory    memory;
      bool             touches;
    };

    /** A rank that tells of cells, or is told. */
    struct Partner
    {
      int                        rank;
      std::vector<std::uint32_t> cells;
    };

    bool
    is_due(const State &state, double time_step) const;

    /** The own cells as they are now. */
    std::vector<ContactCell>
    own_cells(const State &state, const std::vector<CellIndex> &cells) const;

    void
    search(const State &state, double time_step);

    /** Makes the members and the pairs that concern this rank. */
    void
    adopt_pairs(const ContactNeighbourhood &neighbourhood);

    /** Asks the owners of cells to tell how they move. */
    void
    subscribe();

    void
    exchange_motions(const State &state);

    void
    add_forces(const Member      &member,
               const NodalVector *forces,
               State             &state,
               Activity          &activity) const;

    /** Where the members are and how they move. */
    std::vector<PackedMotion>
    packed_members() const;

    const Topology     &topology;
    const Communicator &communicator;
    const Interface     interface;

    ContactSurface surface;
    const double   skin;
    Rendezvous     rendezvous;

    /** Own cells at the last search and where they were. */
    std::vector<CellIndex>   searched_cells;
    std::vector<Tetrahedron> searched_positions;
    std::uint64_t            n_known_events = 0;
    bool                     has_searched   = false;

    std::vector<Member>  members;
    std::vector<Pair>    pairs;
    std::vector<Partner> receivers, senders;
    ContactEnergy        energies;
    PairKernel           kernel;
  };
} // namespace rift

#endif
