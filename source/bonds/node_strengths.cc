#include <rift/base/exact_sum.h>
#include <rift/base/parameter_text.h>
#include <rift/bonds/node_strengths.h>
#include <rift/cohesive/face_strengths.h>
#include <rift/discretization/ghost_values.h>
#include <rift/material/strength_field.h>

#include <algorithm>
#include <limits>
#include <map>

namespace rift
{
  namespace
  {
    /** Mean length of the edges of the cells of a material, m; 0 if there are
     * none. Collective. */
    double
    mean_edge(const Topology                 &topology,
              const std::vector<NodalVector> &places,
              const std::uint16_t             material,
              const Communicator             &communicator)
    {
      ExactSum     sum;
      std::int64_t n = 0;
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        if (topology.owns_cell(cell) && topology.material(cell) == material)
          for (unsigned int i = 0; i < n_corners; ++i)
            for (unsigned int j = 0; j < i; ++j, ++n)
              sum.add(norm(places[topology.vertex(cell, i)].vector() -
                           places[topology.vertex(cell, j)].vector()));
      ExactSum::sum_over_ranks({&sum}, communicator);
      n = communicator.sum(n);
      return n > 0 ? sum.value() / n : 0;
    }

    /** The material of the smallest Weibull modulus; null if none scatters. */
    const MaterialParameters *
    most_scattered(const std::vector<MaterialParameters> &materials,
                   const std::vector<std::uint16_t>      &members)
    {
      const MaterialParameters *result = nullptr;
      for (const std::uint16_t m : members)
        if (const double modulus = materials[m].weibull_modulus;
            modulus > 0 && (!result || modulus < result->weibull_modulus))
          result = &materials[m];
      return result;
    }

    /** The smaller values of all materials across a plane. */
    StrengthAcross
    weakest_across(const std::vector<MaterialParameters> &materials,
                   const std::vector<std::uint16_t>      &members)
    {
      std::vector<PlaneStrength> strengths;
      for (const std::uint16_t m : members)
        strengths.emplace_back(materials[m]);
      return [strengths](const Vector3<double> &normal) {
        FaceStrength result = strengths[0].across(normal);
        for (std::size_t i = 1; i < strengths.size(); ++i)
          result = weaker_of(result, strengths[i].across(normal));
        return result;
      };
    }
  } // namespace

  NodeStrengths::NodeStrengths(const Topology                        &topology,
                               const std::vector<NodalVector>        &places,
                               const std::vector<MaterialParameters> &materials,
                               const unsigned int                     seed)
    : topology(topology)
    , materials(materials)
    , groups(1)
    , group_of_vertex(topology.n_vertices(), 0)
  {
    constexpr Vector3<double>                           any = {{1, 0, 0}};
    std::map<std::vector<std::uint16_t>, std::uint16_t> known;
    for (VertexIndex vertex = 0; vertex < topology.n_vertices(); ++vertex)
      {
        std::vector<std::uint16_t> members;
        for (auto cell = topology.vertex_cells_first(vertex);
             cell != topology.vertex_cells_last(vertex);
             ++cell)
          if (materials[topology.material(*cell)].breakable)
            members.push_back(topology.material(*cell));
        std::sort(members.begin(), members.end());
        members.erase(std::unique(members.begin(), members.end()),
                      members.end());
        if (members.empty())
          continue;
        const auto [place, is_new] =
          known.insert({members, static_cast<std::uint16_t>(groups.size())});
        group_of_vertex[vertex] = place->second;
        if (!is_new)
          continue;
        const StrengthAcross across = weakest_across(materials, members);
        Group                group{members, across(any), {}, nullptr};
        for (const std::uint16_t m : members)
          {
            if (materials[m].has_directional_strength() && !group.planes)
              {
                group.strength_across = across;
                group.planes = std::make_shared<DirectionalPlanes>(across);
              }
            group.strength.tensile_strength =
              std::min(group.strength.tensile_strength,
                       materials[m].tensile_strength.smallest());
            group.strength.cohesion =
              std::min(group.strength.cohesion,
                       materials[m].cohesion.smallest());
          }
        groups.push_back(group);
      }
    if (any_scatters(materials))
      scatter(places, seed);
  }

  void
  NodeStrengths::scatter(const std::vector<NodalVector> &places,
                         const unsigned int              seed)
  {
    std::vector<std::optional<StrengthField>> fields(groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g)
      if (const MaterialParameters *material =
            most_scattered(materials, groups[g].materials))
        fields[g].emplace(seed,
                          material->correlation_length,
                          material->weibull_modulus);
    factors.assign(topology.n_vertices(), 1.);
    for (VertexIndex vertex = 0; vertex < factors.size(); ++vertex)
      if (const auto &field = fields[group_of_vertex[vertex]])
        factors[vertex] = field->factor(places[vertex].vector());
  }

  bool
  NodeStrengths::is_breakable_face(const FaceIndex face) const
  {
    const Face &f = topology.faces[face];
    return materials[topology.material(f.cells[0])].breakable &&
           materials[topology.material(f.cells[1])].breakable;
  }

  FaceStrength
  NodeStrengths::strength(const VertexIndex      vertex,
                          const Vector3<double> &normal) const
  {
    const Group       &group = groups[group_of_vertex[vertex]];
    const FaceStrength strength =
      group.planes ? group.strength_across(normal) : group.strength;
    return factors.empty() ? strength : strength.scattered(factors[vertex]);
  }

  double
  NodeStrengths::largest_demand(const VertexIndex              vertex,
                                const SymmetricTensor<double> &stress) const
  {
    // The factor of a vertex is that of all of its strengths.
    const Group &group = groups[group_of_vertex[vertex]];
    const double demand =
      rift::largest_demand(stress, group.strength) / factor(vertex);
    if (!group.planes || demand < 1)
      return demand;
    const double bound = group.planes->bound_of_demand(stress) / factor(vertex);
    return bound < 1 ? bound :
                       group.planes->weakest(stress).demand / factor(vertex);
  }

  WeakestPlanes
  NodeStrengths::weakest_planes(const VertexIndex              vertex,
                                const SymmetricTensor<double> &stress) const
  {
    const Group  &group  = groups[group_of_vertex[vertex]];
    WeakestPlanes result = group.planes ?
                             group.planes->weakest(stress) :
                             rift::weakest_planes(stress, group.strength);
    result.demand /= factor(vertex);
    return result;
  }

  StressBounds
  NodeStrengths::stress_bounds(const Communicator &communicator) const
  {
    // The mean stress of the cells at a node is at the strength only if that of
    // one of them is, since the stresses below it are a convex set.
    constexpr double    margin  = .99;
    constexpr double    largest = std::numeric_limits<double>::max();
    const std::size_t   n       = materials.size();
    std::vector<double> tension(n, largest), cohesion(n, largest),
      least_friction(n, largest), most_friction(n, 0);
    for (const Group &group : groups)
      for (const std::uint16_t m : group.materials)
        {
          const double tan = group.strength.tan_friction_angle;
          tension[m]  = std::min(tension[m], group.strength.tensile_strength);
          cohesion[m] = std::min(cohesion[m], group.strength.cohesion);
          least_friction[m] = std::min(least_friction[m], tan);
          most_friction[m]  = std::max(most_friction[m], tan);
        }
    StressBounds bounds{std::vector<std::optional<StressBound>>(n),
                        cell_factors(communicator)};
    for (std::size_t m = 0; m < n; ++m)
      {
        const double t    = -communicator.max(-tension[m]);
        const double c    = -communicator.max(-cohesion[m]);
        const double low  = -communicator.max(-least_friction[m]);
        const double high = communicator.max(most_friction[m]);
        // Less friction allows more shear under pressure and, at most by the
        // tensile strength times the difference, less in tension.
        if (t < largest)
          bounds.materials[m] =
            StressBound{margin * t,
                        margin * std::max(0., c - (high - low) * t),
                        low};
      }
    return bounds;
  }

  std::vector<Simd>
  NodeStrengths::cell_factors(const Communicator &communicator) const
  {
    // A rank may have no vertices, but must answer the others.
    if (!any_scatters(materials))
      return {};
    std::vector<double> smallest(topology.n_cell_slots(),
                                 std::numeric_limits<double>::infinity());
    for (VertexIndex vertex = 0; vertex < factors.size(); ++vertex)
      if (is_breakable(vertex))
        for (auto cell = topology.vertex_cells_first(vertex);
             cell != topology.vertex_cells_last(vertex);
             ++cell)
          smallest[*cell] = std::min(smallest[*cell], factors[vertex]);
    // Not all vertices of a ghost are complete.
    copy_to_ghosts(communicator, topology, smallest);
    return by_batches(smallest);
  }

  std::vector<std::string>
  NodeStrengths::warnings(const std::vector<NodalVector> &places,
                          const Communicator             &communicator) const
  {
    std::vector<std::string> result;
    for (std::uint16_t m = 0; m < materials.size(); ++m)
      {
        const MaterialParameters &material = materials[m];
        if (!material.breakable || material.weibull_modulus == 0)
          continue;
        const double edge = mean_edge(topology, places, m, communicator);
        // There, 3.16 times smaller cells lower the strength of a body by an
        // eighth of what they do with independent vertices.
        constexpr double edges_per_length = 2;
        if (material.correlation_length < edges_per_length * edge)
          result.push_back(
            "Material " + material.name +
            "/Correlation length = " + short_text(material.correlation_length) +
            " m is shorter than two edges of its cells, which have " +
            short_text(edge) +
            " m in the mean: the strength of the body falls with the size of "
            "the cells. Use a longer one, or smaller cells.");
      }
    return result;
  }
} // namespace rift
