#ifndef rift_time_integration_energy_ledger_h
#define rift_time_integration_energy_ledger_h

#include <rift/base/exact_sum.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  /**
   * Energies at one time, J. All are computed from the state or from what
   * each module has used up by its own law, none as the difference of the
   * others, so that the residual tells of errors.
   */
  struct Energies
  {
    double kinetic  = 0;
    double strain   = 0;
    double cohesive = 0;
    double fracture = 0;
    double contact  = 0;
    double friction = 0;
    double damping  = 0;

    /** Work that loads, reactions and gravity have done on the body. */
    double loads = 0;

    double
    total() const
    {
      return kinetic + strain + cohesive + fracture + contact + friction +
             damping;
    }
  };

  /** What one rank owns of the energies, J. */
  struct EnergySums
  {
    ExactSum kinetic, strain, cohesive, fracture, contact, friction, damping,
      loads;

    /** The energies of the whole body. Collective. */
    Energies
    total(const Communicator &communicator) const
    {
      EnergySums all = *this;
      ExactSum::sum_over_ranks({&all.kinetic,
                                &all.strain,
                                &all.cohesive,
                                &all.fracture,
                                &all.contact,
                                &all.friction,
                                &all.damping,
                                &all.loads},
                               communicator);
      Energies result;
      result.kinetic  = all.kinetic.value();
      result.strain   = all.strain.value();
      result.cohesive = all.cohesive.value();
      result.fracture = all.fracture.value();
      result.contact  = all.contact.value();
      result.friction = all.friction.value();
      result.damping  = all.damping.value();
      result.loads    = all.loads.value();
      return result;
    }
  };

  /** Watches over the balance of energy. */
  class EnergyLedger
  {
  public:
    /** Takes in the energies of one time; the first call is the start. */
    void
    enter(const Energies &energies)
    {
      if (!has_started)
        initial = energies.total() - energies.loads;
      has_started = true;
      now         = energies;
      input       = std::max({input,
                              std::abs(initial + energies.loads),
                              energies.kinetic + energies.strain});
      largest_residual =
        std::max(largest_residual, std::abs(relative_residual()));
    }

    const Energies &
    energies() const
    {
      return now;
    }

    /** Energy that has come from nowhere (positive) or gone there, J. */
    double
    residual() const
    {
      return now.total() - now.loads - initial;
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

    /** All that the ledger remembers, J, for a checkpoint. */
    struct Record
    {
      Energies now;
      double   initial, input, largest_residual, has_started;
    };

    Record
    record() const
    {
      return {now, initial, input, largest_residual, has_started ? 1. : 0.};
    }

    void
    restore(const Record &record)
    {
      now              = record.now;
      initial          = record.initial;
      input            = record.input;
      largest_residual = record.largest_residual;
      has_started      = record.has_started != 0;
    }

    /** Largest relative residual of all times. */
    double
    largest_relative_residual() const
    {
      return largest_residual;
    }

  private:
    Energies now;
    double   initial = 0, input = 0, largest_residual = 0;
    bool     has_started = false;
  };
} // namespace rift

#endif
