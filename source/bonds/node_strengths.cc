#include <rift/bonds/node_strengths.h>
#include <rift/cohesive/face_strengths.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace rift
{
  namespace
  {
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
                               const std::vector<MaterialParameters> &materials)
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
    const Group &group = groups[group_of_vertex[vertex]];
    return group.planes ? group.strength_across(normal) : group.strength;
  }

  double
  NodeStrengths::largest_demand(const VertexIndex              vertex,
                                const SymmetricTensor<double> &stress) const
  {
    const Group &group  = groups[group_of_vertex[vertex]];
    const double demand = rift::largest_demand(stress, group.strength);
    if (!group.planes || demand < 1)
      return demand;
    const double bound = group.planes->bound_of_demand(stress);
    return bound < 1 ? bound : group.planes->weakest(stress).demand;
  }

  WeakestPlanes
  NodeStrengths::weakest_planes(const VertexIndex              vertex,
                                const SymmetricTensor<double> &stress) const
  {
    const Group &group = groups[group_of_vertex[vertex]];
    return group.planes ? group.planes->weakest(stress) :
                          rift::weakest_planes(stress, group.strength);
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
    StressBounds bounds{std::vector<std::optional<StressBound>>(n), {}};
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
} // namespace rift
