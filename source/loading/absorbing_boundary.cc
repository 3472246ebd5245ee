#include <rift/loading/absorbing_boundary.h>

#include <algorithm>

namespace rift
{
  AbsorbingBoundary::AbsorbingBoundary(const std::string       &name,
                                       const Topology          &topology,
                                       const ReferenceCellData &reference,
                                       Surface                  surface,
                                       Impedance                impedance)
    : archive_name("absorbing " + name)
    , topology(topology)
    , reference(reference)
    , surface(std::move(surface))
    , impedance(std::move(impedance))
    , work_done(topology)
  {
    update_nodes();
  }

  void
  AbsorbingBoundary::update_nodes()
  {
    nodes = surface_nodes(topology, surface);
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [this](const NodeIndex node) {
                                 return !topology.is_complete(
                                   topology.node_vertices[node]);
                               }),
                nodes.end());
    dashpots.assign(nodes.size(), {});
    for (const CellFace &face : surface)
      {
        const Vector3<double> area =
          reference_area_vector(reference, face.cell, face.local_face);
        const Matrix3<double> z =
          impedance(topology.material(face.cell), (1 / norm(area)) * area);
        for (const NodeIndex node : face_nodes(topology, face))
          {
            const auto place =
              std::lower_bound(nodes.begin(), nodes.end(), node);
            if (place == nodes.end() || *place != node)
              continue;
            Matrix3<double> &dashpot = dashpots[place - nodes.begin()];
            for (unsigned int d = 0; d < dim; ++d)
              dashpot[d] += (norm(area) / 3) * z[d];
          }
      }
  }

  void
  AbsorbingBoundary::add_to(State &state, const double time_step)
  {
    forces.assign(nodes.size(), {});
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        const NodeIndex       node   = nodes[i];
        const Vector3<double> before = state.velocity[node].vector();
        const Vector3<double> force  = state.force[node].vector();
        // A node at rest stays so.
        if (dot(before, before) == 0 && dot(force, force) == 0)
          continue;

        // With f = -C (v + v')/2 and v' = v + dt (F + f)/m:
        // (1 + dt C/2m) (v' + v)/2 = v + dt F/2m
        const double    half = .5 * time_step / state.mass[node];
        Matrix3<double> matrix;
        for (unsigned int d = 0; d < dim; ++d)
          {
            matrix[d] = half * dashpots[i][d];
            matrix[d][d] += 1;
          }
        const Vector3<double> mean = inverse(matrix) * (before + half * force);
        forces[i]                  = -1. * (dashpots[i] * mean);
        for (unsigned int d = 0; d < dim; ++d)
          state.force[node][d] += forces[i][d];
      }
  }

  void
  AbsorbingBoundary::count_work(const State &state, const double time_step)
  {
    work_done.begin_step();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      work_done.add(state, nodes[i], -1. * forces[i], time_step);
  }
} // namespace rift
