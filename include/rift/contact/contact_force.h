#ifndef rift_contact_contact_force_h
#define rift_contact_contact_force_h

#include <rift/base/archive.h>
#include <rift/base/exact_sum.h>
#include <rift/contact/contact_members.h>
#include <rift/contact/contact_pair.h>
#include <rift/contact/contact_surface.h>
#include <rift/contact/rendezvous.h>
#include <rift/contact/sleeping_pairs.h>
#include <rift/discretization/activity.h>
#include <rift/material/material_parameters.h>

#include <optional>
#include <unordered_map>
#include <vector>

namespace rift
{
  /** Energies of the pairs that this rank owns, J. */
  struct ContactEnergy
  {
    /** Of overlaps and springs now; used up by friction and by damping. */
    ExactSum elastic, friction, damping;
  };

  /** Where and when two cells lay in each other too deep for the first time:
   * PairForces::is_too_deep. */
  struct DeepOverlap
  {
    /** Global indices of the two cells. */
    GlobalCellIndex a, b;

    /** Number of the step, and s. */
    std::uint64_t step;
    double        time;

    /** The mean of their corners, m. */
    Vector3<double> place;
  };

  /**
   * Contact at work: the surface, the search and the forces of the pairs.
   *
   * The positions at t_n and the pairs are made at the end of the step before,
   * by follow(), which sends them; add_to() receives. Each rank computes all
   * pairs of the cells that it sees, in the order of these, so that the sums at
   * its nodes are the same on any number of ranks; of cells that it does not
   * own it is told by their owners.
   *
   * Partners are searched for of cells that have moved by their margin and,
   * every `look_interval` steps, of those that cracks have released. Cells
   * behind those that others lie deep in take part from the next step on. Cells
   * that could not touch before may overlap already: such a pair starts without
   * force and energy. All others start apart. Pairs that are apart sleep.
   */
  class ContactForce
  {
  public:
    /** Steps between two looks at the cracks. */
    static constexpr std::uint64_t look_interval = 10;

    /** How far the corners of cracks open before contact takes over, over the
     * least height of the cells around. Until then an overlap at edges and
     * vertices has no force; it is less than cells are deformed by. */
    static constexpr double opening = .01;

    /** What contact has to know of the body and the materials. */
    struct Interface
    {
      /** By cell slot. */
      std::vector<ContactCellConstants> cells;

      /** How stiff the time step allows contact to be. */
      ContactStiffnesses stiffnesses;

      /** Coefficient of friction of each two materials. */
      std::vector<std::vector<double>> friction;

      /** Damping over the critical one. */
      double damping;
    };

    /** Neither topology nor communicator must end before this object. */
    ContactForce(const Topology     &topology,
                 const Communicator &communicator,
                 Interface           interface);

    ContactForce(const ContactForce &) = delete;
    ContactForce &
    operator=(const ContactForce &) = delete;

    /** Calls `f` with the cells of this rank that may touch others, and their
     * stiffnesses. */
    template <typename Function>
    void
    for_each_stiffness(const Function &f) const
    {
      for (const CellIndex cell : surface.cells())
        f(cell, interface.stiffnesses.of_cell(cell));
    }

    /** Takes in that corners at these vertices have other nodes than before.
     */
    void
    update_nodes(const std::vector<VertexIndex> &vertices)
    {
      changed_vertices.insert(changed_vertices.end(),
                              vertices.begin(),
                              vertices.end());
    }

    /**
     * Takes in where the cells are now, on all ranks, and finds the pairs
     * that are new. To be called once before the first step and after each
     * drift, when the nodes of ghost cells have followed. Collective.
     *
     * @param time_step s.
     * @throws RunError or CollectiveError, on all ranks, when something moves
     *   too fast to be found or too many cells lie at one place.
     */
    void
    follow(const State &state, const Activity &activity, double time_step);

    /** Adds the forces at the positions of the last follow().
     * @param time_step that has led there, s; zero at the start. */
    void
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

    /** Bytes of all ranks by part: pairs that nothing parts, pairs that are
     * apart, the cells in them, and those among which pairs are searched for.
     * Collective. */
    std::vector<std::pair<std::string, double>>
    bytes() const;

    /** Pairs that have lain in each other too deep. */
    struct DeepOverlaps
    {
      /** Number of them. */
      std::int64_t n_pairs;

      /** The first one; of several in one step that of the smallest cells. */
      DeepOverlap first;
    };

    /** Pairs of the whole body that lie in each other too deep, or have done so;
     * empty if none. Collective. */
    std::optional<DeepOverlaps>
    deep_overlaps() const;

    /**
     * @throws InputError on all ranks if cells overlap that did not grow from
     *   a crack: to be called at the start, after follow(). Collective.
     */
    void
    refuse_overlaps(const State                           &state,
                    const std::vector<MaterialParameters> &materials);

    /** Adds 1 to the first cell of each pair near each other that this rank
     * owns. */
    void
    count_pairs(const Topology &topology, std::vector<std::uint32_t> &n) const;

    /** Writes the pairs that touch and what is known of the cracks.
     * Collective. */
    void
    save(Archive &archive) const;

    /** Continues in place of the first follow(). Collective. */
    void
    load(const State &state, const Archive &archive);

  private:
    /** Names of the cells of a pair, the first one in the upper bits. */
    using PairName = std::uint64_t;

    /** An own cell that may touch others, where it was when others were told
     * of it, and how far it may be from there, m. */
    struct Surveyed
    {
      CellIndex        cell;
      Tetrahedron      positions;
      double           margin;
      ContactStiffness stiffness;
    };

    /** A pair that has been found and has not been computed yet. */
    struct FoundPair
    {
      CellPair cells;

      /** Whether one of them could not touch the other before, so that what
       * they have in common is an initial overlap (eq. 26). */
      bool may_overlap;
    };

    PairName
    name_of(const CellPair &cells) const;

    /** Takes in that nodes around own cells have become lighter, or faces free.
     */
    void
    update_stiffnesses();

    /** Tells others of own cells; does not wait. */
    void
    send(const State &state);

    /** Waits for what others tell of their cells, gives the active pairs the
     * penalties of now, and starts the pairs that have been found. Nothing but
     * the first time after follow(). */
    void
    receive(const State &state, double time_step);

    double
    penalty_of(const CellPair &cells) const;

    /** Makes a cell a member. */
    std::uint32_t
    take_in(const ContactCell &cell);

    /** Adds own cells that have moved by half of their margin. */
    void
    add_moved(const State            &state,
              double                  time_step,
              std::vector<CellIndex> &news);

    /** Own cells that may touch others now that they could not touch before;
     * ascending. */
    std::vector<CellIndex>
    find_included(const State &state);

    /** Tells other ranks of own cells, and takes in the new pairs.
     * @param included those of them that find_included() has found.
     * @return see fastest_of(). */
    double
    search(const State                  &state,
           double                        time_step,
           std::vector<CellIndex>        news,
           const std::vector<CellIndex> &included);

    /** The speed of the fastest of those cells, of any rank, that move by more
     * than half of their size in a step, m/s; 0: none. Collective. */
    double
    fastest_of(const State                  &state,
               double                        time_step,
               const std::vector<CellIndex> &cells) const;

    /** What others are to know of an own cell. Keeps where it is now. */
    ContactCell
    survey(const State &state, double time_step, CellIndex cell);

    /** Makes pairs of those that are new, and forgets members without pairs.
     */
    void
    adopt(const ContactNeighbourhood &neighbourhood, std::uint64_t step);

    /** Starts the pairs that have been found, where the cells are now. */
    void
    start_pairs(const State &state);

    /** An active pair, without memory. */
    ContactPair
    make_pair(const CellPair &cells) const;

    /** Makes pairs active. */
    void
    merge(std::vector<ContactPair> pairs);

    /** Pairs that have woken sleep again or become active. */
    void
    wake_pairs(const State &state);

    /** Puts pairs to sleep or, if they are far apart, forgets them.
     * @return those that nothing parts. */
    std::vector<CellPair>
    put_to_sleep(const State                            &state,
                 const std::vector<SleepingPairs::Pair> &pairs);

    /** Active pairs that do not overlap sleep again.
     * @param parted such pairs, in the order of `active`. */
    void
    put_parted_to_sleep(const State                            &state,
                        const std::vector<SleepingPairs::Pair> &parted);

    /** Keeps in mind that a pair lies in each other deep. */
    void
    note_depth(const CellPair   &cells,
               const PairForces &forces,
               const State      &state);

    void
    add_forces(std::uint32_t      member,
               const NodalVector *forces,
               State             &state,
               Activity          &activity) const;

    const Topology     &topology;
    const Communicator &communicator;
    const Interface     interface;

    ContactSurface surface;
    Rendezvous     rendezvous;

    /** At the end of the last step, and vertices at which nodes have split
     * since. */
    KnownFaceStates          face_states;
    std::vector<VertexIndex> changed_vertices;

    /** Stiffnesses of nodes around which nothing has changed. */
    ContactStiffnesses::KnownNodes known_nodes;

    /** Own cells, and where each cell slot is among them. */
    std::vector<Surveyed>      surveyed;
    std::vector<std::uint32_t> surveyed_at;
    bool                       has_searched = false, has_received = true;

    /** How far anything may have moved in the last step, and in all of them
     * together, m; and what that sum is when own cells may have left their
     * margins. */
    double move = 0, path = 0, next_survey = 0;

    /** Of the last follow(), s. */
    double last_time_step = 0;

    ContactMembers         members;
    SleepingPairs          sleeping;
    std::vector<FoundPair> found;

    /** Pairs that nothing parts, in the order of their names. */
    std::vector<ContactPair> active;

    /** Cells of this rank and ghosts in which others lay deep at the last
     * add_to(), and pairs of this rank that have lain in each other too deep. */
    std::vector<CellIndex>                    deep_cells;
    std::unordered_map<PairName, DeepOverlap> too_deep;

    PairKernel    kernel;
    ContactEnergy energies;
  };
} // namespace rift

#endif
