#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/base/memory_use.h>
#include <rift/contact/contact_members.h>
#include <rift/contact/contact_surface.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rift
{
  namespace
  {
    /** What an owner tells of a cell in each step. */
    struct CellReport
    {
      CellMotion       motion;
      ContactStiffness stiffness;
    };
  } // namespace

  ContactMembers::ContactMembers(const Topology     &topology,
                                 const Communicator &communicator)
    : topology(topology)
    , communicator(communicator)
  {
  }

  std::uint32_t
  ContactMembers::take_in(const ContactCell &cell)
  {
    const auto [place, is_new] =
      position_by_name.try_emplace(cell.cell,
                                   static_cast<std::uint32_t>(members.size()));
    if (is_new)
      {
        members.push_back({cell.cell,
                           cell.owner,
                           cell.material,
                           cell.constants.mass,
                           cell.stiffness,
                           cell.margin,
                           topology.find_cell(cell.cell),
                           {},
                           0});
        own_cells.push_back(cell.owner == communicator.rank() ?
                              members.back().local :
                              invalid_index);
        packed.emplace_back();
        packed_after.push_back({0, 0});
      }
    else
      // The stiffness is newer here.
      members[place->second].margin = cell.margin;
    return place->second;
  }

  std::uint64_t
  ContactMembers::bytes() const
  {
    std::uint64_t sum = bytes_of(members) + bytes_of(position_by_name) +
                        bytes_of(own_cells) + bytes_of(packed) +
                        bytes_of(packed_after);
    for (const Member &member : members)
      sum += bytes_of(member.partners);
    return sum;
  }

  bool
  ContactMembers::connect(const CellPair &pair)
  {
    rift_check(members[pair.a].cell < members[pair.b].cell);
    auto &partners = members[pair.a].partners;
    if (std::find(partners.begin(), partners.end(), pair.b) != partners.end())
      return false;
    partners.push_back(pair.b);
    ++members[pair.a].n_pairs;
    ++members[pair.b].n_pairs;
    return true;
  }

  void
  ContactMembers::disconnect(const CellPair &pair)
  {
    auto      &partners = members[pair.a].partners;
    const auto place    = std::find(partners.begin(), partners.end(), pair.b);
    rift_check(place != partners.end());
    *place = partners.back();
    partners.pop_back();
    --members[pair.a].n_pairs;
    --members[pair.b].n_pairs;
  }

  std::vector<std::uint32_t>
  ContactMembers::tidy()
  {
    const auto n_idle =
      std::count_if(members.begin(), members.end(), [](const Member &m) {
        return m.n_pairs == 0;
      });
    if (2 * static_cast<std::size_t>(n_idle) < members.size() + 100)
      return {};
    std::vector<std::uint32_t> new_positions(members.size(), invalid_index);
    std::uint32_t              n = 0;
    position_by_name.clear();
    for (std::uint32_t i = 0; i < members.size(); ++i)
      if (members[i].n_pairs > 0)
        {
          new_positions[i] = n;
          position_by_name.emplace(members[i].cell, n);
          own_cells[n]    = own_cells[i];
          packed[n]       = packed[i];
          packed_after[n] = packed_after[i];
          if (n != i)
            members[n] = std::move(members[i]);
          ++n;
        }
    members.resize(n);
    own_cells.resize(n);
    packed.resize(n);
    packed_after.resize(n);
    for (Member &member : members)
      for (std::uint32_t &partner : member.partners)
        partner = new_positions[partner];
    return new_positions;
  }

  void
  ContactMembers::subscribe()
  {
    receivers.clear();
    senders.clear();
    std::map<int, std::vector<GlobalCellIndex>> wanted;
    std::map<int, Partner>                      asked;
    for (std::uint32_t i = 0; i < members.size(); ++i)
      if (const int owner = members[i].owner; owner != communicator.rank())
        {
          wanted[owner].push_back(members[i].cell);
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
  ContactMembers::set_stiffness(const std::uint32_t     position,
                                const ContactStiffness &stiffness)
  {
    ContactStiffness &known = members[position].stiffness;
    stiffnesses_have_changed |=
      known.per_area != stiffness.per_area || known.height != stiffness.height;
    known = stiffness;
  }

  void
  ContactMembers::set_stiffness_of(const GlobalCellIndex   cell,
                                   const ContactStiffness &stiffness)
  {
    const auto place = position_by_name.find(cell);
    if (place != position_by_name.end())
      set_stiffness(place->second, stiffness);
  }

  bool
  ContactMembers::have_stiffnesses_changed()
  {
    return std::exchange(stiffnesses_have_changed, false);
  }

  void
  ContactMembers::send(const State &state, const StiffnessOf &stiffness)
  {
    std::map<int, std::string> messages;
    for (const Partner &receiver : receivers)
      {
        std::vector<CellReport> of_cells;
        for (const CellIndex cell : receiver.cells)
          of_cells.push_back(
            {motion_of(topology, state, cell), stiffness(cell)});
        messages[receiver.rank] = to_bytes(of_cells);
      }
    std::map<int, std::size_t> sizes;
    for (const Partner &sender : senders)
      sizes[sender.rank] = sender.cells.size() * sizeof(CellReport);
    reports = communicator.start_exchange(std::move(messages), sizes);
  }

  void
  ContactMembers::receive()
  {
    ++n_exchanges;
    const auto received = reports.finish();
    for (const Partner &sender : senders)
      {
        const auto of_cells = from_bytes<CellReport>(received.at(sender.rank));
        rift_check(of_cells.size() == sender.cells.size());
        for (std::size_t i = 0; i < of_cells.size(); ++i)
          {
            const std::uint32_t position = sender.cells[i];
            packed[position]             = rift::pack(of_cells[i].motion);
            packed_after[position]       = {n_exchanges, n_exchanges};
            set_stiffness(position, of_cells[i].stiffness);
          }
      }
  }

  double
  ContactMembers::largest_told_speed() const
  {
    double largest = 0;
    for (const Partner &sender : senders)
      for (const std::uint32_t cell : sender.cells)
        for (const NodalVector &v : packed[cell].velocity)
          largest = std::max(largest, dot(v.vector(), v.vector()));
    return std::sqrt(largest);
  }

  void
  ContactMembers::pack(const State &state, const std::uint32_t position)
  {
    if (packed_after[position].velocities == n_exchanges)
      return;
    pack_positions(state, position);
    packed_after[position].velocities = n_exchanges;
    for (unsigned int c = 0; c < n_corners; ++c)
      packed[position].velocity[c] =
        state.velocity[topology.node(own_cells[position], c)];
  }

  void
  ContactMembers::pack_positions(const State        &state,
                                 const std::uint32_t position)
  {
    if (packed_after[position].positions == n_exchanges)
      return;
    const CellIndex cell = own_cells[position];
    rift_check(cell != invalid_index);
    packed_after[position].positions = n_exchanges;
    for (unsigned int c = 0; c < n_corners; ++c)
      {
        const NodeIndex node = topology.node(cell, c);
        packed[position].position[c].row() =
          state.reference[node].row() + state.displacement[node].row();
      }
  }
} // namespace rift
