#ifndef rift_module_energy_table_h
#define rift_module_energy_table_h

#include <rift/base/exact_sum.h>

#include <string>
#include <utility>
#include <vector>

namespace rift
{
  /**
   * Energies at one time by name, J. "loads" is the work that loads, reactions
   * and gravity have done on the body; all others are where it has gone. They
   * are computed from the state, or from what each module has used up by its
   * own law, none as the difference of the others, so that the residual of the
   * balance reveals errors.
   */
  class Energies
  {
  public:
    Energies();

    /** An energy that is not there is zero. */
    double
    operator[](const std::string &name) const;

    /** Adds the energy `name` if it is new: before "loads". */
    double &
    at(const std::string &name);

    /** Sum of all energies but the work of the loads. */
    double
    total() const;

    /** Names and energies, always in the same order: those that every run has,
     * with those of single modules before "loads". */
    const std::vector<std::pair<std::string, double>> &
    terms() const
    {
      return all;
    }

  private:
    std::vector<std::pair<std::string, double>> all;
  };

  /**
   * What one rank owns of the energies. Each module adds to those that it
   * changes; an energy with a name of its own becomes a column of energy.csv,
   * a term of the balance and an entry of summary.json by that.
   */
  class EnergyTable
  {
  public:
    /** The part of this rank of an energy, J. */
    ExactSum &
    operator[](const std::string &name);

    /** The energies of the whole body. Collective: all ranks must have named
     * the same energies. */
    Energies
    total(const Communicator &communicator) const;

  private:
    std::vector<std::pair<std::string, ExactSum>> sums;
  };
} // namespace rift

#endif
