#include <rift/bonds/bond_solver.h>

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

    /** Whether a bond bears a traction. */
    bool
    bears(const Bond            &bond,
          const Vector3<double> &traction,
          const double           pressure_share)
    {
      const FaceStrength &strength = bond.strength;
      const double limit  = bond.memory.softening + bond.memory.excess;
      const double normal = dot(traction, bond.normal);
      double       friction = strength.tan_friction_angle;
      if (normal > 0)
        {
          if (normal > limit * strength.tensile_strength)
            return false;
        }
      else
        {
          if (pressure_share < 1)
            return false;
          friction = BondLaw::friction(strength, bond.memory);
        }
      const double largest_shear =
        limit * strength.cohesion - friction * normal;
      const double shear_squared =
        std::max(0., dot(traction, traction) - normal * normal);
      return largest_shear >= 0 &&
             shear_squared <= largest_shear * largest_shear;
    }

    Vector3<double>
    relative_velocity(const VertexBonds &group,
                      const Bond        &bond,
                      const State       &state)
    {
      return state.velocity[group.parts[bond.parts[1]]].vector() -
             state.velocity[group.parts[bond.parts[0]]].vector();
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
    before.resize(group.bonds.size());
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      before[i] = group.bonds[i].traction;
    prepare(group, state, time_step);
    solve(group, state, time_step);
    bool any_fails = false;
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double force = bond.area * bond.traction[d];
            state.force[group.parts[bond.parts[0]]][d] += force;
            state.force[group.parts[bond.parts[1]]][d] -= force;
          }
        finish(group, bond, before[i], state, time_step);
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
      velocity[p] = state.velocity[group.parts[p]].row() +
                    (time_step / group.masses[p]) *
                      state.force[group.parts[p]].row();
    if (group.prescribed == Prescribed::no)
      return false;
    group.prescribed = Prescribed::no;
    for (std::size_t p = 0; p < n && prescribed; ++p)
      for (unsigned int d = 0; d < dim; ++d)
        if (const auto acceleration = prescribed(group.parts[p], d))
          {
            velocity[p][d] = state.velocity[group.parts[p]][d] +
                             time_step * *acceleration;
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
          !bears(bond, traction(bond), share[i]))
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
    count_energy(bond,
                 .5 * (bond.is_counted ? bond.traction :
                                         bond.traction + traction_before),
                 time_step * relative_velocity(group, bond, state));
    if (bond.is_new)
      {
        const auto t       = BondLaw::split(bond.traction, bond.normal);
        bond.memory.excess = std::max(
          0.,
          BondLaw::demand(bond.strength,
                          t.normal,
                          norm(t.shear),
                          bond.strength.tan_friction_angle) -
            1);
      }
    bond.is_new = bond.is_counted = false;
  }

  void
  BondSolver::prepare(VertexBonds  &group,
                      const State  &state,
                      const double  time_step)
  {
    if (group.prescribed == VertexBonds::Prescribed::no)
      {
        inverse_mass.resize(group.parts.size());
        for (std::size_t p = 0; p < group.parts.size(); ++p)
          inverse_mass[p].fill(1 / group.masses[p]);
      }
    stiffness.resize(group.bonds.size());
    gap.resize(group.bonds.size());
    for (std::size_t i = 0; i < group.bonds.size(); ++i)
      {
        const Bond &bond = group.bonds[i];
        if (bond.is_released)
          continue;
        const auto [a, b] = bond.parts;
        gap[i] =
          std::max(0., dot(jump_of(group, bond, state), bond.normal));
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double mobility =
              bond.area * time_step * (inverse_mass[a][d] + inverse_mass[b][d]);
            // Where both nodes are moved, nothing moves them but that.
            stiffness[i][d] = mobility > 0 ? 1 / mobility : 0;
          }
        push(bond, bond.traction, time_step);
      }
  }

  void
  BondSolver::push(const Bond            &bond,
                   const Vector3<double> &traction,
                   const double           time_step)
  {
    const double factor = time_step * bond.area;
    const auto [a, b]   = bond.parts;
    for (unsigned int d = 0; d < dim; ++d)
      {
        velocity[a][d] += factor * inverse_mass[a][d] * traction[d];
        velocity[b][d] -= factor * inverse_mass[b][d] * traction[d];
      }
  }

  void
  BondSolver::solve(VertexBonds &group, const State &, const double time_step)
  {
    // One bond alone is exact at once.
    const unsigned int most_turns = group.n_active > 1 ? 30 : 1;
    const bool         any_new    = std::any_of(group.bonds.begin(),
                                     group.bonds.end(),
                                     [](const Bond &b) { return b.is_new; });
    const double       tolerance  = any_new ? 1e-6 : 1e-3;
    for (unsigned int turn = 0; turn < most_turns; ++turn)
      {
        double change = 0, scale = 0;
        for (std::size_t i = 0; i < group.bonds.size(); ++i)
          {
            Bond &bond = group.bonds[i];
            if (bond.is_released)
              continue;
            const Vector3<double> &normal = bond.normal;
            const Vector3<double>  relative =
              vector(velocity[bond.parts[1]] - velocity[bond.parts[0]]);
            Vector3<double> trial = bond.traction;
            double          along = 0;
            for (unsigned int d = 0; d < dim; ++d)
              {
                trial[d] += stiffness[i][d] * relative[d];
                along += normal[d] * normal[d] * stiffness[i][d];
              }
            if (!bond.is_new)
              {
                BondLaw::Traction parts = BondLaw::split(trial, normal);
                if (parts.normal < 0)
                  parts.normal *= share[i];
                const BondLaw::Traction borne =
                  BondLaw::bear(bond.strength,
                                bond.memory,
                                parts,
                                parts.normal + along * gap[i] / time_step);
                trial = borne.normal * normal + borne.shear;
              }
            const Vector3<double> difference = trial - bond.traction;
            push(bond, difference, time_step);
            bond.traction = trial;
            change        = std::max(change, dot(difference, difference));
            scale         = std::max(
              scale,
              dot(trial, trial) + 1e-6 * bond.strength.tensile_strength *
                                    bond.strength.tensile_strength);
          }
        if (change <= tolerance * tolerance * scale)
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
