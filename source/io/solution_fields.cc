#include <rift/io/solution_fields.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <xxhash.h>

namespace rift
{
  namespace
  {
    /** Nodes of the cells that this rank owns, ascending. */
    std::vector<NodeIndex>
    nodes_of_owned_cells(const Topology &topology)
    {
      std::vector<std::uint8_t> is_used(topology.n_nodes(), 0);
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        for (unsigned int c = 0; c < n_corners && topology.owns_cell(cell); ++c)
          is_used[topology.node(cell, c)] = 1;
      std::vector<NodeIndex> nodes;
      for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
        if (is_used[node])
          nodes.push_back(node);
      return nodes;
    }
  } // namespace

  Solution
  solid_solution(const Topology                     &topology,
                 const State                        &state,
                 const InternalForce                &internal_force,
                 const std::vector<Vector3<double>> &velocity,
                 const std::vector<std::uint32_t>   &fragments)
  {
    Solution               solution;
    OutputField            displacement{"displacement [m]", 3, {}};
    OutputField            speed{"velocity [m/s]", 3, {}};
    std::vector<NodeIndex> point_of_node(topology.n_nodes(), invalid_index);
    for (const NodeIndex node : nodes_of_owned_cells(topology))
      {
        point_of_node[node] = static_cast<NodeIndex>(solution.points.size());
        solution.points.push_back(state.position(node));
        for (unsigned int d = 0; d < dim; ++d)
          {
            displacement.values.push_back(
              static_cast<float>(state.displacement[node][d]));
            speed.values.push_back(static_cast<float>(velocity[node][d]));
          }
      }

    OutputField stress{"stress [Pa]", 6, {}};
    OutputField material{"material", 1, {}};
    OutputField fragment{"fragment", 1, {}};
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        if (!topology.owns_cell(cell))
          continue;
        for (unsigned int c = 0; c < n_corners; ++c)
          solution.cells.push_back(point_of_node[topology.node(cell, c)]);
        for (const double s : internal_force.cauchy_stress(state, cell))
          stress.values.push_back(static_cast<float>(s));
        material.values.push_back(topology.material(cell));
        fragment.values.push_back(static_cast<float>(fragments[cell]));
      }
    solution.point_data = {displacement, speed};
    solution.cell_data  = {stress, material, fragment};
    return solution;
  }

  Solution
  fracture_solution(const Topology      &topology,
                    const State         &state,
                    const CohesiveForce &cohesive_force)
  {
    Solution solution;
    solution.nodes_per_cell              = 3;
    const std::vector<std::string> names = {"damage",
                                            "mode",
                                            "opening [m]",
                                            "slip [m]",
                                            "normal traction [Pa]",
                                            "shear traction [Pa]",
                                            "time of insertion [s]",
                                            "time of failure [s]"};
    for (const std::string &name : names)
      solution.cell_data.push_back({name, 1, {}});

    const CohesiveFaces         &faces     = cohesive_force.faces();
    const std::vector<FaceMeans> all_means = cohesive_force.means(state);
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        if (!topology.owns_face(faces.infos[i].face) || !faces.has_opened(i))
          continue;
        const CohesiveBatch &batch = faces.batches[i / batch_size];
        for (unsigned int c = 0; c < 3; ++c)
          {
            solution.cells.push_back(
              static_cast<NodeIndex>(solution.points.size()));
            solution.points.push_back(
              .5 * (state.position(batch.minus[c][i % batch_size]) +
                    state.position(batch.plus[c][i % batch_size])));
          }
        const FaceMeans &means    = all_means[i];
        const double     values[] = {means.damage,
                                     means.mode(),
                                     means.opening,
                                     means.slip,
                                     means.normal,
                                     means.shear,
                                     faces.infos[i].start_time,
                                     faces.infos[i].failure_time};
        for (std::size_t k = 0; k < names.size(); ++k)
          solution.cell_data[k].values.push_back(static_cast<float>(values[k]));
      }
    return solution;
  }

  std::string
  state_hash(const Topology     &topology,
             const State        &state,
             const Communicator &communicator)
  {
    // The sum, modulo 2^64, of a hash of each cell, in two versions. The sums
    // over the ranks are of halves, which do not overflow.
    std::array<std::uint64_t, 2> sums = {{0, 0}};
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        if (!topology.owns_cell(cell))
          continue;
        std::array<Vector3<double>, 2 * n_corners> data;
        for (unsigned int c = 0; c < n_corners; ++c)
          {
            const NodeIndex node = topology.node(cell, c);
            data[2 * c]          = state.displacement[node].vector();
            data[2 * c + 1]      = state.velocity[node].vector();
          }
        const auto hash =
          XXH3_128bits_withSeed(data.data(),
                                sizeof(data),
                                topology.cell_global_indices[cell]);
        sums[0] += hash.high64;
        sums[1] += hash.low64;
      }
    std::vector<std::int64_t> halves;
    for (const std::uint64_t sum : sums)
      for (const unsigned int shift : {32, 0})
        halves.push_back(static_cast<std::uint32_t>(sum >> shift));
    communicator.sum(halves);

    std::string text;
    for (unsigned int i = 0; i < 4; i += 2)
      {
        const std::uint64_t sum =
          (static_cast<std::uint64_t>(halves[i]) << 32) + halves[i + 1];
        char digits[17];
        std::snprintf(digits,
                      sizeof(digits),
                      "%016llx",
                      static_cast<unsigned long long>(sum));
        text += digits;
      }
    return text;
  }
} // namespace rift
