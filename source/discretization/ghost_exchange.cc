#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/discretization/ghost_exchange.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

namespace rift
{
  namespace
  {
    /** A corner by names that all ranks understand. */
    struct NamedCorner
    {
      GlobalCellIndex cell;
      std::uint32_t   corner;
    };

    template <typename List>
    typename List::const_iterator
    find_vertex(const List &list, const VertexIndex vertex)
    {
      const auto at =
        std::lower_bound(list.begin(),
                         list.end(),
                         vertex,
                         [](const auto &entry, const VertexIndex v) {
                           return entry.vertex < v;
                         });
      return at != list.end() && at->vertex == vertex ? at : list.end();
    }

    /** Whether the vertices of a list ascend and occur once. */
    template <typename List>
    bool
    do_vertices_ascend(const List &list)
    {
      for (std::size_t i = 1; i < list.size(); ++i)
        if (list[i].vertex <= list[i - 1].vertex)
          return false;
      return true;
    }

    /** Of all messages here: there is one per step and pair of ranks. */
    constexpr int tag = 3;
  } // namespace

  GhostExchange::GhostExchange(const Communicator &the_communicator,
                               Topology           &topology)
    : communicator(the_communicator.mpi())
  {
    if (the_communicator.size() == 1)
      return;
    request_nodes(the_communicator, topology);
    name_first_nodes(the_communicator, topology);
  }

  void
  GhostExchange::include_velocities()
  {
    has_velocities = true;
  }

  void
  GhostExchange::request_nodes(const Communicator &the_communicator,
                               const Topology     &topology)
  {
    std::map<int, std::vector<NamedCorner>> questions;
    std::map<int, std::vector<CellCorner>>  asked;
    for (VertexIndex vertex = 0; vertex < topology.n_vertices(); ++vertex)
      {
        const auto first = topology.vertex_cells_first(vertex);
        const auto last  = topology.vertex_cells_last(vertex);
        if (first == last || topology.is_complete(vertex))
          continue;
        const int sender = topology.cell_owners[*first];
        rift_check(sender >= 0 && sender < the_communicator.size() &&
                   sender != the_communicator.rank());
        for (auto cell = first; cell != last; ++cell)
          {
            const unsigned int corner =
              topology.corner_at_vertex(*cell, vertex);
            asked[sender].push_back({*cell, static_cast<std::uint8_t>(corner)});
            questions[sender].push_back(
              {topology.cell_global_indices[*cell], corner});
          }
      }
    for (auto &[rank, corners] : asked)
      {
        Partner sender;
        sender.rank    = rank;
        sender.corners = std::move(corners);
        // As yet without numbers.
        sender.corner_nodes.assign(sender.corners.size(), invalid_index);
        senders.push_back(std::move(sender));
      }

    for (const auto &[rank, asked_here] : the_communicator.exchange(questions))
      {
        Partner receiver;
        receiver.rank = rank;
        for (const NamedCorner &named : asked_here)
          {
            const CellIndex cell = topology.find_cell(named.cell);
            rift_check(cell != invalid_index);
            const auto i = static_cast<std::uint32_t>(receiver.corners.size());
            const VertexIndex vertex = topology.vertex(cell, named.corner);
            rift_check(topology.is_complete(vertex));
            if (receiver.vertices.empty() ||
                receiver.vertices.back().vertex != vertex)
              receiver.vertices.push_back({vertex, i, i});
            ++receiver.vertices.back().end;
            receiver.corners.push_back(
              {cell, static_cast<std::uint8_t>(named.corner)});
          }
        receiver.corner_nodes.assign(receiver.corners.size(), invalid_index);
        receivers.push_back(std::move(receiver));
      }
  }

  std::vector<GhostExchange::ChangedCorner>
  GhostExchange::number_nodes(const Topology      &topology,
                              Partner             &receiver,
                              const VertexCorners &at_vertex)
  {
    std::vector<ChangedCorner> changed;
    const auto                 number = [&](const NodeIndex node) {
      for (std::uint32_t i = at_vertex.begin; i < at_vertex.end; ++i)
        {
          const std::uint32_t known = receiver.corner_nodes[i];
          if (known != invalid_index && receiver.nodes[known] == node)
            return known;
        }
      receiver.nodes.push_back(node);
      return static_cast<std::uint32_t>(receiver.nodes.size() - 1);
    };
    for (std::uint32_t i = at_vertex.begin; i < at_vertex.end; ++i)
      {
        const auto [cell, corner]  = receiver.corners[i];
        const std::uint32_t former = receiver.corner_nodes[i];
        const NodeIndex     node   = topology.node(cell, corner);
        if (former != invalid_index && receiver.nodes[former] == node)
          continue;
        receiver.corner_nodes[i] = number(node);
        changed.push_back({i, receiver.corner_nodes[i]});
      }
    return changed;
  }

  NodeIndex
  GhostExchange::change_node(Topology           &topology,
                             Partner            &sender,
                             const ChangedCorner changed)
  {
    const auto [cell, corner] = sender.corners[changed.corner];
    NodeIndex &node =
      topology.batches[cell / batch_size].corner[corner][cell % batch_size];
    const NodeIndex old = node;
    rift_check(changed.node <= sender.nodes.size());
    if (changed.node == sender.nodes.size())
      {
        sender.nodes.push_back(static_cast<NodeIndex>(topology.n_nodes()));
        topology.node_vertices.push_back(topology.node_vertices[old]);
      }
    sender.corner_nodes[changed.corner] = changed.node;
    node                                = sender.nodes[changed.node];
    rift_check(topology.node_vertices[node] == topology.node_vertices[old]);
    return old;
  }

  void
  GhostExchange::name_first_nodes(const Communicator &the_communicator,
                                  Topology           &topology)
  {
    std::map<int, std::vector<std::uint32_t>> answers;
    for (Partner &receiver : receivers)
      {
        for (const VertexCorners &at_vertex : receiver.vertices)
          number_nodes(topology, receiver, at_vertex);
        answers[receiver.rank] = receiver.corner_nodes;
        // In this order they are found again.
        std::sort(receiver.vertices.begin(),
                  receiver.vertices.end(),
                  [](const VertexCorners &a, const VertexCorners &b) {
                    return a.vertex < b.vertex;
                  });
        rift_check(do_vertices_ascend(receiver.vertices));
      }
    const auto numbers = the_communicator.exchange(answers);
    for (Partner &sender : senders)
      {
        const auto &of_corners  = numbers.at(sender.rank);
        VertexIndex last_vertex = invalid_index;
        rift_check(of_corners.size() == sender.corners.size());
        for (std::uint32_t i = 0; i < of_corners.size(); ++i)
          {
            const auto [cell, corner] = sender.corners[i];
            const NodeIndex   node    = topology.node(cell, corner);
            const VertexIndex vertex  = topology.node_vertices[node];
            // The first one has been there from the start.
            if (vertex != last_vertex)
              sender.nodes.push_back(node);
            last_vertex = vertex;
            change_node(topology, sender, {i, of_corners[i]});
          }
      }
  }

  std::vector<GhostExchange::OpeningMessage>
  GhostExchange::select_openings(const Topology                   &topology,
                                 const Partner                    &receiver,
                                 const std::vector<OpeningCorner> &openings)
  {
    std::vector<OpeningMessage> told;
    for (const OpeningCorner &opening : openings)
      {
        const Face        &face = topology.faces[opening.face];
        const unsigned int corner =
          face_corners[face.local_faces[0]][opening.corner];
        const VertexIndex vertex = topology.vertex(face.cells[0], corner);
        const auto        at     = find_vertex(receiver.vertices, vertex);
        if (at == receiver.vertices.end())
          continue;
        // The receiver has the face if it sees both of its cells.
        const auto sees = [&](const CellIndex cell) {
          return std::any_of(
            receiver.corners.begin() + at->begin,
            receiver.corners.begin() + at->end,
            [cell](const CellCorner &c) { return c.cell == cell; });
        };
        if (sees(face.cells[0]) && sees(face.cells[1]))
          told.push_back(
            {topology.cell_global_indices[face.cells[0]],
             face.local_faces[0],
             opening.corner,
             {opening.force[0], opening.force[1], opening.force[2]}});
      }
    return told;
  }

  std::vector<GhostExchange::NewsMessage>
  GhostExchange::select_news(const Topology                &topology,
                             const Partner                 &receiver,
                             const std::vector<CornerNews> &news)
  {
    std::vector<NewsMessage> told;
    for (const CornerNews &item : news)
      {
        const auto at = find_vertex(receiver.vertices,
                                    topology.vertex(item.cell, item.corner));
        if (at != receiver.vertices.end() &&
            std::any_of(receiver.corners.begin() + at->begin,
                        receiver.corners.begin() + at->end,
                        [&item](const CellCorner &corner) {
                          return corner.cell == item.cell;
                        }))
          told.push_back({topology.cell_global_indices[item.cell],
                          item.corner,
                          item.local_face,
                          item.kind,
                          0,
                          item.values});
      }
    return told;
  }

  void
  GhostExchange::send(const Topology                   &topology,
                      const State                      &state,
                      const std::vector<NodeSplit>     &splits,
                      const std::vector<OpeningCorner> &openings,
                      const std::vector<CornerNews>    &news)
  {
    for (Partner &receiver : receivers)
      {
        std::vector<ChangedCorner> changed;
        for (const NodeSplit &split : splits)
          {
            const VertexIndex vertex = topology.node_vertices[split.parts[0]];
            const auto        at     = find_vertex(receiver.vertices, vertex);
            if (at == receiver.vertices.end())
              continue;
            const auto here = number_nodes(topology, receiver, *at);
            changed.insert(changed.end(), here.begin(), here.end());
          }
        const auto         told = select_openings(topology, receiver, openings);
        const auto         selected = select_news(topology, receiver, news);
        const Header       header{static_cast<std::uint32_t>(changed.size()),
                            static_cast<std::uint32_t>(told.size()),
                            static_cast<std::uint32_t>(selected.size()),
                            0};
        std::vector<char> &buffer = receiver.buffer;
        buffer.clear();
        append(buffer, &header, 1);
        append(buffer, changed.data(), changed.size());
        append(buffer, told.data(), told.size());
        append(buffer, selected.data(), selected.size());
        for (const NodeIndex node : receiver.nodes)
          {
            append(buffer, state.displacement[node].v, dim);
            if (has_velocities)
              append(buffer, state.velocity[node].v, dim);
          }
        MPI_Isend(buffer.data(),
                  mpi_count(buffer.size()),
                  MPI_BYTE,
                  receiver.rank,
                  tag,
                  communicator,
                  &receiver.request);
      }
  }

  GhostExchange::Change
  GhostExchange::receive(Topology &topology, State &state, Activity &activity)
  {
    Change         change;
    TopologyChange new_nodes;
    for (Partner &sender : senders)
      {
        receive_bytes(sender);
        const char  *bytes  = sender.buffer.data();
        const Header header = take<Header>(bytes, 1)[0];
        for (const ChangedCorner changed :
             take<ChangedCorner>(bytes, header.n_changed))
          {
            const std::size_t n_before = topology.n_nodes();
            const NodeIndex   old      = change_node(topology, sender, changed);
            if (topology.n_nodes() > n_before)
              new_nodes.splits.push_back(
                {{old, static_cast<NodeIndex>(n_before)}});
            change.vertices.push_back(topology.node_vertices[old]);
          }
        for (const OpeningMessage &told :
             take<OpeningMessage>(bytes, header.n_openings))
          {
            const FaceIndex index =
              topology.find_face({told.minus_cell, told.local_face});
            rift_check(index != invalid_index &&
                       topology.face_states[index] != FaceState::intact);
            if (topology.needs_face(index))
              change.openings.push_back(
                {index,
                 static_cast<std::uint8_t>(told.corner),
                 {{told.force[0], told.force[1], told.force[2]}}});
          }
        for (const NewsMessage &told : take<NewsMessage>(bytes, header.n_news))
          change.news.push_back({topology.find_cell(told.cell),
                                 told.corner,
                                 told.local_face,
                                 told.kind,
                                 told.values});
        state.grow(new_nodes);
        for (const NodeSplit &split : new_nodes.splits)
          state.mass[split.parts[1]] = state.mass[split.parts[0]];
        new_nodes.splits.clear();
        rift_check(state.n_nodes() == topology.n_nodes());
        activity.grow(topology.n_nodes());
        rift_check(bytes + sender.nodes.size() * bytes_per_node() ==
                   sender.buffer.data() + sender.buffer.size());
        unpack_values(bytes, sender, topology, state, activity);
      }
    for (Partner &receiver : receivers)
      MPI_Wait(&receiver.request, MPI_STATUS_IGNORE);
    return change;
  }

  void
  GhostExchange::receive_bytes(Partner &sender) const
  {
    // How long it is depends on what a crack has changed.
    MPI_Status status;
    int        n_bytes = 0;
    MPI_Probe(sender.rank, tag, communicator, &status);
    MPI_Get_count(&status, MPI_BYTE, &n_bytes);
    sender.buffer.resize(n_bytes);
    MPI_Recv(sender.buffer.data(),
             n_bytes,
             MPI_BYTE,
             sender.rank,
             tag,
             communicator,
             MPI_STATUS_IGNORE);
  }

  void
  GhostExchange::unpack_values(const char     *values,
                               const Partner  &sender,
                               const Topology &topology,
                               State          &state,
                               Activity       &activity) const
  {
    const auto is_at_rest = [&](const NodeIndex node) {
      double largest = 0;
      for (unsigned int d = 0; d < dim; ++d)
        largest = std::max({largest,
                            std::abs(state.displacement[node][d]),
                            std::abs(state.velocity[node][d])});
      return largest == 0;
    };
    for (const NodeIndex node : sender.nodes)
      {
        // What has moved once has woken its cells.
        const bool was_at_rest = is_at_rest(node);
        std::memcpy(state.displacement[node].v, values, dim * sizeof(double));
        values += dim * sizeof(double);
        if (has_velocities)
          {
            std::memcpy(state.velocity[node].v, values, dim * sizeof(double));
            values += dim * sizeof(double);
          }
        if (was_at_rest && !is_at_rest(node))
          activity.wake_node(topology, node);
      }
  }

  std::size_t
  GhostExchange::n_bytes() const
  {
    std::size_t sum = 0;
    for (const Partner &receiver : receivers)
      sum += sizeof(Header) + receiver.nodes.size() * bytes_per_node();
    return sum;
  }
} // namespace rift
