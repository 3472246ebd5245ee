#include <rift/bonds/node_insertion.h>

// What a checkpoint keeps of the search for cracks.
namespace rift
{
  namespace
  {
    /** A node by its first cell, or any corner of a cell. */
    struct CornerName
    {
      GlobalCellIndex cell;
      std::uint32_t   corner;
    };

    struct CandidateRecord
    {
      CornerName              node;
      double                  demand;
      SymmetricTensor<double> stress;
    };

    /** What a neighbour knows of a candidate. */
    struct DemandRecord
    {
      CornerName corner;
      double     demand;
    };

    /** A face that is cut in the next step. */
    struct DueFaceRecord
    {
      CrackPlanes::FaceSides face;
      Vector3<double>        plane;
    };

    /** A plane that takes part from the next step on. */
    struct DuePlaneRecord
    {
      CornerName      corner;
      Vector3<double> normal;
      double          area;
    };

    /** A node that could not be cut. */
    struct WaitRecord
    {
      CornerName    node;
      std::uint64_t next_look;
    };
  } // namespace

  template <>
  struct HasPlainBytes<CandidateRecord> : std::true_type
  {
    static_assert(sizeof(CandidateRecord) == 8 + 7 * sizeof(double));
  };

  template <>
  struct HasPlainBytes<DemandRecord> : std::true_type
  {
    static_assert(sizeof(DemandRecord) == 8 + sizeof(double));
  };

  template <>
  struct HasPlainBytes<DueFaceRecord> : std::true_type
  {
    static_assert(sizeof(DueFaceRecord) == 16 + 3 * sizeof(double));
  };

  template <>
  struct HasPlainBytes<DuePlaneRecord> : std::true_type
  {
    static_assert(sizeof(DuePlaneRecord) == 8 + 4 * sizeof(double));
  };

  void
  NodeInsertion::save(const State &state, Archive &archive) const
  {
    const auto corner_name = [this](const StarCell &at) {
      return CornerName{topology.cell_global_indices[at.cell], at.corner};
    };
    std::vector<CandidateRecord> of_candidates;
    std::vector<DemandRecord>    of_demands;
    for (const CrackCandidate &candidate : candidates)
      if (topology.owns_node(candidate.node))
        {
          const auto cells = cells_at_node(topology, candidate.node);
          of_candidates.push_back(
            {corner_name(cells[0]), candidate.demand, candidate.stress});
          for (const StarCell &cell : cells)
            of_demands.push_back({corner_name(cell), candidate.demand});
        }
    archive.write_list("crack candidates", of_candidates);
    archive.write_list("crack demands", of_demands);

    std::vector<DueFaceRecord> of_faces;
    for (const DueFace &next : due)
      if (topology.owns_face(next.face))
        of_faces.push_back(
          {CrackPlanes::sides_of(topology, next.face), next.plane});
    archive.write_list("crack faces due", of_faces);

    std::vector<DuePlaneRecord> of_planes;
    for (const auto &[vertex, parts] : due_planes)
      if (topology.owns_node(vertex))
        for (const CellIndex *cell = topology.vertex_cells_first(vertex);
             cell != topology.vertex_cells_last(vertex);
             ++cell)
          for (const CrackPlanes::Part &part : parts)
            of_planes.push_back({{topology.cell_global_indices[*cell],
                                  topology.corner_at_vertex(*cell, vertex)},
                                 part.normal,
                                 part.area});
    archive.write_list("crack planes due", of_planes);

    std::vector<WaitRecord> of_waiting;
    for (NodeIndex node = 0; node < next_look.size(); ++node)
      if (next_look[node] > state.step && topology.owns_node(node))
        of_waiting.push_back(
          {corner_name(cells_at_node(topology, node)[0]), next_look[node]});
    archive.write_list("nodes not looked at", of_waiting);
  }

  void
  NodeInsertion::load(const Archive &archive)
  {
    demands.resize(topology.n_nodes(), 0);
    next_look.resize(topology.n_nodes(), 0);
    const auto find_node = [this](const CornerName &name) {
      const CellIndex cell = topology.find_cell(name.cell);
      return cell == invalid_index ? static_cast<NodeIndex>(invalid_index) :
                                     topology.node(cell, name.corner);
    };
    const auto find_complete = [&](const CornerName &name) {
      const NodeIndex node = find_node(name);
      return node != invalid_index &&
                 topology.is_complete(topology.node_vertices[node]) ?
               node :
               static_cast<NodeIndex>(invalid_index);
    };
    for (const auto &record :
         archive.read_list<CandidateRecord>("crack candidates"))
      if (const NodeIndex node = find_complete(record.node);
          node != invalid_index)
        candidates.push_back({node, record.demand, record.stress});
    for (const auto &record : archive.read_list<DemandRecord>("crack demands"))
      if (const NodeIndex node = find_node(record.corner);
          node != invalid_index)
        set_demand(node, record.demand);
    for (const auto &record :
         archive.read_list<DueFaceRecord>("crack faces due"))
      if (const FaceIndex face = planes.find(topology, record.face);
          face != invalid_index)
        due.push_back({face, record.plane});
    for (const auto &record :
         archive.read_list<DuePlaneRecord>("crack planes due"))
      if (const NodeIndex node = find_node(record.corner);
          node != invalid_index)
        add_plane(topology.node_vertices[node], {record.normal, record.area});
    for (const auto &record :
         archive.read_list<WaitRecord>("nodes not looked at"))
      if (const NodeIndex node = find_complete(record.node);
          node != invalid_index)
        next_look[node] = record.next_look;
  }
} // namespace rift
