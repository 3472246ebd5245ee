#include <rift/bonds/bond_solver.h>
#include <rift/bonds/weakest_planes.h>

#include <algorithm>
#include <cmath>

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

    /** Whether a bond bears a traction; an open one bears no pressure. */
    bool
    bears(const VertexBonds     &group,
          const Bond            &bond,
          const Vector3<double> &traction,
          const double           pressure_share,
          const State           &state)
    {
      // Nodes that have moved as one differ by rounding.
      constexpr double rounding = 1e-9;
      const double     normal   = dot(traction, bond.normal);
      if (normal < 0 &&
          (pressure_share < 1 || dot(jump_of(group, bond, state), bond.normal) >
                                   rounding * bond.size))
        return false;
      const BondLaw::Borne borne =
        BondLaw::bear(BondLaw::envelope(bond.strength, bond.memory),
                      normal,
                      std::max(0., dot(traction, traction) - normal * normal),
                      normal);
      return borne.normal == normal && borne.shear_factor == 1;
    }
  } // namespace

  bool
  BondSolver::hold(VertexBonds                  &group,
                   State                        &state,
                   const double                  time_step,
                   const PrescribedAcceleration &prescribed)
  {
    const bool is_moved = kick(group, state, time_step, prescribed);
    share.resize(group.bonds.size());
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      share[i] = pressure_share(group, group.bonds[i], state);
    if (!is_moved && tie(group, state, time_step))
      return false;
    prepare(group, state, time_step);
    solve(group);
    bool any_fails = false;
    for (const Unknown &unknown : unknowns)
      {
        Bond                 &bond            = group.bonds[unknown.place];
        const Vector3<double> traction_before = bond.traction;
        bond.traction                         = vector(unknown.traction);
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double force = bond.area * bond.traction[d];
            state.force[group.parts[bond.parts[0]]][d] += force;
            state.force[group.parts[bond.parts[1]]][d] -= force;
          }
        finish(group, bond, traction_before, state, time_step);
        bond.is_tied = false;
        any_fails |= soften(bond, time_step);
      }
    return any_fails;
  }

  bool
  BondSolver::kick(VertexBonds                  &group,
                   const State                  &state,
                   const double                  time_step,
                   const PrescribedAcceleration &prescribed)
  {
    using Prescribed    = VertexBonds::Prescribed;
    const std::size_t n = group.parts.size();
    velocity.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      velocity[p] =
        state.velocity[group.parts[p]].row() +
        (time_step / group.masses[p]) * state.force[group.parts[p]].row();
    if (group.prescribed == Prescribed::no)
      return false;
    group.prescribed = Prescribed::no;
    for (std::size_t p = 0; p < n && prescribed; ++p)
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto acceleration = prescribed(group.parts[p], d))
          {
            velocity[p][d] =
              state.velocity[group.parts[p]][d] + time_step * *acceleration;
            group.prescribed = Prescribed::yes;
          }
    inverse_mass.resize(n);
    for (std::size_t p = 0; p < n && group.prescribed == Prescribed::yes; ++p)
      for (unsigned int d = 0; d < dim; ++d)
        inverse_mass[p][d] =
          prescribed(group.parts[p], d) ? 0 : 1 / group.masses[p];
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
        mass[group.root[p]] += group.masses[p];
        momentum[group.root[p]] += group.masses[p] * velocity[p];
      }
    bond_force.resize(n);
    for (std::size_t p = 0; p < n; ++p)
      {
        const std::uint32_t root = group.root[p];
        bond_force[p]            = (group.masses[p] / time_step) *
                        (momentum[root] / mass[root] - velocity[p]);
      }
    potential.assign(n, Row{});
    for (std::size_t p = 0; p < n; ++p)
      if (group.root[p] != p)
        for (std::size_t q = 0; q < n; ++q)
          potential[p] += group.inverse[p * n + q] * bond_force[q];
    const auto traction = [this](const Bond &bond) {
      return vector(potential[bond.parts[0]] - potential[bond.parts[1]]);
    };
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      if (const Bond &bond = group.bonds[i];
          !bond.is_new && !bond.is_released &&
          !bears(group, bond, traction(bond), share[i], state))
        return false;

    for (std::size_t p = 0; p < n; ++p)
      state.force[group.parts[p]].row() += bond_force[p];
    for (Bond &bond : group.bonds)
      {
        if (bond.is_released)
          continue;
        const Vector3<double> traction_before = bond.traction;
        bond.traction                         = traction(bond);
        if (!bond.is_tied)
          finish(group, bond, traction_before, state, time_step);
        bond.is_tied = true;
      }
    return true;
  }

  void
  BondSolver::finish(const VertexBonds     &group,
                     Bond                  &bond,
                     const Vector3<double> &traction_before,
                     const State           &state,
                     const double           time_step)
  {
    count_energy(
      bond,
      .5 * (bond.is_counted ? bond.traction : bond.traction + traction_before),
      time_step * relative_velocity(group, bond, state));
    if (bond.is_new)
      {
        const auto t = BondLaw::split(bond.traction, bond.normal);
        bond.memory.excess =
          std::max(0., demand_on({t.normal, norm(t.shear)}, bond.strength) - 1);
      }
    bond.is_new = bond.is_counted = false;
  }

  void
  BondSolver::prepare(const VertexBonds &group,
                      const State       &state,
                      const double       time_step)
  {
    if (group.prescribed == VertexBonds::Prescribed::no)
      {
        inverse_mass.resize(group.parts.size());
        for (std::size_t p = 0; p < group.parts.size(); ++p)
          inverse_mass[p] = Row{} + 1 / group.masses[p];
      }
    unknowns.clear();
    for (std::uint32_t i = 0; i < group.bonds.size(); ++i)
      {
        const Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
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
        u.envelope = BondLaw::envelope(bond.strength, bond.memory);
        const double gap =
          std::max(0., dot(jump_of(group, bond, state), bond.normal));
        u.closing = product(u.normal * u.normal, u.stiffness) * gap / time_step;
        u.pressure_share            = share[i];
        constexpr double negligible = 1e-4;
        u.negligible = std::pow(negligible * bond.strength.tensile_strength, 2);
        u.place      = i;
        u.is_new     = bond.is_new;
        push(u, u.traction);
        unknowns.push_back(u);
      }
  }

  void
  BondSolver::solve(const VertexBonds &group)
  {
    // One bond alone is exact at once.
    const unsigned int most_turns = group.n_active > 1 ? 30 : 1;
    const bool         any_new    = std::any_of(unknowns.begin(),
                                     unknowns.end(),
                                     [](const Unknown &u) { return u.is_new; });
    const double       tolerance  = any_new ? 1e-6 : 1e-3;
    for (unsigned int turn = 0; turn < most_turns; ++turn)
      {
        bool do_agree = true;
        for (Unknown &u : unknowns)
          {
            Row trial = u.traction + u.stiffness * (velocity[u.parts[1]] -
                                                    velocity[u.parts[0]]);
            if (!u.is_new)
              {
                const double normal = product(trial, u.normal);
                const Row    shear  = trial - normal * u.normal;
                const double push_of =
                  normal < 0 ? normal * u.pressure_share : normal;
                const BondLaw::Borne borne =
                  BondLaw::bear(u.envelope,
                                push_of,
                                product(shear, shear),
                                push_of + u.closing);
                trial = borne.normal * u.normal + borne.shear_factor * shear;
              }
            const Row difference = trial - u.traction;
            push(u, difference);
            u.traction = trial;
            do_agree &= product(difference, difference) <=
                        tolerance * tolerance * product(trial, trial) +
                          (any_new ? 0 : u.negligible);
          }
        if (do_agree)
          break;
      }
  }

  bool
  BondSolver::soften(Bond &bond, const double time_step) const
  {
    const Vector3<double> motion =
      time_step * vector(velocity[bond.parts[1]] - velocity[bond.parts[0]]);
    const double opening = dot(motion, bond.normal);
    const double before  = bond.memory.damage;
    law.soften(bond.strength,
               bond.memory,
               BondLaw::split(bond.traction, bond.normal),
               opening,
               motion - opening * bond.normal);
    return bond.memory.damage >= 1 && before < 1;
  }
} // namespace rift
