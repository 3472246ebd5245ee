#ifndef rift_bonds_node_strengths_h
#define rift_bonds_node_strengths_h

#include <rift/base/communicator.h>
#include <rift/bonds/weakest_planes.h>
#include <rift/material/material_parameters.h>
#include <rift/material/stress_bound.h>
#include <rift/mesh/mesh_data.h>
#include <rift/mesh/topology.h>

#include <memory>
#include <vector>

namespace rift
{
  /**
   * The strength of planes through nodes. Where cells of several materials meet
   * at a vertex, the weakest value of each property counts; cells that cannot
   * break do not count, and where there are no others, nodes never part.
   *
   * With a Weibull modulus both strengths are scaled by the StrengthField of the
   * material at the vertex; of several materials that of the smallest modulus
   * counts.
   */
  class NodeStrengths
  {
  public:
    /** @param topology must outlive this object.
     * @param places of the vertices in the undeformed body, m.
     * @param materials by material index.
     * @param seed of the scatter. */
    NodeStrengths(const Topology                        &topology,
                  const std::vector<NodalVector>        &places,
                  const std::vector<MaterialParameters> &materials,
                  unsigned int                           seed);

    /** Whether anything at a vertex can break. */
    bool
    is_breakable(const VertexIndex vertex) const
    {
      return group_of_vertex[vertex] != 0;
    }

    /** Whether a face can be cut: both of its cells are of breakable
     * materials. */
    bool
    is_breakable_face(FaceIndex face) const;

    /** Of a plane through a vertex that can break.
     * @param normal in the undeformed body, of unit length. */
    FaceStrength
    strength(VertexIndex vertex, const Vector3<double> &normal) const;

    /** The largest demand of all planes through a vertex that can break; an upper
     * bound where that is below 1. */
    double
    largest_demand(VertexIndex                    vertex,
                   const SymmetricTensor<double> &stress) const;

    /** The planes that break first at a vertex that can break. */
    WeakestPlanes
    weakest_planes(VertexIndex                    vertex,
                   const SymmetricTensor<double> &stress) const;

    /** For each cell the stress below which no plane through one of its vertices
     * is at its strength; the same on all ranks. Collective. */
    StressBounds
    stress_bounds(const Communicator &communicator) const;

    /** Sentences about correlation lengths that the mesh does not resolve.
     * Collective.
     * @param places see the constructor. */
    std::vector<std::string>
    warnings(const std::vector<NodalVector> &places,
             const Communicator             &communicator) const;

  private:
    /** Materials that meet at a vertex and can break. */
    struct Group
    {
      std::vector<std::uint16_t> materials;

      /** Without scatter, where it does not depend on the direction; otherwise
       * the smallest tensile strength and cohesion of all directions. */
      FaceStrength strength;

      /** The strength of all planes, and their search, where it does depend on
       * the direction. */
      StrengthAcross                           strength_across;
      std::shared_ptr<const DirectionalPlanes> planes;
    };

    void
    scatter(const std::vector<NodalVector> &places, unsigned int seed);

    /** Of the strength at a vertex. */
    double
    factor(const VertexIndex vertex) const
    {
      return factors.empty() ? 1 : factors[vertex];
    }

    /** The smallest factor of the vertices of each cell, by batches; empty
     * without scatter. Collective. */
    std::vector<Simd>
    cell_factors(const Communicator &communicator) const;

    const Topology                       &topology;
    const std::vector<MaterialParameters> materials;

    /** The first is that of vertices where nothing breaks. */
    std::vector<Group>         groups;
    std::vector<std::uint16_t> group_of_vertex;

    /** For each vertex; empty where nothing scatters. */
    std::vector<double> factors;
  };
} // namespace rift

#endif
