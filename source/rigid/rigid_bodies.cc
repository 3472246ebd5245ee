#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/rigid/rigid_bodies.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** The motion of a rigid body, for a checkpoint. */
    struct RigidBodyRecord
    {
      Vector3<double> displacement;
      double          rotation;
      Vector3<double> axis, velocity, angular_momentum;
    };
  } // namespace

  template <>
  struct HasPlainBytes<RigidBodyRecord> : std::true_type
  {
    static_assert(sizeof(RigidBodyRecord) == 13 * sizeof(double));
  };

  namespace
  {
    void
    add(const Vector3<double> &term, std::array<ExactSum, dim> &sums)
    {
      // Most nodes are not touched.
      for (unsigned int d = 0; d < dim; ++d)
        if (term[d] != 0)
          sums[d].add(term[d]);
    }

    /** Whether cells that share a face are of one body, or of none. */
    bool
    are_bodies_whole(const Topology                   &topology,
                     const std::vector<std::uint32_t> &body_of_slot,
                     const std::size_t                 n_bodies)
    {
      for (const Face &face : topology.faces)
        if (const std::uint32_t body = body_of_slot[face.cells[0]];
            body != body_of_slot[face.cells[1]] ||
            (body != invalid_index && body >= n_bodies))
          return false;
      return true;
    }
  } // namespace

  RigidBodies::RigidBodies(const Topology                        &topology,
                           const State                           &state,
                           const RigidPieces                     &pieces,
                           const std::vector<MaterialParameters> &materials,
                           const Communicator                    &communicator)
    : ModuleWithWork(topology, "rigid bodies", "loads")
    , topology(topology)
    , communicator(communicator)
    , body_of_slot(topology.n_cell_slots(), invalid_index)
    , bodies(pieces.materials.size())
  {
    for (const MaterialParameters &material : materials)
      {
        Drive drive;
        for (unsigned int d = 0; d < dim; ++d)
          if (!material.velocity[d].empty())
            drive[d].emplace(material.velocity[d],
                             "Material " + material.name + " / Velocity " +
                               "xyz"[d],
                             "m/s");
        drives.push_back(std::move(drive));
        material_names.push_back(material.name);
      }
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (!topology.is_padding(cell))
        body_of_slot[cell] =
          pieces.body_of_cell[topology.cell_global_indices[cell]];
    rift_check(are_bodies_whole(topology, body_of_slot, bodies.size()));
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        bodies[i].material = pieces.materials[i];
        bodies[i].motion.velocity =
          materials[bodies[i].material].initial_velocity;
      }
    find_nodes();
    compute_mass_properties(state);
  }

  void
  RigidBodies::find_nodes()
  {
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      if (body_of_slot[cell] != invalid_index)
        for (unsigned int c = 0; c < n_corners; ++c)
          if (const NodeIndex node = topology.node(cell, c);
              topology.is_complete(topology.node_vertices[node]))
            bodies[body_of_slot[cell]].nodes.push_back(node);
    for (Body &body : bodies)
      {
        std::sort(body.nodes.begin(), body.nodes.end());
        body.nodes.erase(std::unique(body.nodes.begin(), body.nodes.end()),
                         body.nodes.end());
      }
  }

  template <std::size_t n, typename Terms>
  std::vector<std::array<double, n>>
  RigidBodies::sum_over_nodes(const State &state, const Terms &terms) const
  {
    std::vector<std::array<ExactSum, n>> sums(bodies.size());
    std::vector<ExactSum *>              pointers;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        for (const NodeIndex node : bodies[i].nodes)
          if (topology.owns_node(node))
            {
              const std::array<double, n> of_node =
                terms(bodies[i], state.reference[node].vector());
              for (std::size_t k = 0; k < n; ++k)
                sums[i][k].add(state.mass[node] * of_node[k]);
            }
        for (ExactSum &sum : sums[i])
          pointers.push_back(&sum);
      }
    ExactSum::sum_over_ranks(pointers, communicator);
    std::vector<std::array<double, n>> result(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t k = 0; k < n; ++k)
        result[i][k] = sums[i][k].value();
    return result;
  }

  void
  RigidBodies::compute_mass_properties(const State &state)
  {
    // Mass and first moments, then second moments about the centre.
    const auto first =
      sum_over_nodes<4>(state, [](const Body &, const Vector3<double> &x) {
        return std::array<double, 4>{{1, x[0], x[1], x[2]}};
      });
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        const auto &[mass, x, y, z] = first[i];
        rift_check(mass > 0);
        bodies[i].mass.mass   = mass;
        bodies[i].mass.centre = (1 / mass) * Vector3<double>{{x, y, z}};
      }

    const auto second =
      sum_over_nodes<6>(state, [](const Body &body, const Vector3<double> &x) {
        const Vector3<double> r = x - body.mass.centre;
        return std::array<double, 6>{{r[0] * r[0],
                                      r[1] * r[1],
                                      r[2] * r[2],
                                      r[1] * r[2],
                                      r[2] * r[0],
                                      r[0] * r[1]}};
      });
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        const auto &[xx, yy, zz, yz, zx, xy] = second[i];
        RigidMass &mass                      = bodies[i].mass;
        mass.inertia                         = {{{{yy + zz, -xy, -zx}},
                                                 {{-xy, zz + xx, -yz}},
                                                 {{-zx, -yz, xx + yy}}}};
        mass.inverse_inertia                 = inverse(mass.inertia);
        rift_check(determinant(mass.inertia) > 0);
      }
  }

  void
  RigidBodies::sum_forces(const State &state)
  {
    for (Body &body : bodies)
      {
        body.force  = {};
        body.torque = {};
        const Vector3<double> centre =
          body.mass.centre + body.motion.displacement;
        for (const NodeIndex node : body.nodes)
          if (topology.owns_node(node))
            {
              const Vector3<double> force = state.force[node].vector();
              add(force, body.force);
              add(cross(state.position(node) - centre, force), body.torque);
            }
      }
  }

  std::vector<RigidBodies::Load>
  RigidBodies::total_loads() const
  {
    std::vector<std::array<ExactSum, 2 * dim>> sums;
    std::vector<ExactSum *>                    pointers;
    const auto is_free = [this](const Body &body) {
      return !is_driven(body.material);
    };
    for (const Body &body : bodies)
      if (is_free(body))
        sums.push_back({body.force[0],
                        body.force[1],
                        body.force[2],
                        body.torque[0],
                        body.torque[1],
                        body.torque[2]});
    for (auto &of_body : sums)
      for (ExactSum &sum : of_body)
        pointers.push_back(&sum);
    if (!pointers.empty())
      ExactSum::sum_over_ranks(pointers, communicator);

    std::vector<Load> loads(bodies.size(), Load{});
    auto              next = sums.begin();
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (is_free(bodies[i]))
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              loads[i].force[d]  = (*next)[d].value();
              loads[i].torque[d] = (*next)[dim + d].value();
            }
          ++next;
        }
    rift_check(next == sums.end());
    return loads;
  }

  bool
  RigidBodies::is_driven(const std::uint16_t material) const
  {
    const Drive &drive = drives[material];
    return drive[0] && drive[1] && drive[2];
  }

  bool
  RigidBodies::prescribes(const NodeIndex    node,
                          const unsigned int component) const
  {
    return std::any_of(bodies.begin(), bodies.end(), [&](const Body &body) {
      return drives[body.material][component] &&
             std::binary_search(body.nodes.begin(), body.nodes.end(), node);
    });
  }

  std::vector<std::string>
  RigidBodies::warnings(const Discretization &,
                        const double        time_step,
                        const std::uint64_t n_steps) const
  {
    std::vector<TimeFunction> functions;
    for (const Drive &drive : drives)
      for (const auto &component : drive)
        if (component)
          functions.push_back(*component);
    std::vector<std::string> result;
    if (communicator.is_root())
      add_doubts(functions, time_step, n_steps, result);
    return result;
  }

  std::vector<RigidBodies::DrivenVelocity>
  RigidBodies::driven_velocities(const double time,
                                 const double time_step) const
  {
    std::vector<DrivenVelocity> velocities;
    for (const Drive &drive : drives)
      {
        DrivenVelocity velocity;
        for (unsigned int d = 0; d < dim; ++d)
          if (drive[d])
            velocity[d] = drive[d]->mean_after(time, time_step);
        velocities.push_back(velocity);
      }
    return velocities;
  }

  RigidMotion
  RigidBodies::kicked(const Body           &body,
                      const Load           &load,
                      const DrivenVelocity &driven,
                      const double          time_step) const
  {
    RigidMotion motion = body.motion;
    for (unsigned int d = 0; d < dim; ++d)
      motion.velocity[d] = driven[d].value_or(
        motion.velocity[d] + time_step / body.mass.mass * load.force[d]);
    if (!driven[0] && !driven[1] && !driven[2])
      motion.angular_momentum += time_step * load.torque;
    return motion;
  }

  void
  RigidBodies::start(State &state, const double time_step)
  {
    sum_forces(state);
    const auto loads = total_loads();
    // At the start itself.
    const auto driven = driven_velocities(state.time, 0);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        Body &body = bodies[i];
        body.motion =
          kicked(body, loads[i], driven[body.material], -.5 * time_step);
        const Vector3<double> omega = angular_velocity(body.motion, body.mass);
        for (const NodeIndex node : body.nodes)
          {
            const Vector3<double> v =
              body.motion.velocity +
              cross(omega, state.reference[node].vector() - body.mass.centre);
            for (unsigned int d = 0; d < dim; ++d)
              state.velocity[node][d] = v[d];
          }
      }
  }

  void
  RigidBodies::move(State &state, Activity &activity, const double time_step)
  {
    sum_forces(state);
    const auto loads  = total_loads();
    const auto driven = driven_velocities(state.time, time_step);
    work_done.begin_step();
    std::string failure;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        Body &body  = bodies[i];
        body.motion = kicked(body, loads[i], driven[body.material], time_step);
        const auto &v = body.motion.velocity, &l = body.motion.angular_momentum;
        const char *fault = !std::isfinite(dot(v, v) + dot(l, l)) ?
                              " has a velocity that is not a number." :
                            !drift(body.motion, body.mass, time_step) ?
                              " turns by more than 60 degrees in a step." :
                              nullptr;
        if (fault != nullptr)
          {
            if (failure.empty())
              failure = "step " + std::to_string(state.step) +
                        ": a rigid body of " + material_names[body.material] +
                        fault + " Look at the last results in ParaView.";
            continue;
          }
        if (!body.is_awake && (dot(v, v) > 0 || dot(l, l) > 0))
          {
            body.is_awake = true;
            for (const NodeIndex node : body.nodes)
              activity.wake_node(topology, node);
          }
        move_nodes(body, state, time_step);
      }
    if (!failure.empty())
      throw CollectiveError(ExitCode::run_error, failure);
  }

  void
  RigidBodies::move_nodes(const Body  &body,
                          State       &state,
                          const double time_step)
  {
    const Drive &drive     = drives[body.material];
    const bool   has_drive = drive[0] || drive[1] || drive[2];
    for (const NodeIndex node : body.nodes)
      {
        // From the place itself, so that rounding does not add up.
        const Vector3<double> target =
          displacement_of(body.motion,
                          state.reference[node].vector() - body.mass.centre);
        const Vector3<double> before = state.velocity[node].vector();
        const Vector3<double> after =
          (1 / time_step) * (target - state.displacement[node].vector());
        const Vector3<double> needed =
          (state.mass[node] / time_step) * (after - before);
        const Vector3<double> reaction = needed - state.force[node].vector();
        // What keeps a free body rigid does no work.
        if (has_drive)
          work_done.add(node,
                        dot(reaction, before),
                        dot(reaction, after),
                        time_step);
        for (unsigned int d = 0; d < dim; ++d)
          state.force[node][d] = needed[d];
      }
  }

  std::array<ExactSum, dim>
  RigidBodies::force(const std::string &material) const
  {
    std::array<ExactSum, dim> sums;
    for (const Body &body : bodies)
      for (unsigned int d = 0;
           d < dim && material_names[body.material] == material;
           ++d)
        sums[d].add(body.force[d]);
    return sums;
  }

  void
  RigidBodies::declare_fields(FieldList &list, const RigidBodies *bodies)
  {
    list.add_of_material("force", "N", [bodies](const std::string &material) {
      return bodies->force(material);
    });
  }

  void
  RigidBodies::save(const Discretization &discretization,
                    Archive              &archive) const
  {
    // All ranks have the same.
    std::vector<RigidBodyRecord> records;
    for (const Body &body : bodies)
      if (communicator.is_root())
        records.push_back({body.motion.displacement,
                           body.motion.rotation.real,
                           body.motion.rotation.imaginary,
                           body.motion.velocity,
                           body.motion.angular_momentum});
    archive.write_list("rigid bodies", records);
    ModuleWithWork::save(discretization, archive);
  }

  void
  RigidBodies::load(const Discretization &discretization,
                    const Archive        &archive)
  {
    const auto records = archive.read_list<RigidBodyRecord>("rigid bodies");
    rift_check(records.size() == bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        const RigidBodyRecord &record = records.at(i);
        bodies[i].motion              = {record.displacement,
                                         {record.rotation, record.axis},
                                         record.velocity,
                                         record.angular_momentum};
      }
    ModuleWithWork::load(discretization, archive);
  }
} // namespace rift
