#ifndef rift_time_integration_energy_ledger_h
#define rift_time_integration_energy_ledger_h

#include <rift/base/archive.h>
#include <rift/module/energy_table.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  /** Watches over the balance of energy. */
  class EnergyLedger
  {
  public:
    /** Takes in the energies of one time; the first call is the start. */
    void
    enter(const Energies &energies)
    {
      if (!has_started)
        initial = energies.total() - energies["loads"];
      has_started = true;
      now         = energies;
      input       = std::max({input,
                              std::abs(initial + energies["loads"]),
                              energies["kinetic"] + energies["strain"],
                              rounding * std::abs(initial),
                              rounding * std::abs(energies["loads"])});
      largest_residual =
        std::max(largest_residual, std::abs(relative_residual()));
    }

    /** The terms at the last update, J. */
    const Energies &
    energies() const
    {
      return now;
    }

    /** Energy that has come from nowhere (positive) or gone there, J. */
    double
    residual() const
    {
      return now.total() - now["loads"] - initial;
    }

    /** The residual over the largest energy that was in play so far; infinite
     * if an energy is not a number. */
    double
    relative_residual() const
    {
      if (!std::isfinite(residual()))
        return std::numeric_limits<double>::infinity();
      return input > 0 ? residual() / input : 0;
    }

    /** Stores what the residual is measured from. */
    void
    save(Archive &archive) const
    {
      archive.write_value("ledger", Record{{initial, input, largest_residual}});
    }

    /** Continues from what save() has written. */
    void
    load(const Archive &archive)
    {
      const auto record = archive.read_value<Record>("ledger");
      initial           = record[0];
      input             = record[1];
      largest_residual  = record[2];
      has_started       = true;
    }

    /** Largest relative residual of all times. */
    double
    largest_relative_residual() const
    {
      return largest_residual;
    }

  private:
    /**
     * The residual is a difference to `initial` and to the work of the loads.
     * Where these cancel each other, as those of a load and of what holds the
     * body do, it is no less than their rounding, which is 1e-16 of them. By
     * this share of them the energy in play is so large that rounding is some
     * 1e-6 of it.
     */
    static constexpr double rounding = 1e-10;

    /** `initial`, `input` and `largest_residual`, J, J and 1. */
    using Record = std::array<double, 3>;

    Energies now;
    double   initial = 0, input = 0, largest_residual = 0;
    bool     has_started = false;
  };
} // namespace rift

#endif
