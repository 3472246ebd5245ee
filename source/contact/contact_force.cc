#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_force.h>
#include <rift/contact/separation.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    /** How far a cell may move before its partners are searched for anew, over
     * its longest edge. More means fewer searches and more pairs. */
    constexpr double margin_per_size = .1;

    double
    longest_edge(const Tetrahedron &t)
    {
      double longest = 0;
      for (unsigned int i = 0; i < n_corners; ++i)
        for (unsigned int j = 0; j < i; ++j)
          longest = std::max(longest, norm(t[i] - t[j]));
      return longest;
    }

    /** The largest speed of the corners of a cell, m/s; infinite if one is not
     * a number. */
    double
    largest_speed(const CellMotion &motion)
    {
      double largest = 0;
      for (const Vector3<double> &v : motion.velocities)
        if (const double speed = norm(v); !(speed <= largest))
          largest =
            std::isnan(speed) ? std::numeric_limits<double>::infinity() : speed;
      return largest;
    }

    /** No node here is faster, m/s: by the largest components of all. */
    double
    bound_of_speeds(const State &state, const Activity &activity)
    {
      constexpr std::size_t block_size = Activity::block_size;
      const std::size_t     n_nodes    = state.n_nodes();
      Row                   largest{};
      for (std::size_t begin = 0; begin < n_nodes; begin += block_size)
        if (activity.is_block_awake(begin / block_size))
          for (std::size_t i = begin; i < std::min(begin + block_size, n_nodes);
               ++i)
            {
              const Row v       = state.velocity[i].row();
              const Row squares = v * v;
              largest           = largest > squares ? largest : squares;
            }
      return std::sqrt(largest[0] + largest[1] + largest[2]);
    }
  } // namespace

  ContactForce::ContactForce(const Topology     &topology,
                             const Communicator &communicator,
                             Interface           interface)
    : topology(topology)
    , communicator(communicator)
    , interface(std::move(interface))
    , surface(topology, opening, FaceState::released)
    , rendezvous(communicator,
                 [this](const ContactCell &cell) {
                   return surface.subscribers(
                     this->topology.find_cell(cell.cell));
                 })
    , face_states(topology)
    , surveyed_at(topology.n_cell_slots(), invalid_index)
    , members(topology, communicator)
  {
    rift_check(this->interface.cells.size() == topology.n_cell_slots());
  }

  void
  ContactForce::follow(const State    &state,
                       const Activity &activity,
                       const double    time_step)
  {
    last_time_step = time_step;
    move           = time_step * bound_of_speeds(state, activity);
    path += move;
    const std::vector<CellIndex> included = find_included(state);
    std::vector<CellIndex>       news     = included;
    if (!has_searched)
      news = surface.cells();
    if (!(path + move < next_survey))
      add_moved(state, time_step, news);
    update_stiffnesses();
    double fastest = 0;
    if (communicator.any(!has_searched || !news.empty()))
      fastest = search(state, time_step, std::move(news), included);
    send(state);
    // The forces of the next step are still computed.
    if (fastest > 0)
      throw CollectiveError(
        ExitCode::run_error,
        "contact: at step " + std::to_string(state.step) +
          " something moves with " + short_text(fastest) + " m/s, by " +
          short_text(time_step * fastest) +
          " m or more than half of a cell in a step. It would pass through "
          "what it meets. Choose a smaller time step (subsection Time).");
  }

  std::vector<CellIndex>
  ContactForce::find_included(const State &state)
  {
    std::vector<CellIndex> included;
    if (!has_searched || state.step % look_interval == 0)
      included = surface.look(state, path);
    for (const CellIndex cell : deep_cells)
      {
        const std::vector<CellIndex> behind = surface.include_behind(cell);
        included.insert(included.end(), behind.begin(), behind.end());
      }
    deep_cells.clear();
    std::sort(included.begin(), included.end());
    return included;
  }

  void
  ContactForce::send(const State &state)
  {
    members.send(state, [this](const CellIndex cell) {
      return surveyed[surveyed_at[cell]].stiffness;
    });
    has_received = false;
  }

  void
  ContactForce::update_stiffnesses()
  {
    // Whether nothing, an element or contact acts on it.
    const auto kind = [](const FaceState face_state) {
      return face_state == FaceState::intact  ? 0 :
             face_state < FaceState::released ? 1 :
                                                2;
    };
    for (const auto &[face, before, now] : face_states.look())
      if (kind(before) != kind(now))
        for (const VertexIndex vertex : vertices_of(topology, face))
          changed_vertices.push_back(vertex);
    std::vector<CellIndex> cells;
    for (const VertexIndex vertex : changed_vertices)
      std::for_each(
        topology.vertex_cells_first(vertex),
        topology.vertex_cells_last(vertex),
        [&](const CellIndex cell) {
          known_nodes.forget(
            topology.node(cell, topology.corner_at_vertex(cell, vertex)));
          if (surveyed_at[cell] != invalid_index)
            cells.push_back(cell);
        });
    changed_vertices.clear();
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    for (const CellIndex cell : cells)
      {
        ContactStiffness &stiffness = surveyed[surveyed_at[cell]].stiffness;
        stiffness = interface.stiffnesses.of_cell(cell, known_nodes);
        members.set_stiffness_of(topology.cell_global_indices[cell], stiffness);
      }
  }

  void
  ContactForce::receive(const State &state, const double time_step)
  {
    if (has_received)
      return;
    has_received = true;
    members.receive();
    path += std::max(0., time_step * members.largest_told_speed() - move);
    if (members.have_stiffnesses_changed())
      for (ContactPair &pair : active)
        pair.constants.penalty = penalty_of(pair.cells);
    start_pairs(state);
  }

  double
  ContactForce::penalty_of(const CellPair &cells) const
  {
    return pair_penalty(members[cells.a].stiffness, members[cells.b].stiffness);
  }

  void
  ContactForce::add_moved(const State            &state,
                          const double            time_step,
                          std::vector<CellIndex> &news)
  {
    double slack = std::numeric_limits<double>::infinity();
    for (const Surveyed &s : surveyed)
      {
        const CellMotion motion   = motion_of(topology, state, s.cell);
        double           distance = 0;
        for (unsigned int c = 0; c < n_corners; ++c)
          distance =
            std::max(distance, norm(motion.positions[c] - s.positions[c]));
        distance += time_step * largest_speed(motion);
        if (distance <= .5 * s.margin)
          slack = std::min(slack, s.margin - distance);
        else
          news.push_back(s.cell);
      }
    next_survey = path + slack;
  }

  double
  ContactForce::fastest_of(const State                  &state,
                           const double                  time_step,
                           const std::vector<CellIndex> &cells) const
  {
    double fastest = 0;
    for (const CellIndex cell : cells)
      {
        const CellMotion motion = motion_of(topology, state, cell);
        const double     speed  = largest_speed(motion);
        if (!(time_step * speed <= .5 * longest_edge(motion.positions)))
          fastest = std::max(fastest, speed);
      }
    return communicator.max(fastest);
  }

  ContactCell
  ContactForce::survey(const State    &state,
                       const double    time_step,
                       const CellIndex cell)
  {
    ContactCell  result = surface.describe(state, cell, communicator.rank());
    const double move =
      time_step * largest_speed(motion_of(topology, state, cell));
    result.included_at = never_included;
    result.constants   = interface.cells[cell];
    result.stiffness   = interface.stiffnesses.of_cell(cell, known_nodes);
    result.margin =
      std::max(margin_per_size * longest_edge(result.positions), 2 * move);
    next_survey = std::min(next_survey, path + result.margin - move);

    std::uint32_t &place = surveyed_at[cell];
    if (place == invalid_index)
      {
        place = static_cast<std::uint32_t>(surveyed.size());
        surveyed.emplace_back();
      }
    surveyed[place] = {cell, result.positions, result.margin, result.stiffness};
    return result;
  }

  double
  ContactForce::search(const State                  &state,
                       const double                  time_step,
                       std::vector<CellIndex>        news,
                       const std::vector<CellIndex> &included)
  {
    has_searched = true;
    if (rendezvous.needs_all())
      news = surface.cells();
    std::sort(news.begin(), news.end());
    news.erase(std::unique(news.begin(), news.end()), news.end());
    const double             fastest = fastest_of(state, time_step, news);
    std::vector<ContactCell> cells;
    for (const CellIndex cell : news)
      {
        cells.push_back(survey(state, time_step, cell));
        if (std::binary_search(included.begin(), included.end(), cell))
          cells.back().included_at = state.step;
      }
    adopt(rendezvous.update(std::move(cells)), state.step);
    return fastest;
  }

  void
  ContactForce::adopt(const ContactNeighbourhood &neighbourhood,
                      const std::uint64_t         step)
  {
    for (const CellPair &of_two : neighbourhood.pairs)
      {
        const ContactCell &a = neighbourhood.cells[of_two.a],
                          &b = neighbourhood.cells[of_two.b];
        rift_check(a.cell < b.cell && a.owner >= 0 && b.owner >= 0);
        const CellPair pair = {take_in(a), take_in(b)};
        rift_check(members[pair.a].local != invalid_index ||
                   members[pair.b].local != invalid_index);
        if (members.connect(pair))
          found.push_back(
            {pair, a.included_at == step || b.included_at == step});
      }
    if (const auto positions = members.tidy(); !positions.empty())
      {
        sleeping.renumber(positions);
        for (ContactPair &pair : active)
          pair.cells = {positions[pair.cells.a], positions[pair.cells.b]};
        for (FoundPair &pair : found)
          pair.cells = {positions[pair.cells.a], positions[pair.cells.b]};
      }
    members.subscribe();
  }

  std::uint32_t
  ContactForce::take_in(const ContactCell &cell)
  {
    const std::uint32_t position = members.take_in(cell);
    // What was told of it may be older.
    if (cell.owner == communicator.rank())
      members.set_stiffness(
        position,
        surveyed[surveyed_at[members[position].local]].stiffness);
    return position;
  }

  ContactForce::PairName
  ContactForce::name_of(const CellPair &cells) const
  {
    return PairName(members[cells.a].cell) << 32 | members[cells.b].cell;
  }

  void
  ContactForce::add_to(State &state, Activity &activity, const double time_step)
  {
    receive(state, time_step);
    wake_pairs(state);
    for (const ContactPair &pair : active)
      members.pack(state, pair.cells);

    energies.elastic = ExactSum();
    std::vector<SleepingPairs::Pair>               parted;
    std::array<PairForces, PairKernel::chunk_size> forces;
    for (std::size_t begin = 0; begin < active.size();
         begin += PairKernel::chunk_size)
      {
        const auto n = static_cast<unsigned int>(
          std::min<std::size_t>(active.size() - begin, PairKernel::chunk_size));
        kernel.compute(members.motions(),
                       active.data() + begin,
                       n,
                       time_step,
                       forces.data());
        for (unsigned int i = 0; i < n; ++i)
          {
            const CellPair   &cells = active[begin + i].cells;
            const PairForces &f     = forces[i];
            if (f.is_deep || f.is_too_deep)
              note_depth(cells, f, state);
            if (members[cells.a].owner == communicator.rank())
              {
                energies.elastic.add(f.energy);
                energies.friction.add(f.friction_loss);
                energies.damping.add(f.damping_loss);
              }
            if (!f.overlaps)
              {
                parted.push_back({cells, no_axis});
                continue;
              }
            add_forces(cells.a, f.on_a, state, activity);
            add_forces(cells.b, f.on_b, state, activity);
          }
      }
    put_parted_to_sleep(state, parted);
  }

  void
  ContactForce::add_forces(const std::uint32_t member,
                           const NodalVector  *forces,
                           State              &state,
                           Activity           &activity) const
  {
    const CellIndex cell = members[member].local;
    if (cell == invalid_index)
      return;
    // Other cells around a node may be asleep though this one is not.
    const bool has_awake = activity.has_woken_neighbours(cell / batch_size);
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const NodeIndex node = topology.node(cell, c);
        state.force[node].row() += forces[c].row();
        if (!has_awake)
          activity.wake_node(topology, node);
      }
  }

  void
  ContactForce::count_pairs(const Topology             &topology,
                            std::vector<std::uint32_t> &n) const
  {
    for (const ContactPair &pair : active)
      if (const CellIndex a = members[pair.cells.a].local;
          a != invalid_index && topology.owns_cell(a))
        ++n[a];
  }

  std::uint64_t
  ContactForce::count_touching() const
  {
    std::int64_t number = 0;
    for (const ContactPair &pair : active)
      if (pair.memory.energy > 0 &&
          members[pair.cells.a].owner == communicator.rank())
        ++number;
    return static_cast<std::uint64_t>(communicator.sum(number));
  }

  std::vector<std::pair<std::string, double>>
  ContactForce::bytes() const
  {
    std::vector<std::pair<std::string, double>> parts;
    for (const auto &[name, bytes] :
         {std::make_pair("active pairs", bytes_of(active)),
          std::make_pair("sleeping pairs", sleeping.bytes()),
          std::make_pair("cells in pairs", members.bytes()),
          std::make_pair("cells in space", rendezvous.bytes())})
      parts.emplace_back(name,
                         communicator.sum(static_cast<std::int64_t>(bytes)));
    return parts;
  }
} // namespace rift
