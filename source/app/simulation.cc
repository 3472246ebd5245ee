#include <rift/app/simulation.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/contact/contact_penalty.h>
#include <rift/material/wave_speeds.h>
#include <rift/mesh/partition.h>
#include <rift/solid/cell_frequency.h>
#include <rift/time_integration/central_difference.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    /** No body stands a step above the bound by this. */
    constexpr double largest_step_over_bound = 10;

    /** More are worth a warning. */
    constexpr double usual_number_of_steps = 1e7;

    /** Years of computing; more is a mistake in the scene. */
    constexpr double largest_number_of_steps = 1e12;

    std::vector<Elasticity>
    laws_of(const std::vector<MaterialParameters> &materials)
    {
      std::vector<Elasticity> laws;
      for (const MaterialParameters &material : materials)
        laws.push_back(make_elasticity(material));
      return laws;
    }

    std::vector<StiffnessMatrix>
    stiffnesses_of(const std::vector<Elasticity> &laws)
    {
      std::vector<StiffnessMatrix> stiffnesses;
      for (const Elasticity &law : laws)
        stiffnesses.push_back(stiffness_matrix(law));
      return stiffnesses;
    }

    /** The rank of each cell; on rank 0, which has the mesh. Collective. */
    std::vector<int>
    divide(const Parameters   &parameters,
           const MeshData     &mesh,
           const Communicator &communicator,
           const Restart      *restart)
    {
      std::vector<int> ranks;
      communicator.on_root([&] {
        std::vector<double> costs;
        if (restart != nullptr)
          costs =
            cell_costs(restart->state, mesh.cells.size(), restart->face_cost);
        ranks = partition_cells(mesh,
                                communicator.size(),
                                parameters.mesh.partition,
                                costs);
      });
      return ranks;
    }
  } // namespace

  Simulation::Simulation(const Parameters   &parameters,
                         Log                &log,
                         const Communicator &communicator,
                         const Restart      *restart)
    : parameters(parameters)
    , log(log)
    , mesh(restart != nullptr ? restart->mesh :
                                make_mesh(parameters, communicator))
    , body(make_body(parameters,
                     mesh,
                     divide(parameters, mesh, communicator, restart),
                     communicator,
                     log))
    , densities(densities_of(body.materials))
    , laws(laws_of(body.materials))
    , stiffnesses(stiffnesses_of(laws))
    , internal_force(body.discretization.topology,
                     body.discretization.reference,
                     laws)
    , activity(body.discretization.topology)
    , results(parameters, body)
  {
    choose_time_step(restart);
    make_modules();
    if (restart != nullptr)
      restore(*restart);
    else if (contact)
      {
        contact->follow(state(), dt);
        contact->refuse_overlaps(body.materials);
      }
    step_of_last_agreement = this->state().step;
    first_step             = this->state().step;
    saved_results =
      restart != nullptr ? std::optional(restart->results) : std::nullopt;
    timer.stop("setup");
  }

  void
  Simulation::make_modules()
  {
    auto &[topology, reference, state, exchange] = body.discretization;

    bool   moves_from_start = BodyForce::is_needed(parameters.body_force);
    double viscosity        = 0;
    std::vector<double> viscosities;
    for (const MaterialParameters &material : body.materials)
      {
        const Vector3<double> &v = material.initial_velocity;
        moves_from_start |= dot(v, v) > 0;
        viscosity = std::max(viscosity, material.viscosity);
        viscosities.push_back(material.viscosity);
      }

    make_fracture();
    make_rigid_bodies();
    if (parameters.contact.is_active)
      make_contact();
    if (viscosity > 0)
      {
        damping.emplace(topology, reference, viscosities);
        exchange.include_velocities();
      }

    std::vector<PrescribedMotion::Boundary> moved;
    for (const BoundaryParameters &boundary : parameters.boundaries)
      {
        const Surface &surface = body.surfaces.at(boundary.name);
        if (SurfaceLoad::is_needed(boundary))
          surface_loads.emplace_back(topology, surface, boundary);
        if (boundary.absorbs)
          absorbing_boundaries.emplace_back(
            topology,
            reference,
            surface,
            [this](const std::uint16_t material, const Vector3<double> &n) {
              return impedance(stiffnesses[material], densities[material], n);
            });
        if (PrescribedMotion::is_needed(boundary))
          moved.push_back({surface, boundary});
      }
    if (!moved.empty())
      prescribed_motion.emplace(topology, moved);
    if (BodyForce::is_needed(parameters.body_force))
      body_force.emplace(parameters.body_force);
    if (moves_from_start)
      activity.wake_all(topology);
    exchange.send(topology, state, {}, {});
    exchange.receive(topology, state, activity);
  }

  void
  Simulation::make_fracture()
  {
    using Model                                  = CohesiveParameters::Model;
    const CohesiveParameters &cohesive           = parameters.cohesive;
    auto &[topology, reference, state, exchange] = body.discretization;
    if (cohesive.model == Model::none)
      return;
    const bool      is_extrinsic = cohesive.model == Model::extrinsic;
    const FaceSlope slope =
      is_extrinsic ? slopes_that_the_step_allows(topology,
                                                 reference,
                                                 stiffnesses,
                                                 densities,
                                                 critical.frequency_squared) :
                     FaceSlope(penalty_slopes());
    fracture.emplace(topology,
                     reference,
                     body.materials,
                     cohesive,
                     slope,
                     body.communicator);
    if (is_extrinsic)
      {
        fracture->insertion.emplace(topology,
                                    reference,
                                    internal_force,
                                    fracture->strengths,
                                    cohesive);
        internal_force.watch(fracture->strengths.stress_bounds());
      }
    else
      fracture->force.start_all(state);
  }

  void
  Simulation::make_rigid_bodies()
  {
    const auto &[topology, reference, state, exchange] = body.discretization;
    if (std::none_of(body.materials.begin(),
                     body.materials.end(),
                     [](const auto &m) { return m.is_rigid(); }))
      return;
    RigidPieces pieces;
    body.communicator.on_root(
      [&] { pieces = find_rigid_pieces(mesh, body.materials); });
    rigid_bodies.emplace(topology,
                         state,
                         share(pieces, body.communicator),
                         body.materials,
                         body.communicator);
    log.write("Rigid bodies: " + std::to_string(rigid_bodies->n_bodies()));
  }

  std::vector<ContactCellConstants>
  Simulation::contact_constants() const
  {
    const auto &[topology, reference, state, exchange] = body.discretization;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<ContactCellConstants> constants;
    for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
      {
        const ReferenceBatch &batch    = reference[cell / batch_size];
        const unsigned int    lane     = cell % batch_size;
        const std::uint16_t   material = topology.material(cell);
        const double          density  = densities[material];
        const std::uint32_t   rigid =
          rigid_bodies ? rigid_bodies->body(cell) : invalid_index;
        if (topology.is_padding(cell))
          constants.push_back({0, 0, invalid_index});
        else if (rigid != invalid_index && rigid_bodies->is_driven(material))
          // All of them together are as one body: nothing moves them.
          constants.push_back({infinity, infinity, rigid_bodies->n_bodies()});
        else
          {
            const double of_cell =
              largest_frequency_squared(batch,
                                        lane,
                                        stiffnesses[material],
                                        density) +
              (penalty_frequency ? penalty_frequency(cell) : 0);
            const double room = critical.frequency_squared - of_cell;
            constants.push_back({largest_penalty(batch, lane, density, room),
                                 density * batch.volume[lane],
                                 rigid});
          }
      }
    return constants;
  }

  void
  Simulation::make_contact()
  {
    ContactForce::Interface interface;
    interface.cells    = contact_constants();
    interface.damping  = parameters.contact.damping;
    interface.friction = [this](const std::uint32_t a, const std::uint32_t b) {
      return parameters.contact.friction_of(body.materials[a].name,
                                            body.materials[b].name);
    };
    // Whether the sides are bonded or a cohesive element resists their overlap.
    interface.is_held = [this](const FaceIndex face) {
      return topology().face_states[face] != FaceState::released;
    };
    if (fracture)
      {
        CohesiveForce &force = fracture->force;
        force.leave_failed_faces_to_contact(ContactForce::crack_interval);
        const CohesiveFaces &faces   = force.faces();
        interface.n_crack_events     = [&faces] { return faces.n_events(); };
        interface.for_each_open_face = [&faces](const auto &f) {
          for (std::size_t i = 0; i < faces.size(); ++i)
            if (faces.has_opened(i))
              f(faces.infos[i].face);
        };
      }
    else
      {
        interface.n_crack_events     = [] { return std::uint64_t(0); };
        interface.for_each_open_face = [](const auto &) {};
      }
    contact.emplace(topology(),
                    state(),
                    body.communicator,
                    std::move(interface));
    const auto [least, largest] = contact->penalty_range();
    log.write("Contact: penalties of the cells at surfaces from " +
              short_text(least) + " to " + short_text(largest) +
              " Pa, as large as the time step allows");
  }

  PenaltySlopes
  Simulation::penalty_slopes() const
  {
    return PenaltySlopes(body.discretization.topology,
                         body.discretization.reference,
                         body.discretization.state,
                         parameters.cohesive.penalty,
                         body.materials,
                         stiffnesses);
  }

  void
  Simulation::choose_time_step(const Restart *restart)
  {
    const bool is_extrinsic =
      parameters.cohesive.model == CohesiveParameters::Model::extrinsic;
    std::vector<MaterialLimits> limits;
    for (std::size_t i = 0; i < body.materials.size(); ++i)
      limits.push_back({body.materials[i].name,
                        stiffnesses[i],
                        densities[i],
                        body.materials[i].viscosity,
                        std::max(is_extrinsic && body.materials[i].breakable ?
                                   parameters.cohesive.stiffness_factor :
                                   0,
                                 parameters.contact.is_active ?
                                   parameters.contact.stiffness_factor :
                                   0)});
    if (parameters.cohesive.model == CohesiveParameters::Model::intrinsic)
      penalty_frequency = [slopes = penalty_slopes()](const CellIndex cell) {
        return slopes.frequency_squared(cell);
      };
    critical = critical_time_step(body.discretization.topology,
                                  body.discretization.reference,
                                  limits,
                                  body.communicator,
                                  penalty_frequency);

    const TimeParameters &time      = parameters.time;
    const double          safe_step = time.safety_factor * critical.time_step;
    dt = time.time_step > 0 ? time.time_step : safe_step;
    if (restart != nullptr)
      dt = restart->time_step;
    // A little tolerance, so that rounding does not add a step.
    const double n_steps = std::ceil(time.end_time / dt * (1 - 1e-12));
    if (!(dt > 0 && n_steps > 0 && n_steps <= largest_number_of_steps))
      throw InputError("to come to the end time of " + to_text(time.end_time) +
                       " s in steps of " + to_text(dt) + " s takes " +
                       to_text(n_steps) + " steps; rift counts to " +
                       to_text(largest_number_of_steps) +
                       ". Look at the end time, the time step, the stiffness "
                       "factor, the cohesive penalty and the viscosities.");
    last_step = static_cast<std::uint64_t>(n_steps);
    if (time.time_step == 0 && restart == nullptr)
      dt = time.end_time / last_step;
    // At the last step the results of the end may still be missing.
    if (restart != nullptr && restart->manifest.step > last_step)
      throw InputError(
        "the checkpoint is at t = " + to_text(restart->manifest.time) +
        " s, after the end time of " + to_text(time.end_time) +
        " s. Raise \"End time\" in subsection Time to go on.");
    log.write("Time step " + short_text(dt) + " s, " +
              short_text(dt / critical.time_step) + " times the bound set by " +
              critical.limited_by + "; " + std::to_string(last_step) +
              " steps");
    if (n_steps > usual_number_of_steps)
      log.write("WARNING: these are many steps. Is the end time in seconds?");
    if (dt > largest_step_over_bound * critical.time_step)
      throw InputError("the time step of " + to_text(dt) + " s is " +
                       short_text(dt / critical.time_step) +
                       " times the bound at which it is sure to be stable, " +
                       short_text(critical.time_step) +
                       " s. Set \"Time step = auto\" in subsection Time.");
    if (dt > critical.time_step)
      log.write("WARNING: the time step is above the bound at which it is "
                "sure to be stable");
  }

  void
  Simulation::step()
  {
    State &state = body.discretization.state;

    // 1. Insertion: faces of the cells that were near their strength
    TopologyChange change;
    if (fracture && !internal_force.hot_cells().empty())
      {
        change = split_at(
          fracture->insertion->find_faces(state, internal_force.hot_cells()));
        timer.stop("insertion");
      }

    // 2. Internal forces
    if (const auto failed = internal_force.add_to(state, activity))
      note_failure(*failed);
    timer.stop("internal forces");

    // 3. Cohesive tractions
    if (fracture)
      {
        fracture->force.add_to(state, activity);
        timer.stop("cohesive forces");
      }

    // 4. Contact, loads and damping
    if (contact)
      {
        if (const auto deep =
              contact->add_to(state, activity, state.step > 0 ? dt : 0))
          note_failure(*deep);
        timer.stop("contact");
      }
    for (SurfaceLoad &load : surface_loads)
      load.add_to(state, activity);
    if (body_force)
      body_force->add_to(state);
    if (damping)
      damping->add_to(state, activity);
    timer.stop("loads and damping");

    // 5. Nodes that have parted in this step stay together until its end
    std::vector<OpeningCorner> openings;
    if (fracture)
      {
        openings = fracture->force.hold_partings(
          state,
          [this](const NodeIndex node, const unsigned int component) {
            return prescribed_motion ?
                     prescribed_motion->acceleration(this->state(),
                                                     dt,
                                                     node,
                                                     component) :
                     std::optional<double>();
          });
        timer.stop("cohesive forces");
      }

    // 6. Absorbing boundaries, prescribed motion, rigid bodies
    if (state.step == 0)
      {
        start_velocities(state, dt);
        if (rigid_bodies)
          rigid_bodies->start(state, dt);
      }
    for (AbsorbingBoundary &boundary : absorbing_boundaries)
      boundary.add_to(state, dt);
    if (prescribed_motion)
      prescribed_motion->impose(state, activity, dt);
    if (rigid_bodies)
      rigid_bodies->move(state, activity, dt);
    timer.stop("loads and damping");

    // 7. Ledger and output at t_n, when due
    count_work();
    write_due_results();
    timer.stop("ledger and output");

    // 8. Kick and drift to t_(n+1)
    if (state.step == last_step)
      return;
    advance(state, activity, dt);
    timer.stop("kick and drift");

    // 9. Nodes of ghost cells follow those of their owners
    follow_neighbours(change.splits, openings);
    timer.stop("exchange");
    if (contact)
      {
        // Mostly waiting, which is not work that ranks have unequal parts of.
        contact->follow(state, dt);
        timer.stop("contact search");
      }

    // 10. Faces that begin to open take over the forces that held the nodes
    if (fracture)
      {
        fracture->force.start_openings(state, std::move(openings));
        timer.stop("cohesive forces");
      }
  }

  TopologyChange
  Simulation::split_at(const std::vector<FaceIndex> &faces)
  {
    if (faces.empty())
      return {};
    auto &[topology, reference, state, exchange] = body.discretization;
    TopologyChange change                        = split_nodes(topology, faces);
    if (change.splits.empty())
      return change;

    state.grow(change);
    for (const NodeSplit &split : change.splits)
      for (const NodeIndex part : split.parts)
        state.mass[part] = lumped_mass(topology, reference, densities, part);
    activity.grow(topology.n_nodes());
    fracture->force.apply(change);
    update_surfaces();
    return change;
  }

  void
  Simulation::follow_neighbours(const std::vector<NodeSplit> &splits,
                                std::vector<OpeningCorner>   &openings)
  {
    auto &[topology, reference, state, exchange] = body.discretization;
    exchange.send(topology, state, splits, openings);
    const auto change = exchange.receive(topology, state, activity);
    openings.insert(openings.end(),
                    change.openings.begin(),
                    change.openings.end());
    if (change.vertices.empty())
      return;
    fracture->force.update_nodes(change.vertices);
    update_surfaces();
  }

  void
  Simulation::update_surfaces()
  {
    for (SurfaceLoad &load : surface_loads)
      load.update_nodes();
    for (AbsorbingBoundary &boundary : absorbing_boundaries)
      boundary.update_nodes();
    if (prescribed_motion)
      prescribed_motion->update_nodes();
  }
} // namespace rift
