#include <rift/cohesive/insertion.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  Insertion::Insertion(const Topology          &topology,
                       const ReferenceCellData &reference,
                       const InternalForce     &internal_force,
                       const FaceStrengths     &strengths)
    : topology(topology)
    , reference(reference)
    , internal_force(internal_force)
    , strengths(strengths)
    , hot_lanes(topology.n_batches(), 0)
    , stress_position(topology.n_batches(), invalid_index)
  {
  }

  std::vector<FaceIndex>
  Insertion::find_faces(const State                  &state,
                        const std::vector<CellIndex> &hot_cells)
  {
    std::vector<FaceIndex> faces;
    for (const CellIndex cell : hot_cells)
      hot_lanes[cell / batch_size] |= 1u << (cell % batch_size);

    for (const CellIndex cell : hot_cells)
      for (const FaceIndex face : topology.cell_faces[cell])
        {
          if (face == invalid_index ||
              topology.face_states[face] != FaceState::intact ||
              !strengths.is_breakable(face))
            continue;
          // A face between two hot cells is looked at from the first.
          const CellIndex other = topology.neighbour(face, cell);
          const bool      other_is_hot =
            (hot_lanes[other / batch_size] >> (other % batch_size)) & 1;
          if (other_is_hot && other < cell)
            continue;
          if (is_at_strength(state, face))
            faces.push_back(face);
        }

    for (const CellIndex cell : hot_cells)
      hot_lanes[cell / batch_size] = 0;
    for (const std::uint32_t batch : computed_batches)
      stress_position[batch] = invalid_index;
    computed_batches.clear();
    stresses.clear();
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  Matrix3<double>
  Insertion::stress(const State &state, const CellIndex cell)
  {
    const std::uint32_t batch = cell / batch_size;
    if (stress_position[batch] == invalid_index)
      {
        stress_position[batch] = static_cast<std::uint32_t>(stresses.size());
        computed_batches.push_back(batch);
        stresses.push_back(
          internal_force.first_piola_kirchhoff_stress(state, batch));
      }
    const Matrix3<Simd> &p = stresses[stress_position[batch]];
    Matrix3<double>      result;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        result[i][d] = p[i][d][cell % batch_size];
    return result;
  }

  bool
  Insertion::is_at_strength(const State &state, const FaceIndex face)
  {
    const Face           &f = topology.faces[face];
    const Vector3<double> area =
      reference_area_vector(reference, f.cells[0], f.local_faces[0]);
    const Vector3<double> traction =
      (.5 / norm(area)) *
      (stress(state, f.cells[0]) * area + stress(state, f.cells[1]) * area);

    std::array<Vector3<double>, 3> x;
    for (unsigned int c = 0; c < 3; ++c)
      x[c] = state.position(
        topology.node(f.cells[0], face_corners[f.local_faces[0]][c]));
    Vector3<double> normal = cross(x[1] - x[0], x[2] - x[0]);
    normal                 = (1 / norm(normal)) * normal;

    const double       normal_stress = dot(traction, normal);
    const double       shear_stress  = norm(traction - normal_stress * normal);
    const FaceStrength strength      = strengths.strength(face);
    return normal_stress >= strength.tensile_strength ||
           shear_stress >= strength.cohesion - std::min(normal_stress, 0.) *
                                                 strength.tan_friction_angle;
  }
} // namespace rift
