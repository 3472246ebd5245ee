#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/material/material_parameters.h>

#include <cmath>

namespace rift
{
  namespace
  {
    using dealii::ParameterHandler;
    namespace Patterns = dealii::Patterns;

    std::string
    section_of(const std::string &name)
    {
      return "Material " + name;
    }

    void
    declare_elasticity(ParameterHandler &prm)
    {
      const MaterialParameters defaults;
      prm.declare_entry("Elasticity",
                        "isotropic",
                        Patterns::Selection("isotropic|anisotropic|rigid"),
                        "Isotropic with two constants, anisotropic with 21, or "
                        "rigid: does not deform and acts on others by contact "
                        "alone.");
      declare_number(prm,
                     "Young's modulus",
                     defaults.youngs_modulus,
                     "Young's modulus of an isotropic material. Must be set. "
                     "Units: Pa.");
      declare_number(prm,
                     "Poisson's ratio",
                     defaults.poissons_ratio,
                     "Poisson's ratio of an isotropic material. Units: 1.");
      std::string zeros = "0";
      for (unsigned int i = 1; i < 21; ++i)
        zeros += ", 0";
      prm.declare_entry("Stiffness",
                        zeros,
                        Patterns::List(Patterns::Double(), 21, 21),
                        "Upper triangle, row by row, of the stiffness of an "
                        "anisotropic material in Voigt's order 11, 22, 33, "
                        "23, 13, 12, in the material axes. Units: Pa.");
      declare_vector(prm,
                     "Axis 1",
                     defaults.axis_1,
                     "Material axis 1 in the coordinates of the mesh, of any "
                     "length. Units: 1.");
      declare_vector(prm,
                     "Axis 2",
                     defaults.axis_2,
                     "Material axis 2; what it has along axis 1 is taken "
                     "away. Axis 3 is their vector product. Units: 1.");
    }

    void
    declare_strength(ParameterHandler &prm)
    {
      const MaterialParameters defaults;
      prm.declare_entry("Breakable",
                        "true",
                        Patterns::Bool(),
                        "Whether cracks may run inside this material.");
      declare_number(prm,
                     "Tensile strength",
                     defaults.tensile_strength,
                     "A crack starts at this normal stress. Units: Pa.");
      declare_number(prm,
                     "Cohesion",
                     defaults.cohesion,
                     "A crack starts at this shear stress, where there is no "
                     "normal stress. Units: Pa.");
      declare_number(prm,
                     "Friction angle",
                     defaults.friction_angle,
                     "Angle of internal friction: its tangent times the "
                     "compressive stress adds to the cohesion. Units: "
                     "degrees.");
      declare_number(prm,
                     "Fracture energy I",
                     defaults.fracture_energy_1,
                     "Energy per area of crack, of opening. Units: J/m^2.");
      declare_number(prm,
                     "Fracture energy II",
                     defaults.fracture_energy_2,
                     "Energy per area of crack, of sliding. Units: J/m^2.");
      declare_number(prm,
                     "Weibull modulus",
                     defaults.weibull_modulus,
                     "Modulus of the scatter of tensile strength and cohesion "
                     "from face to face; the larger, the less scatter. 0: no "
                     "scatter. Units: 1.");
    }
  } // namespace

  void
  MaterialParameters::declare(ParameterHandler &prm, const std::string &name)
  {
    const MaterialParameters defaults;
    prm.enter_subsection(section_of(name));
    declare_number(prm,
                   "Density",
                   defaults.density,
                   "Mass density. Must be set. Units: kg/m^3.");
    declare_elasticity(prm);
    declare_number(prm,
                   "Viscosity",
                   defaults.viscosity,
                   "Factor of the rate of deformation in the viscous stress; "
                   "0: no damping. Units: Pa s.");
    declare_vector(prm,
                   "Initial velocity",
                   defaults.initial_velocity,
                   "Velocity at the start along x, y, z. Units: m/s.");
    for (const std::string axis : {"x", "y", "z"})
      prm.declare_entry("Velocity " + axis,
                        "",
                        Patterns::Anything(),
                        "Rigid material: function of time, the velocity of its "
                        "bodies along " +
                          axis +
                          ", which then do not turn. Without it they are free "
                          "along " +
                          axis + ". Units: m/s.");
    declare_strength(prm);
    prm.leave_subsection();
  }

  MaterialParameters
  MaterialParameters::parse(ParameterHandler    &prm,
                            const std::string   &name,
                            const ParameterFile &scene)
  {
    MaterialParameters result;
    result.name = name;
    prm.enter_subsection(section_of(name));
    result.density        = prm.get_double("Density");
    const std::string law = prm.get("Elasticity");
    result.elasticity     = law == "rigid"       ? Elasticity::rigid :
                            law == "anisotropic" ? Elasticity::anisotropic :
                                                   Elasticity::isotropic;
    result.youngs_modulus = prm.get_double("Young's modulus");
    result.poissons_ratio = prm.get_double("Poisson's ratio");
    const auto stiffness  = get_numbers(prm, "Stiffness");
    for (unsigned int i = 0; i < result.stiffness.size(); ++i)
      result.stiffness[i] = stiffness.at(i);
    result.axis_1           = get_vector(prm, "Axis 1");
    result.axis_2           = get_vector(prm, "Axis 2");
    result.viscosity        = prm.get_double("Viscosity");
    result.initial_velocity = get_vector(prm, "Initial velocity");
    result.breakable        = prm.get_bool("Breakable") && !result.is_rigid();
    for (unsigned int d = 0; d < 3; ++d)
      result.velocity[d] = get_function(prm,
                                        section_of(name),
                                        std::string("Velocity ") + "xyz"[d],
                                        scene);
    result.tensile_strength  = prm.get_double("Tensile strength");
    result.cohesion          = prm.get_double("Cohesion");
    result.friction_angle    = prm.get_double("Friction angle") * M_PI / 180;
    result.fracture_energy_1 = prm.get_double("Fracture energy I");
    result.fracture_energy_2 = prm.get_double("Fracture energy II");
    result.weibull_modulus   = prm.get_double("Weibull modulus");
    prm.leave_subsection();
    return result;
  }

  std::vector<InertEntries>
  MaterialParameters::inert_entries() const
  {
    const std::string         section = section_of(name);
    std::vector<InertEntries> result;
    const auto                add = [&](const std::vector<std::string> &names,
                         const std::string              &cause,
                         const std::string              &reason) {
      result.push_back({section, names, {{section, cause}}, reason});
    };
    const std::vector<std::string> isotropic   = {"Young's modulus",
                                                  "Poisson's ratio"};
    const std::vector<std::string> anisotropic = {"Stiffness",
                                                  "Axis 1",
                                                  "Axis 2"};
    const std::vector<std::string> strength    = {"Tensile strength",
                                                  "Cohesion",
                                                  "Friction angle",
                                                  "Fracture energy I",
                                                  "Fracture energy II",
                                                  "Weibull modulus"};
    std::string                    reason      = "on an isotropic material";
    if (elasticity == Elasticity::anisotropic)
      reason = "on an anisotropic material";
    if (is_rigid())
      reason = "on a rigid material";
    if (elasticity != Elasticity::isotropic)
      add(isotropic, "Elasticity", reason);
    if (elasticity != Elasticity::anisotropic)
      add(anisotropic, "Elasticity", reason);
    if (is_rigid())
      {
        add(strength, "Elasticity", reason);
        add({"Viscosity", "Breakable"}, "Elasticity", reason);
        if (!velocity[0].empty() && !velocity[1].empty() &&
            !velocity[2].empty())
          add({"Initial velocity"},
              "Velocity x",
              "where all velocities are prescribed");
      }
    else
      add({"Velocity x", "Velocity y", "Velocity z"},
          "Elasticity",
          "on a material that is not rigid");
    if (!breakable && !is_rigid())
      add(strength, "Breakable", "on an unbreakable material");
    return result;
  }
} // namespace rift
