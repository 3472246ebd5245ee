#ifndef rift_tests_support_divided_body_h
#define rift_tests_support_divided_body_h

#include <rift/base/communicator.h>

#include "distributed_body.h"
#include "random_cuts.h"

namespace rift::test
{
  /** The corners of a face, ascending in the numbering of the whole body. */
  inline Triangle
  global_triangle(const Topology                 &topology,
                  const FaceIndex                 face,
                  const std::vector<VertexIndex> &global_vertices)
  {
    Triangle t = triangle_of(topology, face);
    for (VertexIndex &v : t)
      v = global_vertices[v];
    std::sort(t.begin(), t.end());
    return t;
  }

  /** Those of these triangles that are faces here. */
  inline std::vector<FaceIndex>
  faces_at(const Topology                 &topology,
           const std::set<Triangle>       &triangles,
           const std::vector<VertexIndex> &global_vertices)
  {
    std::vector<FaceIndex> faces;
    for (FaceIndex face = 0; face < topology.faces.size(); ++face)
      if (triangles.count(global_triangle(topology, face, global_vertices)) > 0)
        faces.push_back(face);
    return faces;
  }

  inline std::vector<VertexIndex>
  identity(const std::size_t n)
  {
    std::vector<VertexIndex> result(n);
    std::iota(result.begin(), result.end(), VertexIndex{0});
    return result;
  }

  /**
   * Gives each node a displacement and a velocity that depend on its vertex in
   * the whole body and the first of its cells, so that they are the same on
   * all ranks that have all of its cells.
   */
  inline void
  move_by_names(const Topology                 &topology,
                State                          &state,
                const std::vector<VertexIndex> &global_vertices)
  {
    std::vector<GlobalCellIndex> first_cell(topology.n_nodes(), invalid_index);
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell); ++c)
        {
          GlobalCellIndex &first = first_cell[topology.node(cell, c)];
          first = std::min(first, topology.cell_global_indices[cell]);
        }
    std::uniform_real_distribution<double> value(-.02, .02);
    for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
      {
        std::mt19937 random(global_vertices[topology.node_vertices[node]] +
                            100003 * first_cell[node]);
        for (unsigned int d = 0; d < dim; ++d)
          {
            state.displacement[node][d] = value(random);
            state.velocity[node][d]     = value(random);
          }
      }
  }

  /** The velocities of all nodes. */
  inline std::vector<Vector3<double>>
  velocities(const State &state)
  {
    std::vector<Vector3<double>> result;
    for (const NodalVector &v : state.velocity)
      result.push_back(v.vector());
    return result;
  }

  /**
   * A random body, whole and as the part of it that this rank sees, cut, broken
   * and moved alike; the same on any number of ranks but for the division. Of
   * faces between two ghosts a rank does not know whether they are broken.
   */
  struct DividedBody
  {
    DividedBody(const unsigned int seed, const Communicator &communicator)
      : random(seed)
      , body(ordered_random_body())
      , whole(discretize_ordered(body, densities))
    {
      for (FaceIndex face = 0; face < whole.topology.faces.size(); ++face)
        if (random() % 3 > 0)
          {
            cuts.insert(triangle_of(whole.topology, face));
            if (random() % 4 > 0)
              broken.insert(triangle_of(whole.topology, face));
          }
      finish(whole, identity(body.vertices.size()));

      const auto owners =
        random_owners(body.cells.size(), communicator.size(), random);
      part  = part_of(body, owners, communicator.rank());
      local = discretize(part, densities);
      finish(local, part.global_vertices);
      Topology &topology = local.topology;
      for (FaceIndex face = 0; face < topology.faces.size(); ++face)
        {
          const CellIndex *cells = topology.faces[face].cells;
          if (topology.face_states[face] != FaceState::intact &&
              !topology.owns_cell(cells[0]) && !topology.owns_cell(cells[1]))
            topology.face_states[face] =
              random() % 2 == 0 ? FaceState::failed : FaceState::cut;
        }
    }

    std::mt19937       random;
    Body               body;
    DiscreteBody       whole;
    std::set<Triangle> cuts, broken;
    BodyPart           part;
    DiscreteBody       local{Topology({}, 0), {}, {}};

  private:
    Body
    ordered_random_body()
    {
      Body result = random_body(random);
      order(result);
      return result;
    }

    void
    finish(DiscreteBody                   &discrete,
           const std::vector<VertexIndex> &global_vertices) const
    {
      cut(discrete, faces_at(discrete.topology, cuts, global_vertices));
      for (const FaceIndex face :
           faces_at(discrete.topology, broken, global_vertices))
        discrete.topology.face_states[face] = FaceState::failed;
      move_by_names(discrete.topology, discrete.state, global_vertices);
    }
  };
} // namespace rift::test

#endif
