#ifndef rift_material_material_parameters_h
#define rift_material_material_parameters_h

#include <rift/base/parameter_file.h>
#include <rift/base/vector3.h>
#include <rift/material/directional_value.h>
#include <rift/material/microcracks.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace rift
{
  /**
   * A material: subsection `Material NAME` of the .prm, where NAME is that of
   * a physical volume of the mesh.
   */
  struct MaterialParameters
  {
    /** Names of elastic laws that other parts of rift ask for; material/laws
     * has them all. */
    struct Elasticity
    {
      /** Value of the entry Elasticity. */
      static constexpr const char *isotropic    = "isotropic";
      static constexpr const char *anisotropic  = "anisotropic";
      static constexpr const char *microcracked = "microcracked";
      static constexpr const char *rigid        = "rigid";
    };

    /** Name of the material and of its physical volume. */
    std::string name;

    /** Mass density, kg/m^3. */
    double density = 0;

    /** Name of the elastic law. */
    std::string elasticity = Elasticity::isotropic;

    /** The entries that single elastic laws have of their own, by name. */
    std::map<std::string, double> elastic_constants;

    /** Isotropic, or intact: Young's modulus, Pa, and Poisson's ratio. */
    double youngs_modulus = 0;
    double poissons_ratio = 0;

    /**
     * Anisotropic: upper triangle, row by row, of the stiffness in Voigt's
     * order 11, 22, 33, 23, 13, 12, in material axes, Pa.
     */
    std::array<double, 21> stiffness{};

    /** Microcracks; normals in material axes. */
    std::vector<CrackGroup> crack_groups;
    CrackScheme             crack_scheme = CrackScheme::differential;

    /** Material axes 1 and 2 in the frame of the mesh; 3 is their product. */
    Vector3<double> axis_1 = {{1, 0, 0}};
    Vector3<double> axis_2 = {{0, 1, 0}};

    /** Viscosity eta of the stress eta d, Pa s. */
    double viscosity = 0;

    /** Velocity at the start, m/s. */
    Vector3<double> initial_velocity = {{0, 0, 0}};

    /** Rigid: functions of time that prescribe components of the velocity, m/s,
     * as texts; empty where bodies are free. */
    std::array<std::string, 3> velocity;

    /** Whether cohesive elements may be inserted inside this material. */
    bool breakable = true;

    /** Tensile strength and cohesion, Pa; friction angle, rad. */
    DirectionalValue tensile_strength = 0;
    DirectionalValue cohesion         = 0;
    double           friction_angle   = 0;

    /** Of a face that has lost its strength, rad; without it the friction angle
     * stays. */
    std::optional<double> residual_friction_angle;

    /** Fracture energies of modes I and II, J/m^2. */
    DirectionalValue fracture_energy_1 = 0;
    DirectionalValue fracture_energy_2 = 0;

    /** Weibull modulus of the scatter of both strengths; 0: no scatter. */
    double weibull_modulus = 0;

    /** Of the StrengthField, with the law of bonds, m. */
    double correlation_length = 0;

    /** Declares the entries of subsection `Material NAME`. */
    static void
    declare(dealii::ParameterHandler &prm, const std::string &name);

    /** Reads subsection `Material NAME`; degrees become rad. */
    static MaterialParameters
    parse(dealii::ParameterHandler &prm,
          const std::string        &name,
          const ParameterFile      &scene);

    /** Whether its cells are rigid bodies. */
    bool
    is_rigid() const
    {
      return elasticity == Elasticity::rigid;
    }

    /** Whether a strength or fracture energy depends on the direction. */
    bool
    has_directional_strength() const
    {
      return !(tensile_strength.is_isotropic() && cohesion.is_isotropic() &&
               fracture_energy_1.is_isotropic() &&
               fracture_energy_2.is_isotropic());
    }

    /**
     * Throws ParameterError for a density outside 500..25000 kg/m^3, a P-wave
     * speed outside 100..15000 m/s (both mostly a wrong unit), moduli that
     * store negative energy, parallel axes, a negative viscosity, negative
     * strengths or fracture energies, strengths that are not zero and outside
     * 1e-7..1 of the modulus of elasticity, a friction angle outside [0, 80]
     * degrees, a residual one outside [0, friction angle], a Weibull modulus
     * between 0 and 1, a negative or tiny correlation length, and a table that
     * does not exist.
     */
    void
    check() const;

    /** Sentences about values that may be in a wrong unit, for warnings. */
    std::vector<std::string>
    warnings() const;

    /**
     * Throws ParameterError if the material may break and one of its strengths
     * or fracture energies is zero.
     */
    void
    check_breakable() const;

    /** What its elasticity and being unbreakable leave without effect. */
    std::vector<InertEntries>
    inert_entries() const;
  };

  /** Whether the strengths of a material scatter. */
  inline bool
  any_scatters(const std::vector<MaterialParameters> &materials)
  {
    return std::any_of(materials.begin(),
                       materials.end(),
                       [](const MaterialParameters &material) {
                         return material.weibull_modulus > 0;
                       });
  }

  /** The density of each material. */
  inline std::vector<double>
  densities_of(const std::vector<MaterialParameters> &materials)
  {
    std::vector<double> densities;
    for (const MaterialParameters &material : materials)
      densities.push_back(material.density);
    return densities;
  }
} // namespace rift

#endif
