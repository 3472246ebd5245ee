#include <rift/app/elasticity_tool.h>
#include <rift/app/parameters.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/parameter_text.h>
#include <rift/material/crack_fit.h>
#include <rift/material/wave_speeds.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <ostream>

namespace rift
{
  namespace
  {
    struct Options
    {
      std::string              scene, material, stiffness, speeds;
      std::vector<std::string> overrides, directions;
      std::string              help;
    };

    /** A wave that has been measured. */
    struct MeasuredSpeed
    {
      Vector3<double> direction;

      /** 0: P, 1 and 2: the faster and the slower S. */
      unsigned int wave;
      double       speed;
    };

    Options
    parse_options(const int argc, const char *const *argv)
    {
      Options  result;
      CLI::App app(
        "rift-elasticity: stiffness and wave speeds of the materials "
        "of a scene, and fits of microcracks to measured ones. All "
        "in material axes.",
        "rift-elasticity");
      app.add_option("scene", result.scene, "The scene, a .prm file")
        ->required();
      app.add_option("material",
                     result.material,
                     "One of its materials; without it: all");
      app
        .add_option("--set",
                    result.overrides,
                    "Set an entry of the scene; may be given several times")
        ->type_name("\"Section/Name=value\"")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
      app
        .add_option("--direction",
                    result.directions,
                    "Print the speeds in this direction, too; may be given "
                    "several times")
        ->type_name("\"X Y Z\"")
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
      auto *const stiffness =
        app
          .add_option("--fit-stiffness",
                      result.stiffness,
                      "Fit the crack densities of the material to a stiffness, "
                      "21 numbers as in the entry Stiffness of a scene, Pa")
          ->type_name("\"C11, C12, ...\"");
      app
        .add_option("--fit-speeds",
                    result.speeds,
                    "Fit them to wave speeds: a table with the columns x, y, "
                    "z, wave (P, S1, S2), speed [m/s]")
        ->type_name("FILE.csv")
        ->excludes(stiffness);
      try
        {
          app.parse(argc, argv);
        }
      catch (const CLI::CallForHelp &)
        {
          result.help = app.help();
        }
      catch (const CLI::ParseError &error)
        {
          throw InputError(std::string("command line: ") + error.what() +
                           ". Run \"rift-elasticity --help\" for what there "
                           "is.");
        }
      return result;
    }

    Vector3<double>
    read_direction(const std::string &text)
    {
      // As on the command line, or as in a scene.
      std::string blanks = text;
      std::replace(blanks.begin(), blanks.end(), ',', ' ');
      const auto      words = split(simplified(blanks), ' ');
      Vector3<double> result{};
      bool            is_good = words.size() == 3;
      for (unsigned int d = 0; d < 3 && is_good; ++d)
        is_good = from_text(words[d], result[d]);
      if (!is_good || !(norm(result) > 0))
        throw InputError("command line: the direction \"" + text +
                         "\" is not of the form \"1 1 0\".");
      return result;
    }

    /** The upper triangle of a stiffness, row by row, Pa. */
    std::vector<double>
    upper_triangle(const StiffnessMatrix &stiffness)
    {
      std::vector<double> result;
      for (unsigned int i = 0; i < 6; ++i)
        for (unsigned int j = i; j < 6; ++j)
          result.push_back(stiffness[i][j]);
      return result;
    }

    std::vector<double>
    read_stiffness(const std::string &text)
    {
      std::vector<double> result;
      bool                is_good = true;
      for (const std::string &word : split(text, ','))
        {
          double number = 0;
          is_good       = is_good && from_text(word, number);
          result.push_back(number);
        }
      if (!is_good || result.size() != 21)
        throw InputError("command line: a stiffness has 21 numbers with commas "
                         "between them, 11, 12, ..., 66; there are " +
                         std::to_string(result.size()) + ".");
      return result;
    }

    std::vector<MeasuredSpeed>
    read_speeds(const std::string &path)
    {
      const std::array<std::string, 3> waves = {{"P", "S1", "S2"}};
      errno                                  = 0;
      std::ifstream file(path);
      if (!file)
        throw InputError("cannot read the table " + path + ": " +
                         std::strerror(errno) + ".");
      std::vector<MeasuredSpeed> result;
      std::string                text;
      bool                       has_header = false;
      for (unsigned int line = 1; std::getline(file, text); ++line)
        {
          text = simplified(text.substr(0, text.find('#')));
          if (text.empty())
            continue;
          if (!has_header)
            {
              if (text.find("[m/s]") == std::string::npos)
                throw InputError(path + ":" + std::to_string(line) +
                                 ": found \"" + text +
                                 "\" instead of a header; the first line is "
                                 "\"x, y, z, wave, speed [m/s]\".");
              has_header = true;
              continue;
            }
          const auto    cells = split(text, ',');
          MeasuredSpeed row{};
          bool          is_good = cells.size() == 5;
          for (unsigned int d = 0; d < 3 && is_good; ++d)
            is_good = from_text(cells[d], row.direction[d]);
          const auto wave = is_good ?
                              std::find(waves.begin(), waves.end(), cells[3]) :
                              waves.end();
          row.wave        = static_cast<unsigned int>(wave - waves.begin());
          if (wave == waves.end() || !from_text(cells[4], row.speed) ||
              !(norm(row.direction) > 0) || !(row.speed > 0))
            throw InputError(path + ":" + std::to_string(line) + ": found \"" +
                             text +
                             "\"; a row is a direction, P, S1 or S2, and a "
                             "speed, as in \"0, 0, 1, P, 3670\".");
          result.push_back(row);
        }
      return result;
    }

    std::string
    groups_text(const std::vector<CrackGroup> &groups)
    {
      std::string text;
      for (const CrackGroup &group : groups)
        {
          text += text.empty() ? "" : ", ";
          if (group.normal)
            for (unsigned int d = 0; d < 3; ++d)
              text += (d > 0 ? " " : "") + to_text((*group.normal)[d]);
          else
            text += "random";
          text += ": " + fmt::format("{:.4f}", group.density);
        }
      return text;
    }

    void
    print(const MaterialParameters           &material,
          const std::vector<Vector3<double>> &directions,
          std::ostream                       &out)
    {
      const StiffnessMatrix c = stiffness_in_material_axes(material);
      fmt::print(out,
                 "{}\n  stiffness, GPa (11 22 33 23 13 12)\n",
                 material.name);
      for (const auto &row : c)
        {
          fmt::print(out, "   ");
          for (const double value : row)
            // No minus sign before a zero that rounding has left.
            fmt::print(out,
                       " {:9.3f}",
                       std::abs(value) < 5e5 ? 0 : value / 1e9);
          fmt::print(out, "\n");
        }
      fmt::print(out,
                 "  wave speeds at {} kg/m^3, m/s\n"
                 "    {:<24}{:>9}{:>9}{:>9}\n",
                 to_text(material.density),
                 "direction",
                 "P",
                 "S1",
                 "S2");
      for (const Vector3<double> &n : directions)
        {
          const auto speeds = wave_speeds(c, material.density, n);
          fmt::print(out,
                     "    {:<24}{:9.1f}{:9.1f}{:9.1f}\n",
                     to_text(n[0]) + " " + to_text(n[1]) + " " + to_text(n[2]),
                     speeds[0],
                     speeds[1],
                     speeds[2]);
        }
    }

    /** What a fit is to come near to. */
    struct FitTarget
    {
      /** Computed less measured, by a stiffness, Pa. */
      std::function<std::vector<double>(const StiffnessMatrix &)> residuals;

      /** What each of them is of. */
      std::vector<std::string> names;

      /** In which they are printed. */
      double      unit;
      std::string unit_name;
    };

    FitTarget
    stiffness_target(const std::string &text)
    {
      FitTarget result{
        [target = read_stiffness(text)](const StiffnessMatrix &stiffness) {
          std::vector<double> residuals = upper_triangle(stiffness);
          for (std::size_t i = 0; i < residuals.size(); ++i)
            residuals[i] -= target[i];
          return residuals;
        },
        {},
        1e9,
        "GPa"};
      for (unsigned int i = 1; i <= 6; ++i)
        for (unsigned int j = i; j <= 6; ++j)
          result.names.push_back("C" + std::to_string(i) + std::to_string(j));
      return result;
    }

    FitTarget
    speed_target(const std::string &file, const double density)
    {
      const auto measured = read_speeds(file);
      FitTarget  result{
        [measured, density](const StiffnessMatrix &stiffness) {
          std::vector<double> residuals;
          for (const MeasuredSpeed &m : measured)
            residuals.push_back(
              wave_speeds(stiffness, density, m.direction)[m.wave] - m.speed);
          return residuals;
        },
        {},
        1,
        "m/s"};
      for (const MeasuredSpeed &m : measured)
        result.names.push_back(
          (m.wave == 0 ? "P" :
           m.wave == 1 ? "S1" :
                         "S2") +
          std::string(" along ") + to_text(m.direction[0]) + " " +
          to_text(m.direction[1]) + " " + to_text(m.direction[2]));
      return result;
    }

    void
    print(const CrackFit    &fitted,
          const FitTarget   &target,
          const std::string &material,
          std::ostream      &out)
    {
      fmt::print(out,
                 "fit of {}\n  set Crack groups = {}\n"
                 "  computed less measured, {}; root mean square {:.3f}\n",
                 material,
                 groups_text(fitted.groups),
                 target.unit_name,
                 fitted.mean_residual() / target.unit);
      constexpr double smallest_density = 1e-4;
      if (std::any_of(fitted.groups.begin(),
                      fitted.groups.end(),
                      [](const CrackGroup &group) {
                        return group.density < smallest_density;
                      }))
        fmt::print(out,
                   "  WARNING: densities are at their limit, zero: what "
                   "was measured is stiffer than these cracks allow\n");
      for (std::size_t i = 0; i < target.names.size(); ++i)
        if (std::abs(fitted.residuals[i]) > 5e-4 * target.unit)
          fmt::print(out,
                     "    {:<24}{:9.3f}\n",
                     target.names[i],
                     fitted.residuals[i] / target.unit);
    }

    /** The material with fitted densities. */
    MaterialParameters
    fit(MaterialParameters material, const Options &options, std::ostream &out)
    {
      if (material.elasticity != MaterialParameters::Elasticity::microcracked)
        throw InputError("the material \"" + material.name +
                         "\" is not microcracked; only crack densities can be "
                         "fitted.");
      const FitTarget target =
        options.stiffness.empty() ?
          speed_target(options.speeds, material.density) :
          stiffness_target(options.stiffness);
      const CrackFit fitted = fit_cracks(isotropic_stiffness(material),
                                         material.crack_groups,
                                         material.crack_scheme,
                                         target.residuals);
      print(fitted, target, material.name, out);
      material.crack_groups = fitted.groups;
      return material;
    }
  } // namespace

  void
  run_elasticity_tool(const int          argc,
                      const char *const *argv,
                      std::ostream      &out)
  {
    const Options options = parse_options(argc, argv);
    if (!options.help.empty())
      {
        out << options.help;
        return;
      }
    const Parameters scene = read_parameters(options.scene, options.overrides);
    std::vector<Vector3<double>> directions = {{{1, 0, 0}},
                                               {{0, 1, 0}},
                                               {{0, 0, 1}}};
    for (const std::string &text : options.directions)
      directions.push_back(read_direction(text));
    const bool fits = !options.stiffness.empty() || !options.speeds.empty();

    std::vector<std::string> names;
    for (const MaterialParameters &material : scene.materials)
      {
        if (material.is_rigid())
          continue;
        names.push_back(material.name);
        if (!options.material.empty() && options.material != material.name)
          continue;
        if (fits && options.material.empty())
          throw InputError("command line: say which material is to be fitted, "
                           "after the scene.");
        print(fits ? fit(material, options, out) : material, directions, out);
      }
    if (!options.material.empty() &&
        std::find(names.begin(), names.end(), options.material) == names.end())
      throw InputError("command line: there is no elastic material \"" +
                       options.material + "\" in the scene." +
                       suggestion(options.material, names));
  }
} // namespace rift
