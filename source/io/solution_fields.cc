#include <rift/io/solution_fields.h>
#include <rift/rigid/rigid_bodies.h>
#include <rift/solid/internal_force.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <xxhash.h>

namespace rift
{
  FieldList
  known_fields()
  {
    FieldList list;
    declare_nodal_fields(list);
    InternalForce::declare_fields(list, nullptr);
    Fracture::declare_fields(list, nullptr);
    RigidBodies::declare_fields(list, nullptr);
    return list;
  }

  void
  declare_labels(FieldList                        &list,
                 const Topology                   *topology,
                 const std::vector<std::uint32_t> *fragments)
  {
    list.add("material",
             "",
             FieldLocation::cell,
             [topology](const std::size_t cell) {
               return static_cast<double>(topology->material(cell));
             });
    list.add("fragment",
             "",
             FieldLocation::cell,
             [fragments](const std::size_t cell) {
               return static_cast<double>((*fragments)[cell]);
             });
  }

  FieldList
  known_output_fields()
  {
    FieldList list = known_fields();
    declare_labels(list, nullptr, nullptr);
    return list;
  }

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

    /** The wanted fields of a place, while their values are collected. */
    class Columns
    {
    public:
      Columns(const FieldList      &list,
              const FieldLocation   location,
              const FieldSelection &wanted)
      {
        for (const Field &field : list)
          if (field.location == location && wanted.includes(field))
            {
              const std::size_t n = field.components.size();
              fields.push_back(&field);
              columns.push_back({title(field.name, field.unit),
                                 static_cast<unsigned int>(n),
                                 {},
                                 n == dim && field.components[0] != "x" ?
                                   field.components :
                                   std::vector<std::string>()});
            }
      }

      /** Appends the means of the values for these items. */
      void
      append(const std::initializer_list<std::size_t> items)
      {
        for (std::size_t i = 0; i < fields.size(); ++i)
          {
            const std::size_t     n = fields[i]->components.size();
            std::array<double, 6> sum{}, value{};
            for (const std::size_t item : items)
              {
                fields[i]->values(item, value.data());
                for (std::size_t c = 0; c < n; ++c)
                  sum[c] += value[c];
              }
            for (std::size_t c = 0; c < n; ++c)
              columns[i].values.push_back(
                static_cast<float>(sum[c] / items.size()));
          }
      }

      std::vector<OutputField>
      take()
      {
        return std::move(columns);
      }

    private:
      std::vector<const Field *> fields;
      std::vector<OutputField>   columns;
    };
  } // namespace

  Solution
  solid_solution(const Topology       &topology,
                 const FieldList      &fields,
                 const FieldSelection &wanted)
  {
    Solution               solution;
    Columns                nodal(fields, FieldLocation::node, wanted);
    std::vector<NodeIndex> point_of_node(topology.n_nodes(), invalid_index);
    for (const NodeIndex node : nodes_of_owned_cells(topology))
      {
        point_of_node[node] = static_cast<NodeIndex>(solution.points.size());
        solution.points.push_back(fields.state()->reference[node].vector());
        nodal.append({node});
      }

    Columns of_cells(fields, FieldLocation::cell, wanted);
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        if (!topology.owns_cell(cell))
          continue;
        for (unsigned int c = 0; c < n_corners; ++c)
          solution.cells.push_back(point_of_node[topology.node(cell, c)]);
        of_cells.append({cell});
      }
    solution.point_data = nodal.take();
    solution.cell_data  = of_cells.take();
    return solution;
  }

  namespace
  {
    /** The displacement alone, if it is wanted at all. */
    FieldSelection
    displacement_of(const FieldList &fields, const FieldSelection &wanted)
    {
      const Field *field = fields.find("displacement", FieldLocation::node);
      return field != nullptr && wanted.includes(*field) ?
               FieldSelection{{field->name}} :
               FieldSelection{{}};
    }
  } // namespace

  Solution
  fracture_solution(const Topology       &topology,
                    const Fracture       &fracture,
                    const FieldList      &fields,
                    const FieldSelection &wanted)
  {
    Solution solution;
    solution.nodes_per_cell = 3;
    Columns nodal(fields, FieldLocation::node, displacement_of(fields, wanted));
    Columns of_faces(fields, FieldLocation::cohesive_face, wanted);

    for (std::size_t i = 0; i < fracture.n_faces(); ++i)
      {
        const auto open = fracture.open_face(i);
        if (!open || !topology.owns_face(open->face))
          continue;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const NodeIndex minus = open->nodes[0][c];
            const NodeIndex plus  = open->nodes[1][c];
            solution.cells.push_back(
              static_cast<NodeIndex>(solution.points.size()));
            solution.points.push_back(
              fields.state()->reference[minus].vector());
            nodal.append({minus, plus});
          }
        of_faces.append({i});
      }
    solution.point_data = nodal.take();
    solution.cell_data  = of_faces.take();
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
