#ifndef rift_io_summary_h
#define rift_io_summary_h

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace rift
{
  /** Numbers with names, in the order in which they are written. */
  using NamedNumbers = std::vector<std::pair<std::string, double>>;

  /**
   * What a run came to. The members have the names of the keys of
   * summary.json, which scripts read: they are stable.
   */
  struct Summary
  {
    /** Version of rift. */
    std::string version;

    /** Why the run has failed; empty if it has come to its end. In the file
     * `completed` says which, and only a run that has failed has this key. */
    std::string stopped_by;

    /** The warnings of the run, as in its log. */
    std::vector<std::string> warnings;

    /** Numbers of cells, of nodes at the start and at the end, and of steps. */
    std::uint64_t cells         = 0;
    std::uint64_t nodes_initial = 0;
    std::uint64_t nodes_final   = 0;
    std::uint64_t steps         = 0;

    /** Simulated time and the time step, s; what decides the latter. */
    double      time      = 0;
    double      time_step = 0;
    std::string time_step_limited_by;

    /** Ranks, time of the run on the clock, s, speed, and the largest memory of
     * all ranks together, bytes. */
    unsigned int  ranks                 = 1;
    double        wall_seconds          = 0;
    double        cell_steps_per_second = 0;
    std::uint64_t peak_memory_bytes     = 0;

    /** Faces with a cohesive element and those of them that have failed,
     * fragments, and pairs in contact at the end. */
    std::uint64_t faces_inserted = 0;
    std::uint64_t faces_broken   = 0;
    std::uint64_t fragments      = 0;
    std::uint64_t contact_pairs  = 0;

    /** Bytes that the parts of contact take at the end, on all ranks together;
     * empty without contact. */
    NamedNumbers contact_bytes;

    /** The terms of the energy ledger at the end, J. */
    NamedNumbers energy;

    /** Largest residual of the ledger over the run, per energy in play. */
    double energy_residual_relative = 0;

    /** Hash of the final displacements and velocities in canonical order. */
    std::string state_hash;

    /** Where the wall time went, s. */
    NamedNumbers wall_seconds_by_stage;
  };

  /**
   * Writes the summary as a JSON object with one line for each key, or not at
   * all. A number that is not finite becomes `null`: JSON has none.
   *
   * @throws DiskError if the file cannot be written.
   */
  void
  write_summary(const std::string &path, const Summary &summary);
} // namespace rift

#endif
