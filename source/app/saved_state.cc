#include <rift/app/saved_state.h>

#include <algorithm>
#include <sstream>

namespace rift
{
  template <>
  struct HasPlainBytes<NodeRecord> : std::true_type
  {
    static_assert(sizeof(NodeRecord) == 2 * 4 + 2 * dim * 8);
  };

  template <>
  struct HasPlainBytes<CohesiveFaceRecord> : std::true_type
  {
    static_assert(sizeof(CohesiveFaceRecord) == 2 * 4 + 7 * 8);
  };

  template <>
  struct HasPlainBytes<ContactPairRecord> : std::true_type
  {
    static_assert(sizeof(ContactPairRecord) == 2 * 4 + 6 * 8);
  };

  template <>
  struct HasPlainBytes<ContactCellRecord> : std::true_type
  {
    static_assert(sizeof(ContactCellRecord) == 2 * 4 + n_corners * dim * 8);
  };

  template <>
  struct HasPlainBytes<RigidBodyRecord> : std::true_type
  {
    static_assert(sizeof(RigidBodyRecord) == 13 * 8);
  };

  namespace
  {
    template <typename T>
    void
    append(std::vector<T> &to, const std::vector<T> &more)
    {
      to.insert(to.end(), more.begin(), more.end());
    }

    /** The owned nodes, each by the first cell and corner that has it. */
    std::vector<NodeRecord>
    node_records(const Topology &topology, const State &state)
    {
      std::vector<NodeRecord>   records;
      std::vector<std::uint8_t> is_known(topology.n_nodes(), 0);
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell);
             ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            if (is_known[node] || !topology.owns_node(node))
              continue;
            is_known[node] = 1;
            NodeRecord record{topology.cell_global_indices[cell], c, {}, {}};
            for (unsigned int d = 0; d < dim; ++d)
              {
                record.displacement[d] = state.displacement[node][d];
                record.velocity[d]     = state.velocity[node][d];
              }
            records.push_back(record);
          }
      return records;
    }

    void
    move_nodes(const std::vector<NodeRecord> &records,
               const Topology                &topology,
               State                         &state,
               Activity                      &activity)
    {
      for (const NodeRecord &record : records)
        {
          const CellIndex cell = topology.find_cell(record.cell);
          if (cell == invalid_index)
            continue;
          // Where a vertex is incomplete, the first cell of the node may not
          // be here; the exchange brings those.
          const NodeIndex node = topology.node(cell, record.corner);
          if (!topology.is_complete(topology.node_vertices[node]))
            continue;
          bool moves = false;
          for (unsigned int d = 0; d < dim; ++d)
            {
              state.displacement[node][d] = record.displacement[d];
              state.velocity[node][d]     = record.velocity[d];
              moves |= record.displacement[d] != 0 || record.velocity[d] != 0;
            }
          if (moves)
            activity.wake_node(topology, node);
        }
    }
  } // namespace

  void
  SavedState::write(CheckpointFileWriter &file) const
  {
    file.write("nodes", nodes);
    file.write("cut faces", cut_faces);
    file.write("cohesive faces", cohesive_faces.faces);
    std::string names;
    for (const auto &[name, numbers] : cohesive_faces.points)
      {
        file.write("cohesive " + name, numbers);
        names += name + "\n";
      }
    file.write_text("cohesive fields", names);
    file.write("contact pairs", contact_pairs);
    file.write("contact cells", contact_cells);
    file.write("rigid bodies", rigid_bodies);
    file.write("hot cells", hot_cells);
    file.write("resting cells", resting_cells);
  }

  void
  SavedState::read(const CheckpointFileReader &file)
  {
    append(nodes, file.read<NodeRecord>("nodes"));
    append(cut_faces, file.read<CutFaceRecord>("cut faces"));
    append(cohesive_faces.faces,
           file.read<CohesiveFaceRecord>("cohesive faces"));
    std::istringstream names(file.read_text("cohesive fields"));
    for (std::string name; std::getline(names, name);)
      append(cohesive_faces.points[name],
             file.read<double>("cohesive " + name));
    append(contact_pairs, file.read<ContactPairRecord>("contact pairs"));
    append(contact_cells, file.read<ContactCellRecord>("contact cells"));
    append(rigid_bodies, file.read<RigidBodyRecord>("rigid bodies"));
    append(hot_cells, file.read<GlobalCellIndex>("hot cells"));
    append(resting_cells, file.read<GlobalCellIndex>("resting cells"));
  }

  SavedState
  save_body(const Discretization &discretization,
            const InternalForce  &internal_force,
            const Activity       &activity,
            const CohesiveForce  *cohesive_force,
            const ContactForce   *contact)
  {
    const Topology &topology = discretization.topology;
    SavedState      saved;
    saved.nodes = node_records(topology, discretization.state);
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (topology.owns_face(face) &&
          topology.face_states[face] != FaceState::intact)
        saved.cut_faces.push_back(
          {topology.face_name(face),
           static_cast<std::uint32_t>(topology.face_states[face])});
    if (cohesive_force != nullptr)
      saved.cohesive_faces = cohesive_force->records();
    if (contact != nullptr)
      {
        saved.contact_pairs = contact->pair_records();
        saved.contact_cells = contact->cell_records();
      }
    for (const CellIndex cell : internal_force.hot_cells())
      if (topology.owns_cell(cell))
        saved.hot_cells.push_back(topology.cell_global_indices[cell]);
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (topology.owns_cell(cell) && !activity.is_awake(cell / batch_size))
        saved.resting_cells.push_back(topology.cell_global_indices[cell]);
    return saved;
  }

  void
  restore_nodes(const SavedState          &saved,
                const std::vector<double> &densities,
                Discretization            &discretization,
                Activity                  &activity)
  {
    auto &[topology, reference, state, exchange] = discretization;
    std::vector<FaceIndex> faces;
    for (const CutFaceRecord &record : saved.cut_faces)
      if (const FaceIndex face = topology.find_face(record.face);
          face != invalid_index)
        faces.push_back(face);
    std::sort(faces.begin(), faces.end());

    const TopologyChange change = split_nodes(topology, faces);
    state.grow(change);
    for (const NodeSplit &split : change.splits)
      for (const NodeIndex part : split.parts)
        state.mass[part] = lumped_mass(topology, reference, densities, part);
    for (const CutFaceRecord &record : saved.cut_faces)
      if (const FaceIndex face = topology.find_face(record.face);
          face != invalid_index)
        topology.face_states[face] = static_cast<FaceState>(record.state);

    activity.grow(topology.n_nodes());
    move_nodes(saved.nodes, topology, state, activity);
    exchange.send(topology, state, change.splits, {});
    exchange.receive(topology, state, activity);
  }

  std::vector<double>
  cell_costs(const SavedState &saved,
             const std::size_t n_cells,
             const double      face_cost)
  {
    // Looking whether a batch is at rest takes a little, too.
    constexpr double    resting_cost = .02;
    std::vector<double> costs(n_cells, 1.);
    for (const GlobalCellIndex cell : saved.resting_cells)
      costs[cell] = resting_cost;
    for (const CohesiveFaceRecord &record : saved.cohesive_faces.faces)
      costs[record.face.cell] += face_cost;
    return costs;
  }
} // namespace rift
