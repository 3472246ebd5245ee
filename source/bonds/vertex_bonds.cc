#include <rift/base/check.h>
#include <rift/bonds/vertex_bonds.h>

#include <algorithm>

namespace rift
{
  void
  count_energy(BondEnergy            &energy,
               const Bond            &bond,
               const Vector3<double> &mean_traction,
               const Vector3<double> &motion)
  {
    const BondLaw::Traction t    = BondLaw::split(mean_traction, bond.normal);
    const double            work = bond.area * dot(mean_traction, motion);
    double                  friction = 0, closing = 0;
    if (t.normal < 0)
      {
        const double shear = norm(t.shear);
        closing            = bond.area * t.normal * dot(bond.normal, motion);
        if (shear > 0)
          friction = std::min(1.,
                              -bond.envelope.friction_under_pressure *
                                t.normal / shear) *
                     std::max(0., bond.area * dot(t.shear, motion));
      }
    energy.friction += friction;
    energy.closing += closing;
    energy.fracture += work - friction - closing;
  }

  void
  update_gap(const VertexBonds &group,
             Bond              &bond,
             const BondHistory &history,
             const State       &state)
  {
    constexpr double rounding = 1e-9;
    const double     opening  = dot(jump_of(group, bond, state), bond.normal);
    bond.gap                  = opening > rounding * history.size ? opening : 0;
  }

  double
  pressure_share_of(const VertexBonds &group,
                    const Bond        &bond,
                    const BondHistory &history,
                    const State       &state)
  {
    if (history.memory.damage < 1)
      return 1;
    const Vector3<double> jump = jump_of(group, bond, state);
    const double slip = norm(jump - dot(jump, bond.normal) * bond.normal);
    return std::clamp(1 - (slip / history.size - slip_to_contact) /
                            slip_of_fading,
                      0.,
                      1.);
  }

  void
  set_laplacian(VertexBonds &group)
  {
    group.n_active = 0;
    for (const Bond &bond : group.bonds)
      group.n_active += bond.is_released ? 0 : 1;
    const std::size_t n = group.parts.size();
    for (std::uint32_t p = 0; p < n; ++p)
      group.parts[p].root = p;
    for (bool changes = true; changes;)
      {
        changes = false;
        for (const Bond &bond : group.bonds)
          {
            if (bond.is_released)
              continue;
            std::uint32_t &a = group.parts[bond.parts[0]].root;
            std::uint32_t &b = group.parts[bond.parts[1]].root;
            changes |= a != b;
            a = b = std::min(a, b);
          }
      }
    // Roots have a potential of zero: their rows are those of the unit matrix.
    std::vector<double> matrix(n * n, 0);
    for (std::uint32_t p = 0; p < n; ++p)
      if (group.parts[p].root == p)
        matrix[p * n + p] = 1;
    for (const Bond &bond : group.bonds)
      for (unsigned int side = 0; side < 2 && !bond.is_released; ++side)
        {
          const std::uint32_t p = bond.parts[side], q = bond.parts[1 - side];
          if (group.parts[p].root == p)
            continue;
          matrix[p * n + p] += bond.area;
          if (group.parts[q].root != q)
            matrix[p * n + q] -= bond.area;
        }
    // Gauss and Jordan: positive definite, no pivots are needed.
    group.inverse.assign(n * n, 0);
    for (std::uint32_t p = 0; p < n; ++p)
      group.inverse[p * n + p] = 1;
    for (std::size_t k = 0; k < n; ++k)
      {
        rift_check(matrix[k * n + k] > 0);
        const double pivot = 1 / matrix[k * n + k];
        for (std::size_t j = 0; j < n; ++j)
          {
            matrix[k * n + j] *= pivot;
            group.inverse[k * n + j] *= pivot;
          }
        for (std::size_t i = 0; i < n; ++i)
          if (const double factor = matrix[i * n + k]; i != k && factor != 0)
            for (std::size_t j = 0; j < n; ++j)
              {
                matrix[i * n + j] -= factor * matrix[k * n + j];
                group.inverse[i * n + j] -= factor * group.inverse[k * n + j];
              }
      }
  }
} // namespace rift
