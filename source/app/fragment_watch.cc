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
    largest_speed_of(const Body &body)
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

  FragmentWatch::FragmentWatch(const Body &body,
                               const bool  has_contact,
                               const bool  loads_follow)
    : body(body)
    , has_contact(has_contact)
    , loads_follow(loads_follow)
    , largest_speed(largest_speed_of(body))
  {
  }

  std::vector<Warning>
  FragmentWatch::warnings_at_start() const
  {
    if (has_contact)
      return {};
    const std::int64_t n_bodies = count_bodies(body.discretization);
    if (n_bodies == 1)
      return {};
    return {{"the mesh has " + std::to_string(n_bodies) + " separate bodies",
             ", and nothing keeps them apart. Remove \"Contact = false\" "
             "from subsection Contact if they are to touch."}};
  }

  std::vector<Warning>
  FragmentWatch::look(const Fragments &fragments) const
  {
    std::vector<Warning> result = warnings_of_speed(fragments);
    if (!has_contact)
      for (Warning &warning : warnings_of_overlap())
        result.push_back(std::move(warning));
    return result;
  }

  std::vector<Warning>
  FragmentWatch::warnings_of_speed(const Fragments &fragments) const
  {
    // Bodies that are whole may have been given any speed.
    const auto                &list = fragments.list;
    std::vector<std::uint32_t> n_pieces(list.size(), 0);
    for (const Fragment &fragment : list)
      ++n_pieces[fragment.main_piece];

    const Fragment *fastest     = nullptr;
    std::size_t     n_fragments = 0, n_fast = 0;
    double          mass = 0, fast_mass = 0;
    for (const Fragment &fragment : list)
      {
        mass += fragment.mass;
        if (n_pieces[fragment.main_piece] == 1)
          continue;
        ++n_fragments;
        const double speed = norm(fragment.velocity);
        if (!(speed > largest_speed))
          continue;
        ++n_fast;
        fast_mass += fragment.mass;
        if (fastest == nullptr || speed > norm(fastest->velocity))
          fastest = &fragment;
      }
    if (fastest == nullptr)
      return {};
    return {
      {"the fastest fragment",
       " moves with " + short_text(norm(fastest->velocity)) + " m/s at " +
         place_text(fastest->centre) + "; " + std::to_string(n_fast) + " of " +
         std::to_string(n_fragments) + " fragments, " +
         percent_text(fast_mass / mass) + " of the mass, are faster than " +
         short_text(largest_speed) +
         " m/s, a tenth of the speed of P-waves plus twice the largest initial "
         "speed" +
         (loads_follow ? "" :
                         ". Look for a load that acts on what has come off "
                         "(\"Acts while in place\" of Boundary)") +
         (has_contact ? "." :
                        ". Look for pieces that pass through each other "
                        "(subsection Contact).")}};
  }

  std::vector<Warning>
  FragmentWatch::warnings_of_overlap() const
  {
    const std::string     advice  = ". Set \"Contact = true\" in subsection "
                                    "Contact.";
    const std::string     subject = "pieces overlap, since nothing keeps them "
                                    "apart";
    const Discretization &d       = body.discretization;
    Interpenetration      found;
    try
      {
        found = find_interpenetration(d.topology, d.state, d.communicator);
      }
    catch (const Error &error)
      {
        if (error.exit_code != ExitCode::run_error)
          throw;
        return {{subject, ": so many that they cannot be counted" + advice}};
      }
    if (found.n_pairs == 0)
      return {};
    return {{subject,
             ": " + std::to_string(found.n_pairs) +
               (found.n_pairs == 1 ? " pair" : " pairs") +
               " of cells have more than " +
               percent_text(Interpenetration::tolerated_part) +
               " of the smaller one's volume in common, up to " +
               percent_text(found.largest_part) + " at " +
               place_text(found.place) + advice}};
  }
} // namespace rift
