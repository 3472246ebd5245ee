#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/material/elasticity.h>

#include <algorithm>
#include <cmath>

namespace rift
{
  namespace
  {
    /** With steeper ones, sliding faces were seen to make energy, rad. */
    constexpr double largest_friction_angle = 80.001 * M_PI / 180;

    /**
     * Of the modulus of elasticity. One that is mistaken for MPa lies below, as
     * strengths are less than a tenth of the modulus.
     */
    constexpr double smallest_strength = 1e-7;

    /** Of anything that breaks, J/m^2; glass has 4 to 10. */
    constexpr double smallest_fracture_energy = 1;

    /** Less than any grain, m. */
    constexpr double smallest_correlation_length = 1e-6;

    /** P-waves in solids, m/s. */
    constexpr double slowest_wave = 100, fastest_wave = 15000;

    constexpr std::size_t largest_number_of_crack_groups = 100;
    constexpr double      largest_crack_density          = 10;

    /** Faster are typing errors, m/s. */
    constexpr double largest_velocity = 2e4;

    using Matrix6 = std::array<std::array<double, 6>, 6>;

    // The stiffness in Kelvin's form, in which stress and strain are vectors
    // with the same scalar product and eigenvalues do not depend on the axes.
    Matrix6
    kelvin_matrix(const StiffnessMatrix &stiffness)
    {
      Matrix6 result;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = 0; j < 6; ++j)
          result[i][j] =
            (i < 3 ? 1 : M_SQRT2) * (j < 3 ? 1 : M_SQRT2) * stiffness[i][j];
      return result;
    }

    // By Jacobi's rotations, which make one entry beside the diagonal zero
    // after the other; ten sweeps are more than six rows ever need.
    double
    smallest_eigenvalue(Matrix6 a)
    {
      for (unsigned int sweep = 0; sweep < 10; ++sweep)
        for (unsigned int p = 0; p < 5; ++p)
          for (unsigned int q = p + 1; q < 6; ++q)
            {
              const double angle =
                0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
              const double c = std::cos(angle), s = std::sin(angle);
              for (unsigned int k = 0; k < 6; ++k)
                {
                  const double kp = a[k][p], kq = a[k][q];
                  a[k][p] = c * kp - s * kq;
                  a[k][q] = s * kp + c * kq;
                }
              for (unsigned int k = 0; k < 6; ++k)
                {
                  const double pk = a[p][k], qk = a[q][k];
                  a[p][k] = c * pk - s * qk;
                  a[q][k] = s * pk + c * qk;
                }
            }
      double result = a[0][0];
      for (unsigned int i = 1; i < 6; ++i)
        result = std::min(result, a[i][i]);
      return result;
    }

    /** Throws with the subsection of one material. */
    struct Refuse
    {
      std::string section;

      void
      operator()(const std::string &name, const std::string &problem) const
      {
        throw ParameterError(section, name, problem);
      }
    };

    void
    check_density(const MaterialParameters &material, const Refuse &refuse)
    {
      const double density = material.density;
      if (density >= 500 && density <= 25000)
        return;
      std::string problem = "a density is between 500 and 25000 kg/m^3.";
      if (density >= 0.5 && density <= 25)
        problem += " Is it in g/cm^3? rift uses kg/m^3: write " +
                   short_text(1000 * density) + ".";
      refuse("Density", problem);
    }

    // `modulus` of a P-wave, from the entry `name`.
    void
    check_wave_speed(const MaterialParameters &material,
                     const double              modulus,
                     const std::string        &name,
                     const Refuse             &refuse)
    {
      const double speed = std::sqrt(modulus / material.density);
      if (speed >= slowest_wave && speed <= fastest_wave)
        return;
      std::string problem = "this gives P-waves of " + short_text(speed) +
                            " m/s; solids have 100 to 15000 m/s.";
      for (const auto &[unit, factor] :
           {std::make_pair("MPa", 1e6), std::make_pair("GPa", 1e9)})
        {
          const double other = speed * std::sqrt(factor);
          // Rocks have 1 to 8 km/s.
          if (other > 1000 && other < 8000)
            problem += std::string(" Is it in ") + unit + "? rift uses Pa.";
        }
      refuse(name, problem);
    }

    void
    check_isotropic(const MaterialParameters &material, const Refuse &refuse)
    {
      const double E = material.youngs_modulus, nu = material.poissons_ratio;
      if (!(E > 0))
        refuse("Young's modulus", "this must be greater than zero. Units: Pa.");
      if (!(nu > -1 && nu < 0.5))
        refuse("Poisson's ratio",
               "this must be greater than -1 and less than 0.5.");
      check_wave_speed(material,
                       E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)),
                       "Young's modulus",
                       refuse);
    }

    void
    check_axes(const MaterialParameters &material, const Refuse &refuse)
    {
      const double length_1 = norm(material.axis_1);
      const double length_2 = norm(material.axis_2);
      if (!(length_1 > 0))
        refuse("Axis 1", "an axis cannot be zero.");
      if (!(length_2 > 0))
        refuse("Axis 2", "an axis cannot be zero.");
      if (!(norm(cross(material.axis_1, material.axis_2)) >
            1e-6 * length_1 * length_2))
        refuse("Axis 2", "this is parallel to Axis 1.");
    }

    /** @param name the entry to blame. */
    void
    check_stiffness(const MaterialParameters &material,
                    const std::string        &name,
                    const Refuse             &refuse)
    {
      const Matrix6 kelvin =
        kelvin_matrix(stiffness_in_material_axes(material));
      double largest = 0;
      for (unsigned int i = 0; i < 6; ++i)
        largest = std::max(largest, std::abs(kelvin[i][i]));
      const double smallest = smallest_eigenvalue(kelvin);
      // Round-off alone can make a singular stiffness look positive.
      if (!(smallest > 1e-12 * largest))
        refuse(name,
               "the stiffness is not positive definite, its smallest "
               "eigenvalue is " +
                 short_text(smallest) + " Pa." +
                 (name == "Stiffness" ?
                    " Give the upper triangle row by row: 11, 12, 13, 14, "
                    "15, 16, 22, 23, ... with 4, 5, 6 for 23, 13, 12." :
                    " Look at all constants of this law."));
      for (unsigned int i = 0; i < 3; ++i)
        check_wave_speed(material, kelvin[i][i], name, refuse);
    }

    /** Entries that the law of a material uses, its own ones first. */
    std::vector<std::string>
    used_entries(const MaterialParameters &material)
    {
      std::vector<std::string> result;
      for_each_elastic_law([&](const auto &law) {
        if (material.elasticity != law.name)
          return;
        for (const ElasticConstant &constant : law.constants())
          result.push_back(constant.name);
        for (const std::string &entry : law.entries())
          result.push_back(entry);
      });
      return result;
    }

    bool
    uses(const MaterialParameters &material, const std::string &entry)
    {
      const auto entries = used_entries(material);
      return std::count(entries.begin(), entries.end(), entry) > 0;
    }

    /** The groups, and that they leave a stiffness. */
    void
    check_cracks(const MaterialParameters &material, const Refuse &refuse)
    {
      const char *const name = "Crack groups";
      if (material.crack_groups.empty())
        refuse(name, "a microcracked material needs a group of cracks.");
      if (material.crack_groups.size() > largest_number_of_crack_groups)
        refuse(name,
               "these are more than " +
                 std::to_string(largest_number_of_crack_groups) + " groups.");
      for (const CrackGroup &group : material.crack_groups)
        {
          if (!(group.density >= 0 && group.density <= largest_crack_density))
            refuse(name,
                   "a density is between 0 and " +
                     short_text(largest_crack_density) +
                     "; rocks have less than 1.");
          if (!group.normal)
            continue;
          const double length = norm(*group.normal);
          if (!(length > 1e-100 && length < 1e100))
            refuse(name, "a normal cannot be zero, nor have no end.");
        }
      const auto stiffness =
        stiffness_with_cracks(isotropic_stiffness(material),
                              material.crack_groups,
                              material.crack_scheme);
      if (!stiffness)
        refuse(name,
               "so many cracks leave no stiffness. Give smaller densities, or "
               "another Crack scheme.");
      for (unsigned int i = 0; i < 3; ++i)
        if (const double speed =
              std::sqrt((*stiffness)[i][i] / material.density);
            speed < slowest_wave)
          refuse(name,
                 "so many cracks leave P-waves of " + short_text(speed) +
                   " m/s; solids have 100 to 15000 m/s.");
    }

    /** Young's modulus, or the largest stiffness there is, Pa. */
    double
    typical_modulus(const MaterialParameters &material)
    {
      if (uses(material, "Young's modulus"))
        return material.youngs_modulus;
      double largest = 0;
      for (const auto &row : stiffness_in_material_axes(material))
        largest = std::max(largest, *std::max_element(row.begin(), row.end()));
      return largest;
    }

    /** Strengths of solids are 1e-5 to 1e-1 of their moduli. */
    void
    check_unit(const MaterialParameters &material,
               const DirectionalValue   &strength,
               const std::string        &name,
               const Refuse             &refuse)
    {
      const double modulus  = typical_modulus(material);
      const double smallest = strength.smallest();
      if (strength.largest() > modulus)
        refuse(name,
               "this is more than the modulus of elasticity, " +
                 short_text(modulus) +
                 " Pa; no rock, glass or metal is so strong. Is one of the two "
                 "in another "
                 "unit? rift uses Pa.");
      if (smallest > 0 && smallest < smallest_strength * modulus)
        refuse(name,
               "this is " + short_text(smallest / modulus) +
                 " of the modulus of elasticity; no rock, glass or metal is so "
                 "weak. Is it "
                 "in MPa? rift uses Pa: write " +
                 short_text(1e6 * smallest) + ".");
    }

    void
    check_strength(const MaterialParameters &material, const Refuse &refuse)
    {
      for (const auto &[name, value] :
           {std::make_pair("Viscosity", DirectionalValue(material.viscosity)),
            std::make_pair("Tensile strength", material.tensile_strength),
            std::make_pair("Cohesion", material.cohesion),
            std::make_pair("Fracture energy I", material.fracture_energy_1),
            std::make_pair("Fracture energy II", material.fracture_energy_2)})
        if (!(value.smallest() >= 0))
          refuse(name, "this cannot be negative.");
      check_unit(material,
                 material.tensile_strength,
                 "Tensile strength",
                 refuse);
      check_unit(material, material.cohesion, "Cohesion", refuse);
      if (!(material.friction_angle >= 0 &&
            material.friction_angle <= largest_friction_angle))
        refuse("Friction angle",
               "this must be between 0 and 80 degrees. Steeper friction is "
               "not covered by the bound of the time step.");
      const double residual =
        material.residual_friction_angle.value_or(material.friction_angle);
      if (!(residual >= 0 && residual <= material.friction_angle))
        refuse("Residual friction angle",
               "this must be between 0 and the friction angle.");
      const double m = material.weibull_modulus;
      if (!(m == 0 || m >= 1))
        refuse("Weibull modulus",
               "this must be 0, for no scatter, or at least 1. Rocks have 2 "
               "to 50.");
      const double length = material.correlation_length;
      if (!(length == 0 || length >= smallest_correlation_length))
        refuse("Correlation length",
               "this must be " + short_text(smallest_correlation_length) +
                 " m or more.");
    }
  } // namespace

  void
  MaterialParameters::check() const
  {
    const Refuse refuse{"Material " + name};
    check_density(*this, refuse);
    if (!(norm(initial_velocity) <= largest_velocity))
      refuse("Initial velocity",
             "this is more than " + short_text(largest_velocity) +
               " m/s. rift uses m/s.");
    for (unsigned int d = 0; d < 3; ++d)
      check_function(refuse.section,
                     std::string("Velocity ") + "xyz"[d],
                     velocity[d]);
    for (unsigned int d = 0; d < 3; ++d)
      if (!velocity[d].empty() && initial_velocity[d] != 0)
        refuse("Initial velocity",
               std::string("Velocity ") + "xyz"[d] +
                 " is prescribed from the start on. Set this component to 0.");
    if (is_rigid())
      return;
    if (uses(*this, "Young's modulus"))
      check_isotropic(*this, refuse);
    else
      check_stiffness(*this, used_entries(*this).front(), refuse);
    if (uses(*this, "Crack groups"))
      check_cracks(*this, refuse);
    if (uses(*this, "Axis 1") || has_directional_strength())
      check_axes(*this, refuse);
    check_strength(*this, refuse);
  }

  std::vector<std::string>
  MaterialParameters::warnings() const
  {
    std::vector<std::string> result;
    for (const auto &[entry, value] :
         {std::make_pair("Fracture energy I", fracture_energy_1),
          std::make_pair("Fracture energy II", fracture_energy_2)})
      if (value.smallest() > 0 && value.smallest() < smallest_fracture_energy)
        result.push_back("Material " + name + "/" + entry + " = " +
                         short_text(value.smallest()) +
                         " is less than rock, glass and metal have. Is it in "
                         "N/mm or kJ/m^2? rift uses J/m^2.");
    return result;
  }

  void
  MaterialParameters::check_breakable() const
  {
    if (!breakable)
      return;
    const Refuse refuse{"Material " + name};
    for (const auto &[entry, value] :
         {std::make_pair("Tensile strength", tensile_strength),
          std::make_pair("Cohesion", cohesion),
          std::make_pair("Fracture energy I", fracture_energy_1),
          std::make_pair("Fracture energy II", fracture_energy_2)})
      if (!(value.smallest() > 0))
        refuse(entry,
               "this must be greater than zero where cracks may run. Set it, "
               "or Breakable = false.");
  }
} // namespace rift
