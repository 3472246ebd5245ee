#include <rift/solid/cell_kernel.h>
#include <rift/solid/internal_force.h>
#include <rift/solid/principal_stresses.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /**
     * While the squared norm of the strain is below this, no principal stretch
     * is below 0.8 and the volume ratio needs no look.
     */
    constexpr double safe_strain_squared = .02;

    /**
     * A StressBound as a bound of the norm of the deviator: all its numbers
     * divided by their factors of that norm in eq. (10).
     */
    class HotCheck
    {
    public:
      /** @param factors of all batches, or null. */
      HotCheck(const StressBound &bound, const Simd *factors)
        : factors(factors)
        , tensile_strength(inverse_tension_factor * bound.tensile_strength)
      {
        StressBound::ReducedFriction reduced = bound.friction_under_pressure();
        // Where it is negative, its magnitude counts.
        const double tan =
          std::max(bound.tan_friction_angle,
                   -reduced.at(StressBound::small_strain_squared));
        const double inverse_factor =
          1 / (std::sqrt(.5 * (1 + tan * tan)) + tan / std::sqrt(24.));
        cohesion                = inverse_factor * bound.cohesion;
        friction                = inverse_factor * bound.tan_friction_angle;
        friction_under_pressure = {inverse_factor * reduced.initial,
                                   inverse_factor * reduced.slope};
      }

      /** Where the norm of the deviator exceeds what the mean stress allows.
       *
       * @param s stress of the batch. */
      SimdMask
      hot_lanes(const std::size_t            batch,
                const SymmetricTensor<Simd> &s,
                const Simd                  &strain_squared) const
      {
        return factors == nullptr ?
                 hot_lanes(s, strain_squared, tensile_strength, cohesion) :
                 hot_lanes(s,
                           strain_squared,
                           tensile_strength * factors[batch],
                           cohesion * factors[batch]);
      }

    private:
      /** @tparam Strength double or Simd. */
      template <typename Strength>
      SimdMask
      hot_lanes(const SymmetricTensor<Simd> &s,
                const Simd                  &strain_squared,
                const Strength              &tensile_strength,
                const Strength              &cohesion) const
      {
        const Simd mean     = (s[0] + s[1] + s[2]) * (1. / 3.);
        const Simd deviator = contract(s, s) - 3. * mean * mean;
        const Simd tension  = tensile_strength - inverse_tension_factor * mean;
        const Simd shear =
          cohesion - max(friction * mean,
                         friction_under_pressure.at(strain_squared) * mean);
        const Simd allowed = max(min(tension, shear), Simd{});
        return (deviator >= allowed * allowed) |
               (strain_squared > StressBound::small_strain_squared);
      }

      static constexpr double inverse_tension_factor = 1.224744871391589;

      const Simd                  *factors;
      double                       tensile_strength, cohesion, friction;
      StressBound::ReducedFriction friction_under_pressure;
    };

    /**
     * Whether there is a strain anywhere: at the foot of a wave it is so small
     * that its square is zero.
     */
    bool
    is_strained(const SymmetricTensor<Simd> &strain)
    {
      SimdMask mask{};
      for (const Simd &component : strain)
        mask |= component != 0.;
      return any(mask);
    }
  } // namespace

  InternalForce::InternalForce(const Topology          &topology,
                               const ReferenceCellData &reference,
                               std::vector<Elasticity>  laws)
    : topology(topology)
    , reference(reference)
    , laws(std::move(laws))
  {
  }

  void
  InternalForce::watch(const StressBounds &new_bounds)
  {
    bounds = &new_bounds;
  }

  std::optional<FailedCell>
  InternalForce::add_to(State &state, Activity &activity)
  {
    hot.clear();
    std::optional<FailedCell> failed;
    for (const MaterialRange &range : topology.material_ranges)
      {
        if (std::holds_alternative<RigidElasticity>(laws[range.material]))
          continue;
        const bool is_watched =
          bounds != nullptr && bounds->materials[range.material].has_value();
        const auto failed_here = std::visit(
          [&](const auto &law) {
            using Law = std::decay_t<decltype(law)>;
            return is_watched ?
                     add_range<Law, true>(law, range, state, activity) :
                     add_range<Law, false>(law, range, state, activity);
          },
          laws[range.material]);
        if (!failed)
          failed = failed_here;
      }
    return failed;
  }

  template <typename Law, bool is_watched>
  std::optional<FailedCell>
  InternalForce::add_range(const Law           &the_law,
                           const MaterialRange &range,
                           State               &state,
                           Activity            &activity)
  {
    // A copy that nobody else can change stays in registers.
    const Law                 law = the_law;
    std::optional<FailedCell> failed;
    const HotCheck            check(
      is_watched ? *bounds->materials[range.material] : StressBound{0, 0, 0},
      is_watched && !bounds->factors.empty() ? bounds->factors.data() :
                                               nullptr);

    for (std::size_t b = range.begin; b < range.end; ++b)
      {
        if (!activity.is_awake(b))
          continue;
        const BatchNodes     &nodes = topology.batches[b];
        const ReferenceBatch &data  = reference[b];

        const Matrix3<Simd> h      = gradient(data, nodes, state.displacement);
        const auto          strain = green_lagrange_strain(h);
        const auto          stress = law.stress(strain);
        scatter_stress_force(data,
                             nodes,
                             first_piola_kirchhoff(h, stress),
                             state.force);

        const Simd strain_squared = contract(strain, strain);
        if (is_watched)
          {
            const SimdMask is_hot = check.hot_lanes(b, stress, strain_squared);
            if (any(is_hot))
              for (unsigned int lane = 0; lane < batch_size; ++lane)
                if (is_hot[lane] && !topology.is_padding(b * batch_size + lane))
                  hot.push_back(static_cast<CellIndex>(b * batch_size + lane));
          }
        // Written so that a strain that is not a number is caught, too.
        if (any(~(strain_squared < safe_strain_squared)) && !failed)
          {
            const Simd ratio = volume_ratio(h);
            for (unsigned int lane = 0; lane < batch_size && !failed; ++lane)
              if (!(ratio[lane] > smallest_volume_ratio))
                failed = {static_cast<CellIndex>(b * batch_size + lane),
                          ratio[lane]};
          }
        if (!activity.has_woken_neighbours(b) && is_strained(strain))
          activity.wake_neighbours(topology, b);
      }
    return failed;
  }

  InternalForce::BatchStress
  InternalForce::stress(const State &state, const std::size_t batch) const
  {
    BatchStress result;
    result.gradient =
      gradient(reference[batch], topology.batches[batch], state.displacement);
    result.strain = green_lagrange_strain(result.gradient);
    result.second =
      std::visit([&](const auto &law) { return law.stress(result.strain); },
                 laws[topology.batch_materials[batch]]);
    result.first = first_piola_kirchhoff(result.gradient, result.second);
    return result;
  }

  SymmetricTensor<double>
  InternalForce::cauchy_stress(const State &state, const CellIndex cell) const
  {
    // sigma = P F^T / J
    const unsigned int      lane  = cell % batch_size;
    const BatchStress       batch = stress(state, cell / batch_size);
    const double            ratio = volume_ratio(batch.gradient)[lane];
    SymmetricTensor<double> sigma{};
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        {
          double sum = batch.first[i][j][lane];
          for (unsigned int d = 0; d < dim; ++d)
            sum += batch.first[i][d][lane] * batch.gradient[j][d][lane];
          sigma[voigt[i][j]] = sum / ratio;
        }
    return sigma;
  }

  void
  InternalForce::declare_fields(FieldList &list, const InternalForce *force)
  {
    const auto stress = [force, state = list.state()](const std::size_t cell) {
      return force->cauchy_stress(*state, cell);
    };
    list.add("stress", "Pa", FieldLocation::cell, stress);
    list
      .add(
        "principal stress",
        "Pa",
        FieldLocation::cell,
        [stress](const std::size_t cell) {
          return principal_stresses(stress(cell));
        },
        FieldUse::on_request)
      .components = {"1", "2", "3"};
    list.add(
      "pressure",
      "Pa",
      FieldLocation::cell,
      [stress](const std::size_t cell) {
        const SymmetricTensor<double> s = stress(cell);
        return -(s[0] + s[1] + s[2]) / 3;
      },
      FieldUse::on_request);
  }

  ExactSum
  InternalForce::strain_energy(const State &state) const
  {
    ExactSum sum;
    for (std::size_t b = 0; b < topology.n_batches(); ++b)
      {
        const BatchStress of = stress(state, b);
        const Simd        energy =
          .5 * reference[b].volume * contract(of.second, of.strain);
        for (unsigned int lane = 0; lane < batch_size; ++lane)
          if (topology.owns_cell(b * batch_size + lane))
            sum.add(energy[lane]);
      }
    return sum;
  }
} // namespace rift
