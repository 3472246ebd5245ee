#include <rift/base/check.h>
#include <rift/contact/contact_pair.h>
#include <rift/contact/contact_penalty.h>
#include <rift/solid/principal_stresses.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    constexpr double infinity = std::numeric_limits<double>::infinity(),
                     unknown  = std::numeric_limits<double>::quiet_NaN();

    double
    largest_eigenvalue(const Matrix3<double> &symmetric)
    {
      return principal_stresses(symmetric)[0];
    }
  } // namespace

  ContactStiffnesses::ContactStiffnesses(const Topology          &topology,
                                         const ReferenceCellData &reference,
                                         std::vector<double> spare_stiffness,
                                         const double        share_of_bond)
    : topology(topology)
    , reference(reference)
    , spare_stiffness(std::move(spare_stiffness))
    , share_of_bond(share_of_bond)
  {
    rift_check(this->spare_stiffness.size() == topology.n_cell_slots());
  }

  void
  ContactStiffnesses::KnownNodes::forget(const NodeIndex node)
  {
    for (std::vector<double> *values : {&touched, &inside})
      if (node < values->size())
        (*values)[node] = unknown;
  }

  ContactStiffness
  ContactStiffnesses::of_cell(const CellIndex cell) const
  {
    return of_cell(
      cell,
      [this](const NodeIndex node) { return per_area_of_node(node); },
      [this](const NodeIndex node) { return per_area_inside(node); });
  }

  ContactStiffness
  ContactStiffnesses::of_cell(const CellIndex cell, KnownNodes &known) const
  {
    const auto find = [](std::vector<double> &values,
                         const NodeIndex      node,
                         const auto          &compute) {
      if (node >= values.size())
        values.resize(node + 1, unknown);
      if (std::isnan(values[node]))
        values[node] = compute(node);
      return values[node];
    };
    return of_cell(
      cell,
      [&](const NodeIndex node) {
        return find(known.touched, node, [this](const NodeIndex n) {
          return per_area_of_node(n);
        });
      },
      [&](const NodeIndex node) {
        return find(known.inside, node, [this](const NodeIndex n) {
          return per_area_inside(n);
        });
      });
  }

  template <typename PerAreaOfNode, typename PerAreaInside>
  ContactStiffness
  ContactStiffnesses::of_cell(const CellIndex      cell,
                              const PerAreaOfNode &of_node,
                              const PerAreaInside &inside) const
  {
    ContactStiffness result{infinity, infinity};
    for (unsigned int face = 0; face < n_corners; ++face)
      result.height = std::min(result.height, height(cell, face));
    for (unsigned int corner = 0; corner < n_corners; ++corner)
      {
        bool is_touched = false;
        for (unsigned int face = 0; face < n_corners; ++face)
          is_touched |= face != corner && is_exposed(cell, face);
        if (is_touched)
          result.per_area =
            std::min(result.per_area, of_node(topology.node(cell, corner)));
      }
    if (result.per_area < infinity || spare_stiffness[cell] == infinity)
      return result;

    for (unsigned int corner = 0; corner < n_corners; ++corner)
      result.per_area =
        std::min(result.per_area, inside(topology.node(cell, corner)));
    return result;
  }

  double
  ContactStiffnesses::per_area_of_node(const NodeIndex node) const
  {
    const VertexIndex vertex = topology.node_vertices[node];
    rift_check(topology.is_complete(vertex));
    double          spare = 0, largest_area = 0;
    Matrix3<double> faces{};
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      {
        const unsigned int corner = topology.corner_at_vertex(*cell, vertex);
        if (topology.node(*cell, corner) != node)
          continue;
        unsigned int n_bonds = 0;
        for (unsigned int face = 0; face < n_corners; ++face)
          if (face != corner)
            {
              n_bonds += is_bonded(*cell, face);
              largest_area =
                std::max(largest_area,
                         norm(reference_area_vector(reference, *cell, face)));
              if (is_exposed(*cell, face))
                add_face(*cell, face, faces);
            }
        if (spare_stiffness[*cell] == infinity)
          return infinity;
        spare += (1 - n_bonds * share_of_bond) * spare_stiffness[*cell];
      }
    return spare / std::max(largest_eigenvalue(faces), largest_area / 3);
  }

  double
  ContactStiffnesses::per_area_inside(const NodeIndex node) const
  {
    const VertexIndex vertex = topology.node_vertices[node];
    rift_check(topology.is_complete(vertex));
    double          spare = 0;
    Matrix3<double> faces{};
    for (auto cell = topology.vertex_cells_first(vertex);
         cell != topology.vertex_cells_last(vertex);
         ++cell)
      {
        const unsigned int corner = topology.corner_at_vertex(*cell, vertex);
        if (topology.node(*cell, corner) != node)
          continue;
        spare += spare_stiffness[*cell];
        for (unsigned int face = 0; face < n_corners; ++face)
          if (face != corner)
            add_face(*cell, face, faces, is_intact(*cell, face) ? .25 : 1);
      }
    return spare / largest_eigenvalue(faces);
  }

  bool
  ContactStiffnesses::is_exposed(const CellIndex    cell,
                                 const unsigned int face) const
  {
    const FaceIndex index = topology.cell_faces[cell][face];
    return index == invalid_index ||
           topology.face_states[index] == FaceState::released;
  }

  bool
  ContactStiffnesses::is_bonded(const CellIndex    cell,
                                const unsigned int face) const
  {
    const FaceIndex index = topology.cell_faces[cell][face];
    return index != invalid_index &&
           topology.face_states[index] != FaceState::intact &&
           topology.face_states[index] != FaceState::released;
  }

  bool
  ContactStiffnesses::is_intact(const CellIndex    cell,
                                const unsigned int face) const
  {
    return !is_exposed(cell, face) && !is_bonded(cell, face);
  }

  double
  ContactStiffnesses::height(const CellIndex    cell,
                             const unsigned int face) const
  {
    return 1 /
           norm(reference[cell / batch_size].gradient(face, cell % batch_size));
  }

  void
  ContactStiffnesses::add_face(const CellIndex    cell,
                               const unsigned int face,
                               Matrix3<double>   &sum,
                               const double       share) const
  {
    const Vector3<double> vector = reference_area_vector(reference, cell, face);
    const double          area   = norm(vector);
    // A third of the face for each of its nodes: fully along the normal, and by
    // the spring of friction across.
    for (unsigned int i = 0; i < dim; ++i)
      {
        sum[i][i] += share * (friction_stiffness_ratio * area / 3);
        for (unsigned int j = 0; j < dim; ++j)
          sum[i][j] += share * ((1 - friction_stiffness_ratio) / 3 * vector[i] *
                                vector[j] / area);
      }
  }
} // namespace rift
