#include <rift/app/fragment_watch.h>
#include <rift/base/exceptions.h>
#include <rift/base/number_text.h>
#include <rift/base/vector_text.h>
#include <rift/contact/interpenetration.h>
#include <rift/material/wave_speeds.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    double
    speed_limit_of(const Body &body)
    {
      double fastest_wave = 0, fastest_start = 0;
      for (std::size_t m = 0; m < body.materials.size(); ++m)
        {
          fastest_start =
            std::max(fastest_start, norm(body.materials[m].initial_velocity));
          if (body.materials[m].is_rigid())
            continue;
          for (unsigned int d = 0; d < dim; ++d)
            {
              Vector3<double> axis{};
              axis[d] = 1;
              fastest_wave =
                std::max(fastest_wave,
                         wave_speeds(body.stiffnesses[m],
                                     body.discretization.densities[m],
                                     axis)[0]);
            }
        }
      return .1 * fastest_wave + 2 * fastest_start;
    }

    std::string
    percent_text(const double part)
    {
      return short_text(100 * part) + " %";
    }
  } // namespace

  FragmentWatch::FragmentWatch(const Body &body, const bool has_contact)
    : body(body)
    , has_contact(has_contact)
    , speed_limit(speed_limit_of(body))
  {
  }

  std::vector<std::string>
  FragmentWatch::warnings_at_start() const
  {
    if (has_contact)
      return {};
    const Discretization &d = body.discretization;
    const auto            n_bodies =
      find_fragments(d.topology,
                     d.reference,
                     d.densities,
                     d.state,
                     std::vector<Vector3<double>>(d.state.n_nodes()),
                     d.communicator)
        .list.size();
    if (n_bodies == 1)
      return {};
    return {"the mesh has " + std::to_string(n_bodies) +
            " separate bodies, and nothing keeps them apart. Set \"Contact = "
            "true\" in subsection Contact if they are to touch."};
  }

  std::vector<std::string>
  FragmentWatch::look(const Fragments &fragments)
  {
    std::vector<std::string> result;
    const auto add = [&result](const std::string &warning, bool &has_warned) {
      if (warning.empty())
        return;
      result.push_back(warning);
      has_warned = true;
    };
    if (!has_warned_of_speed)
      add(warning_of_speed(fragments), has_warned_of_speed);
    if (!has_warned_of_interpenetration && !has_contact)
      add(warning_of_interpenetration(), has_warned_of_interpenetration);
    return result;
  }

  std::string
  FragmentWatch::warning_of_speed(const Fragments &fragments) const
  {
    // Whole bodies may have been given any speed.
    const auto                &list = fragments.list;
    std::vector<std::uint32_t> n_pieces(list.size(), 0);
    for (const Fragment &fragment : list)
      ++n_pieces[fragment.main_piece];

    std::size_t n_fragments = 0, n_fast = 0;
    double      mass = 0, fast_mass = 0, largest = 0;
    std::size_t fastest = 0;
    for (std::size_t i = 0; i < list.size(); ++i)
      {
        mass += list[i].mass;
        if (n_pieces[list[i].main_piece] == 1)
          continue;
        ++n_fragments;
        const double speed = norm(list[i].velocity);
        if (speed > largest)
          {
            largest = speed;
            fastest = i;
          }
        if (speed > speed_limit)
          {
            ++n_fast;
            fast_mass += list[i].mass;
          }
      }
    if (n_fast == 0)
      return {};
    return "the fastest fragment moves with " + short_text(largest) +
           " m/s at " + place_text(list[fastest].centre) + "; " +
           std::to_string(n_fast) + " of " + std::to_string(n_fragments) +
           " fragments, " + percent_text(fast_mass / mass) +
           " of the mass, are faster than " + short_text(speed_limit) +
           " m/s, a tenth of the speed of P-waves plus twice the largest "
           "speed at the start. Look for a load that goes on acting on what "
           "has come off (\"Acts "
           "while attached\" of Boundary), and for pieces that pass through "
           "each other (subsection Contact).";
  }

  std::string
  FragmentWatch::warning_of_interpenetration() const
  {
    const Discretization &d = body.discretization;
    Interpenetration      found;
    try
      {
        found = find_interpenetration(d.topology, d.state, d.communicator);
      }
    catch (const Error &error)
      {
        if (error.exit_code != ExitCode::run_error)
          throw;
        return "pieces lie in each other in heaps, since nothing keeps them "
               "apart. Set \"Contact = true\" in subsection Contact.";
      }
    if (found.n_pairs == 0)
      return {};
    return "pieces pass through each other, since nothing keeps them apart: " +
           std::to_string(found.n_pairs) +
           (found.n_pairs == 1 ? " pair" : " pairs") +
           " of cells have more than 10 % of the smaller one's volume in "
           "common, up to " +
           percent_text(found.largest_part) + " at " + place_text(found.place) +
           ". Set \"Contact = true\" in subsection Contact.";
  }
} // namespace rift
