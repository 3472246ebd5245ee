#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_force.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

// Looking at contact from outside: overlaps at the start, checkpoints.
namespace rift
{
  namespace
  {
    /** What a pair of cells that nothing parts remembers, for a checkpoint. */
    struct PairRecord
    {
      GlobalCellIndex a, b;
      double          initial_potential, slip[dim], stiffness, damping_force;
      double          penalty, energy;
    };

    /** DeepOverlap, for a checkpoint. */
    struct DeepRecord
    {
      GlobalCellIndex a, b;
      std::uint64_t   step;
      double          time, place[dim];
    };
  } // namespace

  template <>
  struct HasPlainBytes<PairRecord> : std::true_type
  {
    static_assert(sizeof(PairRecord) == 2 * 4 + 8 * 8);
  };

  template <>
  struct HasPlainBytes<DeepRecord> : std::true_type
  {
    static_assert(sizeof(DeepRecord) == 2 * 4 + 5 * 8);
  };

  namespace
  {
    /** Bodies that are meshed side by side overlap by rounding alone; this much
     * of the smaller cell is a mistake. */
    constexpr double largest_overlap_at_start = 1e-9;

    std::string
    describe(const ContactMembers                  &members,
             const std::uint32_t                    position,
             const std::vector<MaterialParameters> &materials)
    {
      const ContactMembers::Member &cell = members[position];
      Vector3<double>               centre{};
      for (const NodalVector &x : members.motions()[position].position)
        centre += .25 * x.vector();
      return "cell " + std::to_string(cell.cell) + " of " +
             materials[cell.material].name + " at (" + short_text(centre[0]) +
             ", " + short_text(centre[1]) + ", " + short_text(centre[2]) +
             ") m";
    }
  } // namespace

  void
  ContactForce::refuse_overlaps(
    const State                           &state,
    const std::vector<MaterialParameters> &materials)
  {
    receive(state, 0);
    communicator.collectively([&] {
      std::vector<CellPair> pairs;
      for (const ContactPair &pair : active)
        pairs.push_back(pair.cells);
      const std::vector<CommonPart> parts =
        common_parts(members.motions(), pairs);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        {
          if (parts[i].volume_fraction > largest_overlap_at_start)
            throw InputError("bodies lie in each other at the start: " +
                             describe(members, pairs[i].a, materials) +
                             " and " +
                             describe(members, pairs[i].b, materials) +
                             " have " + short_text(parts[i].volume) +
                             " m^3 in common. Move them apart in the mesh, or "
                             "set \"Contact = false\" in subsection Contact.");
        }
    });
  }

  void
  ContactForce::note_depth(const CellPair   &cells,
                           const PairForces &forces,
                           const State      &state)
  {
    Vector3<double> place{};
    for (const std::uint32_t member : {cells.a, cells.b})
      {
        for (const NodalVector &x : members.motions()[member].position)
          place += 1. / (2 * n_corners) * x.vector();
        if (forces.is_deep && members[member].local != invalid_index)
          deep_cells.push_back(members[member].local);
      }
    const ContactMembers::Member &a = members[cells.a];
    if (forces.is_too_deep && a.owner == communicator.rank())
      too_deep.try_emplace(name_of(cells),
                           DeepOverlap{a.cell,
                                       members[cells.b].cell,
                                       state.step,
                                       state.time,
                                       place});
  }

  std::optional<ContactForce::DeepOverlaps>
  ContactForce::deep_overlaps() const
  {
    const auto comes_before = [](const DeepOverlap &x, const DeepOverlap &y) {
      return std::make_tuple(x.step, x.a, x.b) <
             std::make_tuple(y.step, y.a, y.b);
    };
    DeepOverlap first{};
    first.step = std::numeric_limits<std::uint64_t>::max();
    for (const auto &[name, overlap] : too_deep)
      if (comes_before(overlap, first))
        first = overlap;
    const std::int64_t n_pairs =
      communicator.sum(static_cast<std::int64_t>(too_deep.size()));
    if (n_pairs == 0)
      return {};
    return DeepOverlaps{n_pairs,
                        communicator.first_of_ranks(first, comes_before)};
  }

  void
  ContactForce::save(Archive &archive) const
  {
    std::vector<PairRecord> records;
    for (const ContactPair &pair : active)
      {
        const ContactMembers::Member &a = members[pair.cells.a];
        if (a.owner != communicator.rank())
          continue;
        PairRecord record{a.cell,
                          members[pair.cells.b].cell,
                          pair.memory.initial_potential,
                          {},
                          pair.memory.stiffness,
                          pair.memory.damping_force,
                          pair.memory.penalty,
                          pair.memory.energy};
        std::copy(pair.memory.slip.begin(),
                  pair.memory.slip.end(),
                  record.slip);
        records.push_back(record);
      }
    archive.write_list("contact: pairs", records);
    std::vector<GlobalCellIndex> names;
    for (const auto &[cells, may_overlap] : found)
      if (may_overlap && members[cells.a].owner == communicator.rank())
        for (const std::uint32_t member : {cells.a, cells.b})
          names.push_back(members[member].cell);
    archive.write_list("contact: pairs that may overlap", names);
    archive.write_value("contact: time step", last_time_step);
    surface.save(archive);
    std::vector<DeepRecord> deep;
    for (const auto &[name, overlap] : too_deep)
      deep.push_back({overlap.a,
                      overlap.b,
                      overlap.step,
                      overlap.time,
                      {overlap.place[0], overlap.place[1], overlap.place[2]}});
    archive.write_list("contact: pairs that have been too deep", deep);
    archive.write_sum("contact: friction", energies.friction);
    archive.write_sum("contact: damping", energies.damping);
  }

  void
  ContactForce::load(const State &state, const Archive &archive)
  {
    energies.friction = archive.read_sum("contact: friction");
    energies.damping  = archive.read_sum("contact: damping");
    surface.load(state, archive);
    for (const DeepRecord &r : archive.read_list<DeepRecord>(
           "contact: pairs that have been too deep"))
      if (const CellIndex a = topology.find_cell(r.a);
          a != invalid_index && topology.owns_cell(a))
        too_deep[PairName(r.a) << 32 | r.b] =
          {r.a, r.b, r.step, r.time, {{r.place[0], r.place[1], r.place[2]}}};
    // Pairs may have parted, or may meet, by the way of a step.
    search(state,
           archive.read_value<double>("contact: time step"),
           surface.cells(),
           {});

    std::unordered_map<PairName, ContactMemory> memories;
    for (const PairRecord &record :
         archive.read_list<PairRecord>("contact: pairs"))
      memories[PairName(record.a) << 32 | record.b] = {
        record.initial_potential,
        {{record.slip[0], record.slip[1], record.slip[2]}},
        record.stiffness,
        record.damping_force,
        record.penalty,
        record.energy};
    std::set<PairName> may_overlap;
    const auto         names =
      archive.read_list<GlobalCellIndex>("contact: pairs that may overlap");
    for (std::size_t i = 0; i < names.size(); i += 2)
      may_overlap.insert(PairName(names[i]) << 32 | names[i + 1]);
    // Some have parted since their forces were computed last, others have met.
    std::vector<ContactPair> restored;
    std::vector<FoundPair>   others;
    for (const FoundPair &pair : found)
      {
        const PairName name = name_of(pair.cells);
        if (const auto memory = memories.find(name); memory != memories.end())
          {
            restored.push_back(make_pair(pair.cells));
            restored.back().memory = memory->second;
          }
        else
          others.push_back({pair.cells, may_overlap.count(name) > 0});
      }
    found = std::move(others);
    merge(std::move(restored));
    send(state);
    receive(state, 0);
  }
} // namespace rift
