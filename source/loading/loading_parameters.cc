#include <deal.II/base/parameter_handler.h>

#include <rift/base/parameter_declarations.h>
#include <rift/base/parameter_text.h>
#include <rift/loading/loading_parameters.h>

namespace rift
{
  namespace
  {
    const std::array<std::string, 3> axes = {{"x", "y", "z"}};

    std::string
    section_of(const std::string &name)
    {
      return "Boundary " + name;
    }
  } // namespace

  void
  BoundaryParameters::declare(dealii::ParameterHandler &prm,
                              const std::string        &name)
  {
    const dealii::Patterns::Anything function;
    prm.enter_subsection(section_of(name));
    prm.declare_entry("Pressure",
                      "",
                      function,
                      "Function of time: pressure normal to the deformed "
                      "surface, positive in compression. Units: Pa.");
    for (const std::string &axis : axes)
      prm.declare_entry("Traction " + axis,
                        "",
                        function,
                        "Function of time: force along " + axis +
                          " per area of the undeformed surface. Units: Pa.");
    for (const std::string &axis : axes)
      prm.declare_entry("Velocity " + axis,
                        "",
                        function,
                        "Function of time: prescribed velocity along " + axis +
                          "; 0 holds the surface. Units: m/s.");
    prm.declare_entry("Acts while in place",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether pressure and traction end on a face when its "
                      "piece of the body has come off and left its place: when "
                      "it has moved, compared with the largest piece, by more "
                      "than the edge of a cube of its volume. Found every 20 "
                      "steps.");
    prm.declare_entry("Absorbing",
                      "false",
                      dealii::Patterns::Bool(),
                      "Whether waves that arrive here leave, as if the body "
                      "went on behind the surface. All of a wave across the "
                      "surface goes, of one at a slant the most.");
    prm.leave_subsection();
  }

  BoundaryParameters
  BoundaryParameters::parse(dealii::ParameterHandler &prm,
                            const std::string        &name,
                            const ParameterFile      &scene)
  {
    const std::string  section = section_of(name);
    BoundaryParameters result;
    result.name = name;
    prm.enter_subsection(section);
    result.pressure = get_function(prm, section, "Pressure", scene);
    for (unsigned int d = 0; d < 3; ++d)
      {
        result.traction[d] =
          get_function(prm, section, "Traction " + axes[d], scene);
        result.velocity[d] =
          get_function(prm, section, "Velocity " + axes[d], scene);
      }
    result.acts_while_in_place = prm.get_bool("Acts while in place");
    result.absorbs             = prm.get_bool("Absorbing");
    prm.leave_subsection();
    return result;
  }

  void
  BoundaryParameters::check() const
  {
    const std::string section = section_of(name);
    bool              is_free = pressure.empty() && !absorbs;
    check_function(section, "Pressure", pressure);
    for (unsigned int d = 0; d < 3; ++d)
      {
        check_function(section, "Traction " + axes[d], traction[d]);
        check_function(section, "Velocity " + axes[d], velocity[d]);
        if (absorbs && !velocity[d].empty())
          throw ParameterError(section,
                               "Absorbing",
                               "Velocity " + axes[d] +
                                 " is set too, but what is prescribed cannot "
                                 "give way to waves. Remove one of the two.");
        is_free = is_free && traction[d].empty() && velocity[d].empty();
        if (!traction[d].empty() && !velocity[d].empty())
          throw ParameterError(section,
                               "Velocity " + axes[d],
                               "Traction " + axes[d] +
                                 " is set too, but a component has either a "
                                 "traction or a velocity. Remove one of the "
                                 "two.");
      }
    if (!pressure.empty() && !velocity[0].empty() && !velocity[1].empty() &&
        !velocity[2].empty())
      throw ParameterError(section,
                           "Pressure",
                           "all three velocities are set too, so that it moves "
                           "nothing. Remove it, or one of them.");
    if (is_free)
      throw ParameterError(section,
                           "Pressure",
                           "nor is any other condition of this boundary. Set "
                           "one, or remove the subsection: without it the "
                           "surface is free.");
  }

  std::vector<InertEntries>
  BoundaryParameters::inert_entries() const
  {
    const std::string section = section_of(name);
    InertEntries      result{section,
                        {"Acts while in place"},
                        {{section, "Pressure"}},
                        "without a pressure or a traction"};
    bool              is_loaded = !pressure.empty();
    for (unsigned int d = 0; d < 3; ++d)
      {
        is_loaded = is_loaded || !traction[d].empty();
        result.causes.emplace_back(section, "Traction " + axes[d]);
      }
    if (is_loaded)
      return {};
    return {result};
  }
} // namespace rift
