#include <rift/base/output_file.h>
#include <rift/io/summary.h>

#include <nlohmann/json.hpp>

namespace rift
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    Json
    object(const NamedNumbers &numbers)
    {
      Json result = Json::object();
      for (const auto &[name, value] : numbers)
        result[name] = value;
      return result;
    }
  } // namespace

  void
  write_summary(const std::string &path, const Summary &summary)
  {
    Json json;
    json["version"]   = summary.version;
    json["completed"] = summary.stopped_by.empty();
    if (!summary.stopped_by.empty())
      json["stopped_by"] = summary.stopped_by;
    json["warnings"]              = summary.warnings;
    json["cells"]                 = summary.cells;
    json["nodes_initial"]         = summary.nodes_initial;
    json["nodes_final"]           = summary.nodes_final;
    json["steps"]                 = summary.steps;
    json["time"]                  = summary.time;
    json["time_step"]             = summary.time_step;
    json["time_step_limited_by"]  = summary.time_step_limited_by;
    json["ranks"]                 = summary.ranks;
    json["wall_seconds"]          = summary.wall_seconds;
    json["cell_steps_per_second"] = summary.cell_steps_per_second;
    json["peak_memory_bytes"]     = summary.peak_memory_bytes;
    json["faces_inserted"]        = summary.faces_inserted;
    json["faces_broken"]          = summary.faces_broken;
    json["fragments"]             = summary.fragments;
    json["contact_pairs"]         = summary.contact_pairs;
    if (!summary.contact_bytes.empty())
      json["contact_bytes"] = object(summary.contact_bytes);
    json["energy"]                   = object(summary.energy);
    json["energy_residual_relative"] = summary.energy_residual_relative;
    json["state_hash"]               = summary.state_hash;
    json["wall_seconds_by_stage"]    = object(summary.wall_seconds_by_stage);

    // A name that is no UTF-8 must not cost the user the summary of a run.
    const std::string text =
      json.dump(2, ' ', false, Json::error_handler_t::replace);
    write_file_atomically(path, text + '\n');
  }
} // namespace rift
