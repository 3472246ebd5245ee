#include <rift/bonds/bond_solver.h>
#include <rift/bonds/weakest_planes.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  namespace
  {
    Vector3<double>
    vector(const Row &row)
    {
      return {{row[0], row[1], row[2]}};
    }

    Row
    row(const Vector3<double> &vector)
    {
      return Row{vector[0], vector[1], vector[2], 0};
    }

    double
    product(const Row &a, const Row &b)
    {
      const Row p = a * b;
      return p[0] + p[1] + p[2];
    }

    /** Two tractions agree if they differ by less than this share of them or of
     * the tensile strength; of themselves alone in the first step of a bond. */
    constexpr double tolerance = 1e-2, tolerance_at_start = 1e-6;

    /** Whether a bond bears a traction; one that is open or leaves its pressure
     * to contact bears no pressure. */
    bool
    bears(const Bond            &bond,
          const Vector3<double> &traction,
          const double           pressure_share)
    {
      const double normal = dot(traction, bond.normal);
      if (normal < 0 && (pressure_share < 1 || bond.gap > 0))
        return false;
      return BondLaw::bears(bond.envelope,
                            normal,
                            dot(traction, traction) - normal * normal);
    }
  } // namespace

  bool
  BondSolver::hold(VertexBonds                  &group,
                   State                        &state,
                   const double                  time_step,
                   const PrescribedAcceleration &prescribed)
  {
    const bool any_prescribed =
      find_free_velocities(group, state, time_step, prescribed);
    if (!any_prescribed && !group.is_yielding && tie(group, state, time_step))
      return false;
    prepare(group, state, time_step);
    solve(group);
    bool any_fails    = false;
    group.is_yielding = unknowns.size() < group.n_active;
    for (const Unknown &unknown : unknowns)
      {
        Bond                 &bond            = group.bonds[unknown.place];
        const Vector3<double> traction_before = bond.traction;
        bond.traction                         = vector(unknown.traction);
        group.is_yielding |= unknown.is_yielding;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double force = bond.area * bond.traction[d];
            state.force[group.parts[bond.parts[0]].node][d] += force;
            state.force[group.parts[bond.parts[1]].node][d] -= force;
          }
        finish(group, unknown.place, traction_before, state, time_step);
        if (unknown.is_yielding || unknown.is_new)
          any_fails |= soften(bond, group.histories[unknown.place], time_step);
      }
    return any_fails;
  }

  bool
  BondSolver::find_free_velocities(VertexBonds                  &group,
                                   const State                  &state,
                                   const double                  time_step,
                                   const PrescribedAcceleration &prescribed)
  {
    using Prescribed    = VertexBonds::Prescribed;
    const std::size_t n = group.parts.size();
    velocity.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        const auto &[node, root, mass] = group.parts[p];
        velocity[p]                    = state.velocity[node].row() +
                      (time_step / mass) * state.force[node].row();
      }
    if (group.prescribed == Prescribed::no)
      return false;
    group.prescribed = Prescribed::no;
    for (std::size_t p = 0; p < n && prescribed; ++p)
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto acceleration = prescribed(group.parts[p].node, d))
          {
            velocity[p][d] = state.velocity[group.parts[p].node][d] +
                             time_step * *acceleration;
            group.prescribed = Prescribed::yes;
          }
    inverse_mass.resize(n);
    for (std::size_t p = 0; p < n && group.prescribed == Prescribed::yes; ++p)
      for (unsigned int d = 0; d < dim; ++d)
        inverse_mass[p][d] =
          prescribed(group.parts[p].node, d) ? 0 : 1 / group.parts[p].mass;
    return group.prescribed == Prescribed::yes;
  }

  bool
  BondSolver::tie(VertexBonds &group, State &state, const double time_step)
  {
    const std::size_t n = group.parts.size();
    mass.assign(n, 0);
    momentum.assign(n, Row{});
    for (std::size_t p = 0; p < n; ++p)
      {
        const VertexBonds::Part &part = group.parts[p];
        mass[part.root] += part.mass;
        momentum[part.root] += part.mass * velocity[p];
      }
    bond_force.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        const VertexBonds::Part &part = group.parts[p];
        bond_force[p]                 = (part.mass / time_step) *
                        (momentum[part.root] / mass[part.root] - velocity[p]);
      }
    potential.assign(n, Row{});
    for (std::size_t p = 0; p < n; ++p)
      if (group.parts[p].root != p)
        for (std::size_t q = 0; q < n; ++q)
          potential[p] += group.inverse[p * n + q] * bond_force[q];
    const auto traction = [this](const Bond &bond) {
      return vector(potential[bond.parts[0]] - potential[bond.parts[1]]);
    };
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond = group.bonds[i];
        if (bond.is_new || bond.is_released)
          continue;
        double share = bond.pressure_share;
        if (!bond.is_tied)
          {
            update_gap(group, bond, group.histories[i], state);
            share = pressure_share(group, i, state);
          }
        if (!bears(bond, traction(bond), share))
          return false;
      }

    for (std::size_t p = 0; p < n; ++p)
      state.force[group.parts[p].node].row() += bond_force[p];
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        const Vector3<double> traction_before = bond.traction;
        bond.traction                         = traction(bond);
        if (!bond.is_tied)
          finish(group, i, traction_before, state, time_step);
        bond.is_tied = true;
      }
    return true;
  }

  void
  BondSolver::finish(VertexBonds           &group,
                     const std::size_t      place,
                     const Vector3<double> &traction_before,
                     const State           &state,
                     const double           time_step)
  {
    Bond &bond = group.bonds[place];
    count_energy(
      group.energy,
      bond,
      .5 * (bond.is_counted ? bond.traction : bond.traction + traction_before),
      time_step * relative_velocity(group, bond, state));
    if (bond.is_new)
      {
        BondHistory &history = group.histories[place];
        const auto   t       = BondLaw::split(bond.traction, bond.normal);
        history.memory.excess =
          std::max(0.,
                   demand_on({t.normal, norm(t.shear)}, history.strength) - 1);
        bond.envelope = BondLaw::envelope(history.strength, history.memory);
      }
    bond.is_new = bond.is_counted = false;
  }

  double
  BondSolver::pressure_share(const VertexBonds &group,
                             const std::size_t  place,
                             const State       &state) const
  {
    return has_contact ? pressure_share_of(group,
                                           group.bonds[place],
                                           group.histories[place],
                                           state) :
                         1;
  }

  void
  BondSolver::prepare(VertexBonds &group,
                      const State &state,
                      const double time_step)
  {
    if (group.prescribed == VertexBonds::Prescribed::no)
      {
        inverse_mass.resize(group.parts.size());
        for (std::size_t p = 0; p < group.parts.size(); ++p)
          inverse_mass[p] = Row{} + 1 / group.parts[p].mass;
      }
    unknowns.clear();
    for (std::uint32_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        const BondHistory &history      = group.histories[i];
        const double       share_before = bond.pressure_share;
        update_gap(group, bond, history, state);
        bond.pressure_share = pressure_share(group, i, state);
        bond.is_tied        = false;
        Unknown u           = unknown(bond, time_step);
        u.place             = i;
        // What has been left to contact does not come back.
        u.largest_pressure =
          bond.pressure_share == 1 ?
            std::numeric_limits<double>::max() :
          bond.pressure_share == 0 ?
            0 :
            std::max(0., -dot(bond.traction, bond.normal)) *
              std::min(1., bond.pressure_share / share_before);
        u.negligible =
          std::pow(tolerance * history.strength.tensile_strength, 2);
        push(u, u.traction);
        unknowns.push_back(u);
      }
    // Bonds that have failed and stay open bear nothing.
    const auto stays_open = [&](const Unknown &u) {
      const Bond &bond  = group.bonds[u.place];
      const Row   speed = velocity[u.parts[1]] - velocity[u.parts[0]];
      return bond.envelope.tension <= 0 && !bond.is_new && bond.gap > 0 &&
             norm(bond.traction) <= bond.envelope.rounding &&
             bond.gap + time_step * product(speed, u.normal) > 0;
    };
    unknowns.erase(std::remove_if(unknowns.begin(), unknowns.end(), stays_open),
                   unknowns.end());
  }

  BondSolver::Unknown
  BondSolver::unknown(const Bond &bond, const double time_step) const
  {
    Unknown u;
    u.normal   = row(bond.normal);
    u.traction = row(bond.traction);
    for (unsigned int side = 0; side < 2; ++side)
      {
        u.parts[side] = bond.parts[side];
        u.mobility[side] =
          (time_step * bond.area) * inverse_mass[bond.parts[side]];
      }
    const Row mobility = u.mobility[0] + u.mobility[1];
    // Where both nodes are moved, nothing moves them but that.
    for (unsigned int d = 0; d < 4; ++d)
      u.stiffness[d] = mobility[d] > 0 ? 1 / mobility[d] : 0;
    u.envelope = bond.envelope;
    u.closing =
      product(u.normal * u.normal, u.stiffness) * bond.gap / time_step;
    u.is_new = bond.is_new;
    return u;
  }

  bool
  BondSolver::solve_once(const bool is_start)
  {
    const double share    = is_start ? tolerance_at_start : tolerance;
    bool         do_agree = true;
    for (Unknown &u : unknowns)
      {
        Row trial = u.traction +
                    u.stiffness * (velocity[u.parts[1]] - velocity[u.parts[0]]);
        u.is_yielding = false;
        if (!u.is_new)
          {
            const double         normal = product(trial, u.normal);
            const Row            shear  = trial - normal * u.normal;
            const double         kept   = std::max(normal, -u.largest_pressure);
            const BondLaw::Borne borne  = BondLaw::bear(u.envelope,
                                                       kept,
                                                       product(shear, shear),
                                                       kept + u.closing);
            u.is_yielding = borne.normal != normal || borne.shear_factor != 1;
            trial = borne.normal * u.normal + borne.shear_factor * shear;
          }
        const Row difference = trial - u.traction;
        push(u, difference);
        u.traction = trial;
        do_agree &=
          product(difference, difference) <=
          share * share * product(trial, trial) + (is_start ? 0 : u.negligible);
      }
    return do_agree;
  }

  void
  BondSolver::solve(const VertexBonds &group)
  {
    // One bond alone is exact at once.
    const unsigned int most_iterations = group.n_active > 1 ? 30 : 1;
    const bool         any_new         = std::any_of(unknowns.begin(),
                                     unknowns.end(),
                                     [](const Unknown &u) { return u.is_new; });
    for (unsigned int i = 0; i < most_iterations; ++i)
      if (solve_once(any_new))
        return;
  }

  bool
  BondSolver::soften(Bond        &bond,
                     BondHistory &history,
                     const double time_step) const
  {
    const Vector3<double> motion =
      time_step * vector(velocity[bond.parts[1]] - velocity[bond.parts[0]]);
    const double opening = dot(motion, bond.normal);
    const double before  = history.memory.damage;
    law.soften(history.strength,
               history.memory,
               BondLaw::split(bond.traction, bond.normal),
               opening,
               motion - opening * bond.normal);
    bond.envelope = BondLaw::envelope(history.strength, history.memory);
    return history.memory.damage >= 1 && before < 1;
  }
} // namespace rift
