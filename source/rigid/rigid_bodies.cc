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

    /** Of a sum that is the same on all ranks. */
    Vector3<double>
    values(const std::array<ExactSum, dim> &sums)
    {
      return {{sums[0].value(), sums[1].value(), sums[2].value()}};
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
    : topology(topology)
    , communicator(communicator)
    , body_of_slot(topology.n_cell_slots(), invalid_index)
    , bodies(pieces.materials.size())
    , work_done(topology)
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

  void
  RigidBodies::compute_mass_properties(const State &state)
  {
    // Mass and first moments, then second moments about the centre.
    struct Moments
    {
      ExactSum                  mass;
      std::array<ExactSum, dim> first;
      std::array<ExactSum, dim> squares, products;
    };
    std::vector<Moments> moments(bodies.size());
    const auto           sum_over_nodes = [&](const auto &add_node) {
      for (std::size_t i = 0; i < bodies.size(); ++i)
        for (const NodeIndex node : bodies[i].nodes)
          if (topology.owns_node(node))
            add_node(bodies[i],
                     moments[i],
                     state.mass[node],
                     state.reference[node].vector());
    };
    const auto sum_over_ranks = [&](const auto &members) {
      std::vector<ExactSum *> sums;
      for (Moments &of_body : moments)
        for (ExactSum *sum : members(of_body))
          sums.push_back(sum);
      ExactSum::sum_over_ranks(sums, communicator);
    };

    sum_over_nodes([](const Body &,
                      Moments               &sums,
                      const double           mass,
                      const Vector3<double> &x) {
      sums.mass.add(mass);
      add(mass * x, sums.first);
    });
    sum_over_ranks([](Moments &m) {
      return std::vector<ExactSum *>{&m.mass,
                                     &m.first[0],
                                     &m.first[1],
                                     &m.first[2]};
    });
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        RigidMass &mass = bodies[i].mass;
        mass.mass       = moments[i].mass.value();
        rift_check(mass.mass > 0);
        mass.centre = (1 / mass.mass) * values(moments[i].first);
      }

    sum_over_nodes([](const Body            &body,
                      Moments               &sums,
                      const double           mass,
                      const Vector3<double> &x) {
      const Vector3<double> r = x - body.mass.centre;
      add(mass * Vector3<double>{{r[0] * r[0], r[1] * r[1], r[2] * r[2]}},
          sums.squares);
      add(mass * Vector3<double>{{r[1] * r[2], r[2] * r[0], r[0] * r[1]}},
          sums.products);
    });
    sum_over_ranks([](Moments &m) {
      return std::vector<ExactSum *>{&m.squares[0],
                                     &m.squares[1],
                                     &m.squares[2],
                                     &m.products[0],
                                     &m.products[1],
                                     &m.products[2]};
    });
    for (std::size_t i = 0; i < bodies.size(); ++i)
      {
        const Vector3<double> s = values(moments[i].squares),
                              p = values(moments[i].products);
        RigidMass &mass         = bodies[i].mass;
        mass.inertia            = {{{{s[1] + s[2], -p[2], -p[1]}},
                                    {{-p[2], s[2] + s[0], -p[0]}},
                                    {{-p[1], -p[0], s[0] + s[1]}}}};
        mass.inverse_inertia    = inverse(mass.inertia);
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
  RigidBodies::save(const Discretization &, Archive &archive) const
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
    work_done.save("rigid bodies", archive);
  }

  void
  RigidBodies::load(const Discretization &, const Archive &archive)
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
    work_done.load("rigid bodies", archive);
  }
} // namespace rift
