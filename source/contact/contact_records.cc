#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_force.h>
#include <rift/contact/overlap_batch.h>

#include <algorithm>
#include <stdexcept>

// Looking at contact from outside: overlaps at the start, checkpoints.
namespace rift
{
  namespace
  {
    /** A pair of cells that may touch, for a checkpoint. */
    struct PairRecord
    {
      GlobalCellIndex a, b;
      double          initial_potential, slip[dim], stiffness, damping_force;
    };

    /** A cell that took part in the last search, and where it was then. */
    struct CellRecord
    {
      GlobalCellIndex cell;
      std::uint32_t   padding;
      double          positions[n_corners][dim];
    };
  } // namespace

  template <>
  struct HasPlainBytes<PairRecord> : std::true_type
  {
    static_assert(sizeof(PairRecord) == 2 * 4 + 6 * 8);
  };

  template <>
  struct HasPlainBytes<CellRecord> : std::true_type
  {
    static_assert(sizeof(CellRecord) == 2 * 4 + n_corners * dim * 8);
  };

  namespace
  {
    /** Bodies that are meshed side by side overlap by rounding alone; this much
     * of the smaller cell is a mistake. */
    constexpr double largest_overlap_at_start = 1e-9;

    std::string
    describe(const ContactCell                     &cell,
             const std::vector<MaterialParameters> &materials)
    {
      Vector3<double> centre{};
      for (const Vector3<double> &x : cell.motion.positions)
        centre += .25 * x;
      return "cell " + std::to_string(cell.cell) + " of " +
             materials[cell.material].name + " at (" + short_text(centre[0]) +
             ", " + short_text(centre[1]) + ", " + short_text(centre[2]) +
             ") m";
    }

    double
    volume(const Tetrahedron &t)
    {
      return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6;
    }
  } // namespace

  void
  ContactForce::refuse_overlaps(
    const std::vector<MaterialParameters> &materials) const
  {
    communicator.collectively([&] {
      std::vector<CellPair> all;
      for (const Pair &pair : pairs)
        all.push_back({pair.a, pair.b});
      const std::vector<CommonPart> parts = common_parts(packed_members(), all);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        {
          const ContactCell &a = members[pairs[i].a].cell,
                            &b = members[pairs[i].b].cell;
          const double common  = parts[i].volume;
          const double smaller =
            std::min(volume(a.motion.positions), volume(b.motion.positions));
          if (common > largest_overlap_at_start * smaller)
            throw InputError("bodies lie in each other at the start: " +
                             describe(a, materials) + " and " +
                             describe(b, materials) + " have " +
                             short_text(common) +
                             " m^3 in common. Move them apart in the mesh, or "
                             "set \"Contact = false\" in subsection Contact.");
        }
    });
  }

  void
  ContactForce::save(Archive &archive) const
  {
    std::vector<PairRecord> pair_records;
    for (const Pair &pair : pairs)
      {
        const ContactCell &a = members[pair.a].cell;
        if (a.owner != communicator.rank())
          continue;
        PairRecord record{a.cell,
                          members[pair.b].cell.cell,
                          pair.memory.initial_potential,
                          {},
                          pair.memory.stiffness,
                          pair.memory.damping_force};
        std::copy(pair.memory.slip.begin(),
                  pair.memory.slip.end(),
                  record.slip);
        pair_records.push_back(record);
      }
    archive.write_list("contact: pairs", pair_records);

    std::vector<CellRecord> cell_records;
    for (std::size_t i = 0; i < searched_cells.size(); ++i)
      {
        CellRecord record{topology.cell_global_indices[searched_cells[i]],
                          0,
                          {}};
        for (unsigned int c = 0; c < n_corners; ++c)
          std::copy(searched_positions[i][c].begin(),
                    searched_positions[i][c].end(),
                    record.positions[c]);
        cell_records.push_back(record);
      }
    archive.write_list("contact: searched cells", cell_records);
    const bool has_changed =
      communicator.any(interface.n_crack_events() != n_known_events);
    archive.write_value<std::uint64_t>("contact: cracks have changed",
                                       has_changed ? 1 : 0);
    archive.write_sum("contact: friction", energies.friction);
    archive.write_sum("contact: damping", energies.damping);
  }

  void
  ContactForce::load(const State &state, const Archive &archive)
  {
    has_searched = true;
    n_known_events =
      interface.n_crack_events() -
      archive.read_value<std::uint64_t>("contact: cracks have changed");
    energies.friction = archive.read_sum("contact: friction");
    energies.damping  = archive.read_sum("contact: damping");
    // Ranks may have had any cells.
    auto sorted_cells =
      archive.read_list<CellRecord>("contact: searched cells");
    std::sort(sorted_cells.begin(),
              sorted_cells.end(),
              [](const auto &x, const auto &y) { return x.cell < y.cell; });
    for (const CellRecord &record : sorted_cells)
      {
        const CellIndex cell = topology.find_cell(record.cell);
        if (cell == invalid_index || !topology.owns_cell(cell))
          continue;
        surface.include_cell(cell);
        searched_cells.push_back(cell);
        Tetrahedron positions;
        for (unsigned int c = 0; c < n_corners; ++c)
          std::copy(std::begin(record.positions[c]),
                    std::end(record.positions[c]),
                    positions[c].begin());
        searched_positions.push_back(positions);
      }

    auto sorted = archive.read_list<PairRecord>("contact: pairs");
    std::sort(sorted.begin(), sorted.end(), [](const auto &x, const auto &y) {
      return std::make_pair(x.a, x.b) < std::make_pair(y.a, y.b);
    });
    std::vector<Rendezvous::NamedPair> names;
    for (const PairRecord &record : sorted)
      names.emplace_back(record.a, record.b);
    adopt_pairs(rendezvous.join(own_cells(state, searched_cells), names));
    auto record = sorted.begin();
    for (Pair &pair : pairs)
      {
        record = std::find_if(record, sorted.end(), [&](const auto &r) {
          return r.a == members[pair.a].cell.cell &&
                 r.b == members[pair.b].cell.cell;
        });
        if (record == sorted.end())
          throw std::logic_error("a restored pair has no record");
        pair.memory.initial_potential = record->initial_potential;
        pair.memory.stiffness         = record->stiffness;
        pair.memory.damping_force     = record->damping_force;
        std::copy(std::begin(record->slip),
                  std::end(record->slip),
                  pair.memory.slip.begin());
      }
  }
} // namespace rift
