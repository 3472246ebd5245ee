#ifndef rift_tests_cohesive_law_specimen_h
#define rift_tests_cohesive_law_specimen_h

#include <rift/cohesive/laws/mohr_coulomb.h>

/** A single point under the cohesive law. */
namespace rift::test
{
  using Vector = Vector3<double>;

  /** Granite, but for fracture energies that differ. */
  const FaceStrength strength =
    {15e6, 36.7e6, std::tan(.8727), std::tan(.8727), 400, 900};

  /** A stiffness at which no separation is too short for the softening. */
  constexpr double stiffness = 2e13;

  /** A point that is moved step by step; work is that of the trapezoidal rule,
   * as central differences do it, J/m^2. */
  template <typename AnyLaw>
  struct LawSpecimen
  {
    using Law = AnyLaw;

    explicit LawSpecimen(const double        stiffness = test::stiffness,
                         const FaceStrength &strength  = test::strength)
      : face_strength(strength)
      , constants(Law::make_constants(strength, stiffness))
      , point(Law::make_point(strength, constants))
    {
    }

    /** Straight to a jump in n steps. */
    void
    go_to(const Vector &target, const unsigned int n)
    {
      const Vector start = jump;
      for (unsigned int i = 1; i <= n; ++i)
        step_to(start + (static_cast<double>(i) / n) * (target - start));
    }

    void
    step_to(const Vector &target)
    {
      const Vector before      = point.traction;
      const auto   dissipation = law.update(point, constants, target);
      work += .5 * dot(before + point.traction, target - jump);
      fracture += dissipation.fracture;
      friction += dissipation.friction;
      jump = target;
    }

    double
    elastic_energy() const
    {
      return Law::elastic_energy(point, constants);
    }

    /** hold_traction() at the present jump. */
    void
    hold(const Vector &traction)
    {
      const InitialEnergy energy =
        Law::hold_traction(point, face_strength, constants, jump, traction);
      given.cohesive += energy.cohesive;
      given.frictional += energy.frictional;
    }

    double
    shear() const
    {
      return std::hypot(point.traction[1], point.traction[2]);
    }

    const FaceStrength                       face_strength;
    const Law                                law{};
    typename Law::template Constants<double> constants;
    typename Law::template Point<double>     point;
    Vector                                   jump = {{0, 0, 0}};
    double        work = 0, fracture = 0, friction = 0;
    InitialEnergy given = {0, 0};
  };

  template <typename Branch>
  using BranchSpecimen = LawSpecimen<MohrCoulomb<Branch>>;

  /** In the extrinsic model. */
  using Specimen = BranchSpecimen<StraightBranch>;

  /** Jumps beyond the peak at which a mode has separated, m. */
  const double full_opening = strength.fracture_energy_1 / Softening::integral /
                              strength.tensile_strength;
  const double full_slip =
    strength.fracture_energy_2 / Softening::integral / strength.cohesion;
} // namespace rift::test

#endif
