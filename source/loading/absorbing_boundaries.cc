#include <rift/base/check.h>
#include <rift/loading/absorbing_boundaries.h>
#include <rift/loading/effect_check.h>

#include <algorithm>

namespace rift
{
  AbsorbingBoundaries::AbsorbingBoundaries(const Topology          &topology,
                                           const ReferenceCellData &reference,
                                           std::vector<Boundary> the_boundaries,
                                           const Impedance      &impedance,
                                           MovingAsOne           moving_as_one)
    : ModuleWithWork(topology, "absorbing boundaries", "damping")
    , topology(topology)
    , boundaries(std::move(the_boundaries))
    , moving_as_one(std::move(moving_as_one))
  {
    for (const Boundary &boundary : boundaries)
      for (const CellFace &face : boundary.surface)
        {
          const Vector3<double> area =
            reference_area_vector(reference, face.cell, face.local_face);
          Matrix3<double> dashpot =
            impedance(topology.material(face.cell), (1 / norm(area)) * area);
          for (auto &row : dashpot)
            row = (norm(area) / 3) * row;
          faces.push_back(face);
          face_dashpots.push_back(dashpot);
        }
    update_nodes();
  }

  void
  AbsorbingBoundaries::check_effect(const Discretization &body,
                                    const IsPrescribed   &is_prescribed) const
  {
    for (const Boundary &boundary : boundaries)
      EffectCheck(body, is_prescribed)
        .refuse_idle("Boundary " + boundary.name + " / Absorbing",
                     "true",
                     surface_nodes(topology, boundary.surface),
                     [](std::size_t) {
                       return Vector3<double>{{1, 1, 1}};
                     });
  }

  AbsorbingBoundaries::Place
  AbsorbingBoundaries::find(const NodeIndex node) const
  {
    const auto place = std::lower_bound(nodes.begin(), nodes.end(), node);
    if (place == nodes.end() || *place != node)
      return {node, invalid_index};
    return {node, static_cast<std::uint32_t>(place - nodes.begin())};
  }

  void
  AbsorbingBoundaries::update_nodes()
  {
    nodes = surface_nodes(topology, faces);
    nodes.erase(std::remove_if(nodes.begin(),
                               nodes.end(),
                               [this](const NodeIndex node) {
                                 return !topology.is_complete(
                                   topology.node_vertices[node]);
                               }),
                nodes.end());
    dashpots.assign(nodes.size(), {});
    for (std::size_t f = 0; f < faces.size(); ++f)
      for (const NodeIndex node : face_nodes(topology, faces[f]))
        if (const auto i = find(node).position; i != invalid_index)
          for (unsigned int d = 0; d < dim; ++d)
            dashpots[i][d] += face_dashpots[f][d];
  }

  void
  AbsorbingBoundaries::find_held()
  {
    // Before those that have parted in this step, which may be fewer.
    std::vector<std::vector<NodeIndex>> sets;
    for (const NodeIndex node : nodes)
      if (auto others = moving_as_one(node); others.size() > 1)
        sets.push_back(std::move(others));
    held.insert(held.begin(), sets.begin(), sets.end());
  }

  void
  AbsorbingBoundaries::add_to_held(
    State                                     &state,
    const double                               time_step,
    const std::vector<std::vector<NodeIndex>> &held,
    const PrescribedAcceleration              &prescribed)
  {
    forces.assign(nodes.size(), {});
    is_done.assign(nodes.size(), false);
    for (const std::vector<NodeIndex> &set : held)
      {
        std::vector<Place> places;
        bool               is_known = false;
        for (const NodeIndex node : set)
          {
            const Place place = find(node);
            places.push_back(place);
            if (place.position == invalid_index)
              continue;
            is_known |= is_done[place.position];
            is_done[place.position] = true;
          }
        if (!is_known)
          add_to_nodes(places, state, time_step, prescribed);
      }
  }

  void
  AbsorbingBoundaries::add_to_others(State                        &state,
                                     const double                  time_step,
                                     const PrescribedAcceleration &prescribed)
  {
    std::vector<Place> places(1);
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
      if (!is_done[i])
        {
          places[0] = {nodes[i], i};
          add_to_nodes(places, state, time_step, prescribed);
        }
  }

  void
  AbsorbingBoundaries::add_to_nodes(const std::vector<Place>     &places,
                                    State                        &state,
                                    const double                  time_step,
                                    const PrescribedAcceleration &prescribed)
  {
    const Vector3<double> before = state.velocity[places[0].node].vector();
    Vector3<double>       force  = {{0, 0, 0}};
    Matrix3<double>       dashpot{};
    double                mass = 0;
    for (const auto &[node, i] : places)
      {
        mass += state.mass[node];
        force += state.force[node].vector();
        for (unsigned int d = 0; d < dim && i != invalid_index; ++d)
          dashpot[d] += dashpots[i][d];
      }

    rift_check(mass > 0);
    // With f = -C (v + v')/2 and v' = v + dt (F + f)/m:
    // (1 + dt C/2m) (v' + v)/2 = v + dt F/2m
    // but for components that are prescribed.
    const double    half = .5 * time_step / mass;
    Matrix3<double> matrix;
    Vector3<double> right = before + half * force;
    bool is_moving        = dot(before, before) != 0 || dot(force, force) != 0;
    for (unsigned int d = 0; d < dim; ++d)
      {
        matrix[d] = half * dashpot[d];
        matrix[d][d] += 1;
        for (std::size_t p = 0; p < places.size() && prescribed; ++p)
          if (const auto acceleration = prescribed(places[p].node, d))
            {
              matrix[d]    = {{0, 0, 0}};
              matrix[d][d] = 1;
              right[d]     = before[d] + .5 * time_step * *acceleration;
              is_moving |= right[d] != 0;
            }
      }
    // A node at rest stays so.
    if (!is_moving)
      return;
    const Vector3<double> mean = inverse(matrix) * right;
    for (const auto &[node, i] : places)
      if (i != invalid_index)
        {
          forces[i] = -1. * (dashpots[i] * mean);
          for (unsigned int d = 0; d < dim; ++d)
            state.force[node][d] += forces[i][d];
        }
  }

  void
  AbsorbingBoundaries::count_work(const State &state, const double time_step)
  {
    work_done.begin_step();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      work_done.add(state, nodes[i], -1. * forces[i], time_step);
  }
} // namespace rift
