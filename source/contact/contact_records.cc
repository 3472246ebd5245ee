#include <rift/base/exceptions.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_force.h>

#include <algorithm>

// Looking at contact from outside: overlaps at the start, checkpoints.
namespace rift
{
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
    communicator.together([&] {
      for (const Pair &pair : pairs)
        {
          const ContactCell &a = members[pair.a].cell,
                            &b = members[pair.b].cell;
          const double common =
            overlap(a.motion.positions, b.motion.positions).volume;
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

  std::vector<ContactPairRecord>
  ContactForce::pair_records() const
  {
    std::vector<ContactPairRecord> records;
    for (const Pair &pair : pairs)
      {
        const ContactCell &a = members[pair.a].cell;
        if (a.owner != communicator.rank())
          continue;
        ContactPairRecord record{a.cell,
                                 members[pair.b].cell.cell,
                                 pair.memory.free_potential,
                                 {},
                                 pair.memory.stiffness,
                                 pair.memory.damper};
        std::copy(pair.memory.slip.begin(),
                  pair.memory.slip.end(),
                  record.slip);
        records.push_back(record);
      }
    return records;
  }

  std::vector<ContactCellRecord>
  ContactForce::cell_records() const
  {
    std::vector<ContactCellRecord> records;
    for (std::size_t i = 0; i < searched_cells.size(); ++i)
      {
        ContactCellRecord record{
          topology.cell_global_indices[searched_cells[i]],
          0,
          {}};
        for (unsigned int c = 0; c < n_corners; ++c)
          std::copy(searched_positions[i][c].begin(),
                    searched_positions[i][c].end(),
                    record.positions[c]);
        records.push_back(record);
      }
    return records;
  }

  bool
  ContactForce::has_changed() const
  {
    return communicator.any(interface.n_crack_events() != n_known_events);
  }

  void
  ContactForce::restore(const State                          &state,
                        const std::vector<ContactPairRecord> &pair_records,
                        const std::vector<ContactCellRecord> &cell_records,
                        const bool                            has_changed)
  {
    has_searched   = true;
    n_known_events = interface.n_crack_events() - (has_changed ? 1 : 0);
    // Ranks may have had any cells.
    std::vector<ContactCellRecord> sorted_cells = cell_records;
    std::sort(sorted_cells.begin(),
              sorted_cells.end(),
              [](const auto &x, const auto &y) { return x.cell < y.cell; });
    for (const ContactCellRecord &record : sorted_cells)
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

    std::vector<ContactPairRecord> sorted = pair_records;
    std::sort(sorted.begin(), sorted.end(), [](const auto &x, const auto &y) {
      return std::make_pair(x.a, x.b) < std::make_pair(y.a, y.b);
    });
    std::vector<Rendezvous::NamedPair> names;
    for (const ContactPairRecord &record : sorted)
      names.emplace_back(record.a, record.b);
    take(rendezvous.join(own_cells(state, searched_cells), names));
    auto record = sorted.begin();
    for (Pair &pair : pairs)
      {
        while (record->a != members[pair.a].cell.cell ||
               record->b != members[pair.b].cell.cell)
          ++record;
        pair.memory.free_potential = record->free_potential;
        pair.memory.stiffness      = record->stiffness;
        pair.memory.damper         = record->damper;
        std::copy(std::begin(record->slip),
                  std::end(record->slip),
                  pair.memory.slip.begin());
      }
  }
} // namespace rift
