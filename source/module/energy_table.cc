#include <rift/base/check.h>
#include <rift/module/energy_table.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    const std::string loads = "loads";

    template <typename Terms>
    auto
    find_term(Terms &terms, const std::string &name)
    {
      return std::find_if(terms.begin(), terms.end(), [&](const auto &term) {
        return term.first == name;
      });
    }

    /** Whether all ranks have named the same energies, in one order.
     * Collective. */
    bool
    is_same_on_ranks(const std::vector<std::pair<std::string, ExactSum>> &sums,
                     const Communicator &communicator)
    {
      std::string names;
      for (const auto &[name, sum] : sums)
        names += name + ";";
      std::string names_of_root = names;
      communicator.broadcast(names_of_root);
      return names == names_of_root;
    }
  } // namespace

  Energies::Energies()
  {
    for (const char *name : {"kinetic",
                             "strain",
                             "cohesive",
                             "fracture",
                             "contact",
                             "friction",
                             "damping"})
      all.emplace_back(name, 0);
    all.emplace_back(loads, 0);
  }

  double
  Energies::operator[](const std::string &name) const
  {
    const auto term = find_term(all, name);
    return term == all.end() ? 0 : term->second;
  }

  double &
  Energies::at(const std::string &name)
  {
    auto term = find_term(all, name);
    if (term == all.end())
      term = all.insert(find_term(all, loads), {name, 0});
    return term->second;
  }

  double
  Energies::total() const
  {
    double sum = 0;
    for (const auto &[name, energy] : all)
      if (name != loads)
        sum += energy;
    return sum;
  }

  ExactSum &
  EnergyTable::operator[](const std::string &name)
  {
    auto term = find_term(sums, name);
    if (term == sums.end())
      term = sums.insert(sums.end(), {name, ExactSum()});
    return term->second;
  }

  Energies
  EnergyTable::total(const Communicator &communicator) const
  {
    rift_check(is_same_on_ranks(sums, communicator));
    auto                    all = sums;
    std::vector<ExactSum *> pointers;
    for (auto &[name, sum] : all)
      pointers.push_back(&sum);
    ExactSum::sum_over_ranks(pointers, communicator);
    Energies result;
    for (const auto &[name, sum] : all)
      result.at(name) = sum.value();
    return result;
  }
} // namespace rift
