#include <rift/io/solution_fields.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <xxhash.h>

namespace rift
{
  Solution
  solid_solution(const Topology                     &topology,
                 const State                        &state,
                 const InternalForce                &internal_force,
                 const std::vector<Vector3<double>> &velocity,
                 const Fragments                    &fragments)
  {
    Solution    solution;
    OutputField displacement{"displacement [m]", 3, {}};
    OutputField speed{"velocity [m/s]", 3, {}};
    for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
      {
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
        if (topology.is_padding(cell))
          continue;
        for (unsigned int c = 0; c < n_corners; ++c)
          solution.cells.push_back(topology.node(cell, c));
        for (const double s : internal_force.cauchy_stress(state, cell))
          stress.values.push_back(static_cast<float>(s));
        material.values.push_back(topology.material(cell));
        fragment.values.push_back(static_cast<float>(fragments.of_cell[cell]));
      }
    solution.point_data = {displacement, speed};
    solution.cell_data  = {stress, material, fragment};
    return solution;
  }

  namespace
  {
    /** Means over the Gauss points of one cohesive face. */
    struct FaceMeans
    {
      double damage = 0, opening = 0, slip = 0, normal = 0, shear = 0;
      double opening_damage = 0, slip_damage = 0;

      /** Share of sliding in the damage, from 0 to 1. */
      double
      mode() const
      {
        const double total = opening_damage + slip_damage;
        return total > 0 ? slip_damage / total : 0;
      }
    };

    FaceMeans
    face_means(const State         &state,
               const CohesiveForce &force,
               const std::size_t    index)
    {
      static const FaceQuadrature quadrature;
      FaceMeans                   means;
      const CohesiveBatch &batch = force.faces().batches[index / batch_size];
      for (unsigned int q = 0; q < n_face_points; ++q)
        {
          const double weight = quadrature.weight[q];
          const auto   point  = get_point(batch, q, index % batch_size);
          const auto   now    = force.point_state(state, index, q);
          means.damage +=
            weight * std::min(1., std::hypot(point.opening, point.slip));
          means.opening_damage += weight * point.opening * point.opening;
          means.slip_damage += weight * point.slip * point.slip;
          means.opening += weight * now.jump[0];
          means.slip += weight * std::hypot(now.jump[1], now.jump[2]);
          means.normal += weight * now.traction[0];
          means.shear += weight * std::hypot(now.traction[1], now.traction[2]);
        }
      return means;
    }
  } // namespace

  Solution
  fracture_solution(const State &state, const CohesiveForce &cohesive_force)
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

    const CohesiveFaces &faces = cohesive_force.faces();
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        const CohesiveBatch &batch = faces.batches[i / batch_size];
        for (unsigned int c = 0; c < 3; ++c)
          {
            solution.cells.push_back(
              static_cast<NodeIndex>(solution.points.size()));
            solution.points.push_back(
              .5 * (state.position(batch.minus[c][i % batch_size]) +
                    state.position(batch.plus[c][i % batch_size])));
          }
        const FaceMeans means    = face_means(state, cohesive_force, i);
        const double    values[] = {means.damage,
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
  state_hash(const Topology &topology, const State &state)
  {
    XXH3_state_t *hash = XXH3_createState();
    XXH3_64bits_reset(hash);
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      for (unsigned int c = 0; c < n_corners && !topology.is_padding(cell); ++c)
        {
          const NodeIndex       node    = topology.node(cell, c);
          const Vector3<double> data[2] = {state.displacement[node].vector(),
                                           state.velocity[node].vector()};
          XXH3_64bits_update(hash, data, sizeof(data));
        }
    char text[17];
    std::snprintf(text,
                  sizeof(text),
                  "%016llx",
                  static_cast<unsigned long long>(XXH3_64bits_digest(hash)));
    XXH3_freeState(hash);
    return text;
  }
} // namespace rift
