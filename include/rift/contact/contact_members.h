#ifndef rift_contact_contact_members_h
#define rift_contact_contact_members_h

#include <rift/base/communicator.h>
#include <rift/contact/contact_cell.h>
#include <rift/contact/packed_motion.h>
#include <rift/discretization/state.h>

#include <functional>
#include <unordered_map>
#include <vector>

namespace rift
{
  /**
   * The cells in pairs that are computed on this rank, and how they move: own
   * ones as the state says, others, ghosts as well, as their owners tell in each
   * step.
   */
  class ContactMembers
  {
  public:
    /** The stiffness of an own cell that may touch others. */
    using StiffnessOf = std::function<ContactStiffness(CellIndex)>;

    /** A cell in pairs. */
    struct Member
    {
      /** The cell, the rank that owns it, its material, and its mass, kg. */
      GlobalCellIndex cell;
      int             owner;
      std::uint32_t   material;
      double          mass;

      /** How stiff it is now, and its margin as its owner has told last, m. */
      ContactStiffness stiffness;
      double           margin;

      /** Here; invalid_index if this rank does not see it. */
      CellIndex local;

      /** The partners of larger name. */
      std::vector<std::uint32_t> partners;

      /** Number of pairs that it is in. */
      std::uint32_t n_pairs;
    };

    /** Both must outlive this object. */
    ContactMembers(const Topology &topology, const Communicator &communicator);

    /** The position of a cell, which becomes a member. */
    std::uint32_t
    take_in(const ContactCell &cell);

    /** A member by its position. */
    const Member &
    operator[](const std::uint32_t position) const
    {
      return members[position];
    }

    /** The cell that a member is, if it is of this rank; else invalid_index. */
    CellIndex
    own_cell(const std::uint32_t position) const
    {
      return own_cells[position];
    }

    /** Number of members. */
    std::size_t
    size() const
    {
      return members.size();
    }

    /** Bytes that they take. */
    std::uint64_t
    bytes() const;

    /** Makes a pair of two members.
     * @return whether it was none before. */
    bool
    connect(const CellPair &pair);

    /** Forgets a pair. */
    void
    disconnect(const CellPair &pair);

    /**
     * Forgets members without pairs, where these are many.
     *
     * @return the new positions of the members; empty if nothing has changed.
     */
    std::vector<std::uint32_t>
    tidy();

    /** Asks the owners of the members to tell how they move. Collective. */
    void
    subscribe();

    /** Sets the stiffness of a member. */
    void
    set_stiffness(std::uint32_t position, const ContactStiffness &stiffness);

    /** Likewise of a cell, if it is a member. */
    void
    set_stiffness_of(GlobalCellIndex cell, const ContactStiffness &stiffness);

    /** Tells others how own cells move and how stiff they are; does not wait.
     *
     * @param stiffness of an own cell. */
    void
    send(const State &state, const StiffnessOf &stiffness);

    /** Waits for what the others have told. To be called once after send(). */
    void
    receive();

    /** Whether a stiffness has changed since the last call. */
    bool
    have_stiffnesses_changed();

    /** The largest speed of cells that others have told of last, m/s. */
    double
    largest_told_speed() const;

    /** Takes in how the cells of a pair move now, once per step. */
    void
    pack(const State &state, const CellPair &pair)
    {
      pack(state, pair.a);
      pack(state, pair.b);
    }

    /** Likewise, but where they are alone. */
    void
    pack_positions(const State &state, const CellPair &pair)
    {
      pack_positions(state, pair.a);
      pack_positions(state, pair.b);
    }

    /** By position; up to date for cells that have been packed since the last
     * receive(). */
    const PackedMotion *
    motions() const
    {
      return packed.data();
    }

  private:
    /** A rank that tells of cells, or is told. */
    struct Partner
    {
      int                        rank;
      std::vector<std::uint32_t> cells;
    };

    void
    pack(const State &state, std::uint32_t position);

    void
    pack_positions(const State &state, std::uint32_t position);

    const Topology     &topology;
    const Communicator &communicator;

    std::vector<Member>                                members;
    std::unordered_map<GlobalCellIndex, std::uint32_t> position_by_name;
    std::vector<CellIndex>                             own_cells;
    std::vector<PackedMotion>                          packed;

    /** Number of exchanges, and the last ones after which the velocities and the
     * positions of a member were packed. */
    struct Packed
    {
      std::uint64_t velocities, positions;
    };
    std::uint64_t       n_exchanges = 1;
    std::vector<Packed> packed_after;

    std::vector<Partner> receivers, senders;
    PendingExchange      reports;
    bool                 stiffnesses_have_changed = false;
  };
} // namespace rift

#endif
