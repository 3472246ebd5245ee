#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_force.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rift
{
  namespace
  {
    /** The skin over the harmonic mean of the sizes of surface cells. Thicker
     * means fewer searches and more pairs to look at in each step. */
    constexpr double skin_per_size = .2;

    double
    longest_edge(const Tetrahedron &t)
    {
      double longest = 0;
      for (unsigned int i = 0; i < n_corners; ++i)
        for (unsigned int j = 0; j < i; ++j)
          longest = std::max(longest, norm(t[i] - t[j]));
      return longest;
    }

    double
    skin_of(const ContactSurface &surface,
            const Topology       &topology,
            const State          &state,
            const Communicator   &communicator)
    {
      ExactSum sum;
      for (const CellIndex cell : surface.cells())
        sum.add(1 / longest_edge(motion_of(topology, state, cell).positions));
      ExactSum::sum_over_ranks({&sum}, communicator);
      const auto number =
        communicator.sum(static_cast<std::int64_t>(surface.cells().size()));
      return skin_per_size * number / sum.value();
    }
  } // namespace

  ContactForce::ContactForce(const Topology     &topology,
                             const State        &state,
                             const Communicator &communicator,
                             Interface           interface)
    : topology(topology)
    , communicator(communicator)
    , interface(std::move(interface))
    , surface(topology)
    , skin(skin_of(surface, topology, state, communicator))
    , rendezvous(communicator, [this](const ContactCell &cell) {
      return surface.subscribers(this->topology.find_cell(cell.cell));
    })
  {
    rift_check(this->interface.cells.size() == topology.n_cell_slots());
  }

  std::pair<double, double>
  ContactForce::penalty_range() const
  {
    double least_inverse = 0, largest = 0;
    for (const CellIndex cell : surface.cells())
      {
        const double penalty = interface.cells[cell].penalty;
        if (std::isinf(penalty))
          continue;
        least_inverse = std::max(least_inverse, 1 / penalty);
        largest       = std::max(largest, penalty);
      }
    return {1 / communicator.max(least_inverse), communicator.max(largest)};
  }

  void
  ContactForce::follow(const State &state, const double time_step)
  {
    if (is_due(state, time_step))
      search(state, time_step);
    else
      exchange_motions(state);
  }

  bool
  ContactForce::is_due(const State &state, const double time_step) const
  {
    // In the next step, so that no pair is found too late.
    double largest = 0;
    for (std::size_t i = 0; i < searched_cells.size(); ++i)
      for (unsigned int c = 0; c < n_corners; ++c)
        {
          const NodeIndex       node = topology.node(searched_cells[i], c);
          const Vector3<double> shift =
            state.position(node) - searched_positions[i][c] +
            time_step * state.velocity[node].vector();
          largest = std::max(largest, dot(shift, shift));
        }
    const bool has_cracked = state.step % crack_interval == 0 &&
                             interface.n_crack_events() != n_known_events;
    return communicator.any(!has_searched || has_cracked ||
                            largest >= skin * skin / 4);
  }

  std::vector<ContactCell>
  ContactForce::own_cells(const State                  &state,
                          const std::vector<CellIndex> &cells) const
  {
    std::vector<ContactCell> result;
    result.reserve(cells.size());
    for (const CellIndex cell : cells)
      {
        result.push_back(
          surface.describe(cell, communicator.rank(), interface.is_held));
        result.back().constants = interface.cells[cell];
        result.back().motion    = motion_of(topology, state, cell);
      }
    return result;
  }

  void
  ContactForce::search(const State &state, const double time_step)
  {
    interface.for_each_open_face(
      [this](const FaceIndex face) { surface.include(face); });
    has_searched   = true;
    n_known_events = interface.n_crack_events();
    searched_cells = surface.cells();
    searched_positions.clear();
    constexpr double infinity      = std::numeric_limits<double>::infinity();
    double           largest_speed = 0;
    for (const CellIndex cell : searched_cells)
      {
        const CellMotion motion = motion_of(topology, state, cell);
        searched_positions.push_back(motion.positions);
        for (const Vector3<double> &v : motion.velocities)
          if (const double speed = norm(v); !(speed <= largest_speed))
            largest_speed = std::isnan(speed) ? infinity : speed;
      }
    largest_speed     = communicator.max(largest_speed);
    const double move = time_step * largest_speed;
    if (move > .5 / skin_per_size * skin)
      throw CollectiveError(
        ExitCode::run_error,
        "contact: at step " + std::to_string(state.step) +
          " something moves with " + short_text(largest_speed) + " m/s, by " +
          short_text(move) +
          " m or more than half of a cell in a step. It would pass through "
          "what it meets. Choose a smaller time step (subsection Time).");
    // What moves by half of the skin in a step is searched for in each, farther
    // off.
    const double reach = skin + 2 * move;
    adopt_pairs(rendezvous.search(own_cells(state, searched_cells), reach));
  }

  void
  ContactForce::adopt_pairs(const ContactNeighbourhood &neighbourhood)
  {
    // Old and new pairs are in the same order.
    const std::vector<Member> old_members = std::move(members);
    const std::vector<Pair>   old_pairs   = std::move(pairs);
    const auto                name_of     = [&](const Pair &pair) {
      return std::make_pair(old_members[pair.a].cell.cell,
                            old_members[pair.b].cell.cell);
    };
    auto old = old_pairs.begin();

    const std::vector<ContactCell> &cells = neighbourhood.cells;
    std::vector<std::uint32_t>      member_of(cells.size(), invalid_index);
    std::vector<std::size_t>        born;
    members.clear();
    pairs.clear();
    pairs.reserve(neighbourhood.pairs.size());
    const auto member = [&](const std::uint32_t cell) {
      if (member_of[cell] == invalid_index)
        {
          member_of[cell] = static_cast<std::uint32_t>(members.size());
          members.push_back(
            {cells[cell], topology.find_cell(cells[cell].cell)});
        }
      return member_of[cell];
    };
    for (const BoxPair &found : neighbourhood.pairs)
      {
        const ContactCell &a = cells[found.first], &b = cells[found.second];
        rift_check(a.cell < b.cell && a.owner >= 0 && b.owner >= 0);
        const auto name = std::make_pair(a.cell, b.cell);
        while (old != old_pairs.end() && name_of(*old) < name)
          ++old;
        Pair pair{};
        if (old != old_pairs.end() && name_of(*old) == name)
          pair = *old;
        else
          born.push_back(pairs.size());
        pair.a         = member(found.first);
        pair.b         = member(found.second);
        pair.constants = {std::min(a.constants.penalty, b.constants.penalty),
                          interface.friction[a.material][b.material],
                          interface.damping,
                          1 / (1 / a.constants.mass + 1 / b.constants.mass)};
        rift_check(members[pair.a].local != invalid_index ||
                   members[pair.b].local != invalid_index);
        pairs.push_back(pair);
      }
    std::vector<CellPair> born_pairs;
    for (const std::size_t i : born)
      born_pairs.push_back({pairs[i].a, pairs[i].b});
    const std::vector<CommonPart> parts =
      common_parts(packed_members(), born_pairs);
    for (std::size_t i = 0; i < born.size(); ++i)
      pairs[born[i]].memory.initial_potential = parts[i].potential;
    subscribe();
  }

  void
  ContactForce::subscribe()
  {
    receivers.clear();
    senders.clear();
    std::map<int, std::vector<GlobalCellIndex>> wanted;
    std::map<int, Partner>                      asked;
    for (std::uint32_t i = 0; i < members.size(); ++i)
      if (const int owner = members[i].cell.owner; owner != communicator.rank())
        {
          wanted[owner].push_back(members[i].cell.cell);
          asked[owner].rank = owner;
          asked[owner].cells.push_back(i);
        }
    for (auto &[rank, partner] : asked)
      senders.push_back(std::move(partner));
    for (const auto &[rank, cells] : communicator.exchange(wanted))
      {
        Partner receiver{rank, {}};
        for (const GlobalCellIndex cell : cells)
          {
            receiver.cells.push_back(topology.find_cell(cell));
            rift_check(receiver.cells.back() != invalid_index &&
                       topology.owns_cell(receiver.cells.back()));
          }
        receivers.push_back(std::move(receiver));
      }
  }

  void
  ContactForce::exchange_motions(const State &state)
  {
    for (Member &member : members)
      if (member.cell.owner == communicator.rank())
        member.cell.motion = motion_of(topology, state, member.local);
    std::map<int, std::string> messages;
    for (const Partner &receiver : receivers)
      {
        std::vector<CellMotion> motions;
        for (const CellIndex cell : receiver.cells)
          motions.push_back(motion_of(topology, state, cell));
        messages[receiver.rank] = to_bytes(motions);
      }
    std::map<int, std::size_t> sizes;
    for (const Partner &sender : senders)
      sizes[sender.rank] = sender.cells.size() * sizeof(CellMotion);
    const auto received = communicator.exchange(messages, sizes);
    for (const Partner &sender : senders)
      {
        const auto motions = from_bytes<CellMotion>(received.at(sender.rank));
        rift_check(motions.size() == sender.cells.size());
        for (std::size_t i = 0; i < motions.size(); ++i)
          members[sender.cells[i]].cell.motion = motions[i];
      }
  }

  std::optional<DeepOverlap>
  ContactForce::add_to(State &state, Activity &activity, const double time_step)
  {
    energies.elastic = ExactSum();
    std::optional<DeepOverlap>                      deep;
    const std::vector<PackedMotion>                 cells = packed_members();
    std::array<ContactPair, PairKernel::chunk_size> chunk;
    std::array<PairForces, PairKernel::chunk_size>  results;
    for (std::size_t first = 0; first < pairs.size();
         first += PairKernel::chunk_size)
      {
        const auto n = static_cast<unsigned int>(
          std::min<std::size_t>(PairKernel::chunk_size, pairs.size() - first));
        for (unsigned int i = 0; i < n; ++i)
          {
            const Pair &pair = pairs[first + i];
            chunk[i]         = {{pair.a, pair.b}, pair.constants, pair.memory};
          }
        kernel.compute(cells.data(),
                       chunk.data(),
                       n,
                       time_step,
                       results.data());
        for (unsigned int i = 0; i < n; ++i)
          {
            Pair             &pair   = pairs[first + i];
            const PairForces &forces = results[i];
            const Member     &a = members[pair.a], &b = members[pair.b];
            pair.memory  = chunk[i].memory;
            pair.touches = forces.touches;
            if (forces.is_too_deep && !deep)
              deep = DeepOverlap{a.cell.cell, b.cell.cell};
            if (a.cell.owner == communicator.rank())
              {
                energies.elastic.add(forces.energy);
                energies.friction.add(forces.friction_loss);
                energies.damping.add(forces.damping_loss);
              }
            if (!forces.overlaps)
              continue;
            add_forces(a, forces.on_a, state, activity);
            add_forces(b, forces.on_b, state, activity);
          }
      }
    return deep;
  }

  std::vector<PackedMotion>
  ContactForce::packed_members() const
  {
    std::vector<PackedMotion> cells;
    cells.reserve(members.size());
    for (const Member &member : members)
      cells.push_back(pack(member.cell.motion));
    return cells;
  }

  void
  ContactForce::add_forces(const Member      &member,
                           const NodalVector *forces,
                           State             &state,
                           Activity          &activity) const
  {
    if (member.local == invalid_index)
      return;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const NodeIndex node = topology.node(member.local, c);
        for (unsigned int d = 0; d < dim; ++d)
          state.force[node][d] += forces[c][d];
        // Other cells around the node may be asleep though this one is not.
        if (!activity.has_woken_neighbours(member.local / batch_size))
          activity.wake_node(topology, node);
      }
  }

  void
  ContactForce::count_pairs(const Topology             &topology,
                            std::vector<std::uint32_t> &n) const
  {
    for (const Pair &pair : pairs)
      if (const CellIndex a = members[pair.a].local;
          a != invalid_index && topology.owns_cell(a))
        ++n[a];
  }

  std::uint64_t
  ContactForce::count_touching() const
  {
    std::int64_t number = 0;
    for (const Pair &pair : pairs)
      number +=
        pair.touches && members[pair.a].cell.owner == communicator.rank();
    return static_cast<std::uint64_t>(communicator.sum(number));
  }
} // namespace rift
