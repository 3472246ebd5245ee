#include <rift/base/check.h>
#include <rift/loading/effect_check.h>
#include <rift/loading/surface_load.h>

#include <algorithm>
#include <set>

namespace rift
{
  namespace
  {
    std::optional<TimeFunction>
    make_function(const std::string &text,
                  const std::string &boundary,
                  const std::string &entry,
                  const std::string &unit)
    {
      if (text.empty())
        return {};
      return TimeFunction(text, "Boundary " + boundary + " / " + entry, unit);
    }

    Vector3<double>
    area_vector(const std::array<Vector3<double>, 3> &x)
    {
      return .5 * cross(x[1] - x[0], x[2] - x[0]);
    }
  } // namespace

  SurfaceLoad::SurfaceLoad(const Topology           &topology,
                           Surface                   surface,
                           const BoundaryParameters &parameters)
    : ModuleWithWork(topology, "load on " + parameters.name, "loads")
    , topology(topology)
    , boundary(parameters.name)
    , surface(std::move(surface))
    , acts_while_in_place(parameters.acts_while_in_place)
    , pressure(
        make_function(parameters.pressure, parameters.name, "Pressure", "Pa"))
    , bears_load(this->surface.size(), 1)
  {
    for (unsigned int d = 0; d < dim; ++d)
      traction[d] = make_function(parameters.traction[d],
                                  parameters.name,
                                  std::string("Traction ") + "xyz"[d],
                                  "Pa");
    update_nodes();
  }

  bool
  SurfaceLoad::is_needed(const BoundaryParameters &parameters)
  {
    const auto &t = parameters.traction;
    return !parameters.pressure.empty() || !t[0].empty() || !t[1].empty() ||
           !t[2].empty();
  }

  void
  SurfaceLoad::check_effect(const Discretization &body,
                            const IsPrescribed   &is_prescribed) const
  {
    const EffectCheck check(body, is_prescribed);
    if (pressure)
      {
        std::vector<Vector3<double>> areas(nodes.size());
        for (const auto &positions : face_positions)
          {
            std::array<Vector3<double>, 3> x;
            for (unsigned int c = 0; c < 3; ++c)
              x[c] = body.state.reference[nodes[positions[c]]].vector();
            for (const std::uint32_t position : positions)
              areas[position] += area_vector(x);
          }
        check.refuse_idle(pressure->name(),
                          pressure->expression(),
                          nodes,
                          [&](const std::size_t i) { return areas[i]; });
      }
    for (unsigned int d = 0; d < dim; ++d)
      if (traction[d])
        {
          Vector3<double> direction{};
          direction[d] = 1;
          check.refuse_idle(traction[d]->name(),
                            traction[d]->expression(),
                            nodes,
                            [&](std::size_t) { return direction; });
        }
  }

  std::vector<std::string>
  SurfaceLoad::warnings(const Discretization &body,
                        const double          time_step,
                        const std::uint64_t   n_steps) const
  {
    std::vector<TimeFunction> functions;
    if (pressure)
      functions.push_back(*pressure);
    for (const auto &component : traction)
      if (component)
        functions.push_back(*component);
    std::vector<std::string> result;
    if (body.communicator.is_root())
      add_doubts(functions, time_step, n_steps, result);
    return result;
  }

  std::vector<Warning>
  SurfaceLoad::follow_fragments(const Fragments    &fragments,
                                const Communicator &communicator)
  {
    std::vector<std::int64_t> numbers = {0, 0};
    for (std::size_t i = 0; i < surface.size(); ++i)
      {
        const CellIndex cell     = surface[i].cell;
        const bool      has_left = fragments.has_left(fragments.of_cell[cell]);
        if (acts_while_in_place && has_left)
          bears_load[i] = 0;
        if (topology.owns_cell(cell))
          {
            ++numbers[0];
            numbers[1] += has_left ? 1 : 0;
          }
      }
    communicator.sum(numbers);
    if (acts_while_in_place || !is_loaded || numbers[1] == 0)
      return {};
    return {{"the load on boundary \"" + boundary + "\"",
             " still acts on all of its " + std::to_string(numbers[0]) +
               " faces although the pieces of " + std::to_string(numbers[1]) +
               " have come off and moved by more than their size. Set \"Acts "
               "while in place = true\" in subsection \"Boundary " +
               boundary + "\" if it is to end there."}};
  }

  namespace
  {
    /** A face that bears no load any more. */
    struct FaceRecord
    {
      GlobalCellIndex cell;
      std::uint32_t   local_face;
    };
  } // namespace

  void
  SurfaceLoad::save(const Discretization &body, Archive &archive) const
  {
    ModuleWithWork::save(body, archive);
    std::vector<FaceRecord> records;
    for (std::size_t i = 0; i < surface.size(); ++i)
      if (!bears_load[i] && topology.owns_cell(surface[i].cell))
        records.push_back({topology.cell_global_indices[surface[i].cell],
                           surface[i].local_face});
    archive.write_list(name + ": faces that have left", records);
  }

  void
  SurfaceLoad::load(const Discretization &body, const Archive &archive)
  {
    ModuleWithWork::load(body, archive);
    std::set<std::pair<CellIndex, std::uint32_t>> released;
    for (const auto &[cell, local_face] :
         archive.read_list<FaceRecord>(name + ": faces that have left"))
      released.emplace(topology.find_cell(cell), local_face);
    for (std::size_t i = 0; i < surface.size(); ++i)
      bears_load[i] =
        1 - released.count({surface[i].cell, surface[i].local_face});
  }

  void
  SurfaceLoad::update_nodes()
  {
    nodes = surface_nodes(topology, surface);
    face_positions.clear();
    for (const CellFace &face : surface)
      {
        std::array<std::uint32_t, 3> positions;
        const auto                   of_face = face_nodes(topology, face);
        for (unsigned int c = 0; c < 3; ++c)
          {
            positions[c] = static_cast<std::uint32_t>(
              std::lower_bound(nodes.begin(), nodes.end(), of_face[c]) -
              nodes.begin());
            rift_check(nodes[positions[c]] == of_face[c]);
          }
        face_positions.push_back(positions);
      }
    forces.assign(nodes.size(), {{0, 0, 0}});
  }

  void
  SurfaceLoad::add_to(State &state, Activity &activity, const double time_step)
  {
    const double p =
      pressure ? pressure->mean_around(state.time, time_step) : 0;
    Vector3<double> t = {{0, 0, 0}};
    for (unsigned int d = 0; d < dim; ++d)
      if (traction[d])
        t[d] = traction[d]->mean_around(state.time, time_step);
    std::fill(forces.begin(), forces.end(), Vector3<double>{{0, 0, 0}});
    is_loaded = p != 0 || dot(t, t) != 0;
    if (!is_loaded)
      return;

    for (std::size_t face = 0; face < face_positions.size(); ++face)
      {
        if (!bears_load[face])
          continue;
        const auto                    &positions = face_positions[face];
        std::array<Vector3<double>, 3> x, reference;
        for (unsigned int c = 0; c < 3; ++c)
          {
            x[c]         = state.position(nodes[positions[c]]);
            reference[c] = state.reference[nodes[positions[c]]].vector();
          }
        const Vector3<double> force =
          (norm(area_vector(reference)) / 3) * t - (p / 3) * area_vector(x);
        for (const std::uint32_t position : positions)
          forces[position] += force;
      }
    for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        activity.wake_node(topology, nodes[i]);
        for (unsigned int d = 0; d < dim; ++d)
          state.force[nodes[i]][d] += forces[i][d];
      }
  }

  void
  SurfaceLoad::count_work(const State &state, const double time_step)
  {
    work_done.begin_step();
    for (std::size_t i = 0; i < nodes.size() && is_loaded; ++i)
      work_done.add(state, nodes[i], forces[i], time_step);
  }
} // namespace rift
