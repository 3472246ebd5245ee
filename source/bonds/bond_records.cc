#include <rift/bonds/bonds.h>
#include <rift/bonds/node_star.h>

#include <algorithm>
#include <map>

// What a checkpoint keeps of bonds.
namespace rift
{
  std::vector<BondRecord>
  Bonds::records() const
  {
    std::vector<BondRecord> result;
    for (const VertexBonds &group : groups)
      for (std::size_t i = 0; i < group.bonds.size(); ++i)
        if (topology.owns_node(group.parts[0].node))
          {
            const Bond        &bond    = group.bonds[i];
            const BondHistory &history = group.histories[i];
            BondRecord         record{};
            for (unsigned int side = 0; side < 2; ++side)
              {
                const StarCell first =
                  cells_at_node(topology,
                                group.parts[bond.parts[side]].node)[0];
                record.cells[side]   = topology.cell_global_indices[first.cell];
                record.corners[side] = first.corner;
              }
            record.is_tied        = bond.is_tied ? 1 : 0;
            record.is_released    = bond.is_released ? 1 : 0;
            record.is_yielding    = group.is_yielding ? 1 : 0;
            record.plane          = history.plane;
            record.normal         = bond.normal;
            record.traction       = bond.traction;
            record.damage         = history.memory.damage;
            record.slip_damage    = history.memory.slip_damage;
            record.excess         = history.memory.excess;
            record.gap            = bond.gap;
            record.pressure_share = bond.pressure_share;
            record.energy         = group.energy;
            result.push_back(record);
          }
    return result;
  }

  void
  Bonds::restore(const State &state, const std::vector<BondRecord> &records)
  {
    std::map<std::pair<NodeIndex, NodeIndex>, const BondRecord *> by_nodes;
    std::vector<VertexIndex>                                      vertices;
    for (const BondRecord &record : records)
      {
        const CellIndex a = topology.find_cell(record.cells[0]),
                        b = topology.find_cell(record.cells[1]);
        if (a == invalid_index || b == invalid_index)
          continue;
        const NodeIndex nodes[2] = {topology.node(a, record.corners[0]),
                                    topology.node(b, record.corners[1])};
        if (!topology.is_complete(topology.node_vertices[nodes[0]]))
          continue;
        by_nodes[{nodes[0], nodes[1]}] = &record;
        vertices.push_back(topology.node_vertices[nodes[0]]);
      }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()),
                   vertices.end());
    for (const VertexIndex vertex : vertices)
      {
        group_of_vertex[vertex] = static_cast<std::uint32_t>(groups.size());
        groups.push_back(make_group(
          state,
          vertex,
          [&](const NodeIndex first,
              const NodeIndex second) -> std::optional<KnownBond> {
            const BondRecord &record = *by_nodes.at({first, second});
            KnownBond         known;
            BondLaw::Memory  &memory = known.history.memory;
            known.history.plane      = record.plane;
            known.bond.traction      = record.traction;
            memory.damage            = record.damage;
            memory.slip_damage       = record.slip_damage;
            memory.excess            = record.excess;
            memory.softening         = solver.law.softening_at(record.damage);
            known.bond.is_tied       = record.is_tied != 0;
            known.bond.is_released   = record.is_released != 0;
            return known;
          }));
        VertexBonds &group = groups.back();
        for (Bond &bond : group.bonds)
          {
            const BondRecord &record =
              *by_nodes.at({group.parts[bond.parts[0]].node,
                            group.parts[bond.parts[1]].node});
            // These are of the last step in which the normal has turned or the
            // nodes have moved against each other.
            bond.normal         = record.normal;
            bond.gap            = record.gap;
            bond.pressure_share = record.pressure_share;
            group.is_yielding   = record.is_yielding != 0;
            group.energy        = record.energy;
          }
      }
  }
} // namespace rift
