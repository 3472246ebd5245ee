// Prints a checksum of the forces, memories and gaps of random pairs of cells.
// It is built twice, for this machine and for any: both print the same.

#include <rift/contact/separation.h>

#include "../support/contact_pairs.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <memory>

using namespace rift;
using namespace rift::test;

namespace
{
  /** FNV-1a of the bits of numbers. */
  class Checksum
  {
  public:
    void
    add(const double number)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &number, sizeof(bits));
      // Not a number has no particular sign.
      value = (value ^ (number == number ? bits : 1)) * 1099511628211ULL;
    }

    std::uint64_t value = 14695981039346656037ULL;
  };
} // namespace

int
main()
{
  PairGenerator make(1);
  PairList      list;
  for (unsigned int i = 0; i < 2000; ++i)
    for (const PairKind kind : all_pair_kinds)
      list.add(make, kind);
  std::vector<ContactPair>  pairs = contact_pairs(list, make);
  std::vector<std::uint8_t> axes(pairs.size(), no_axis);
  std::vector<double>       gaps(pairs.size());
  find_gaps(list.cells.data(),
            list.pairs.data(),
            pairs.size(),
            axes.data(),
            gaps.data());

  Checksum                checksum;
  const auto              kernel = std::make_unique<PairKernel>();
  std::vector<PairForces> forces(PairKernel::chunk_size);
  for (std::size_t first = 0; first < pairs.size();
       first += PairKernel::chunk_size)
    {
      const auto n = static_cast<unsigned int>(
        std::min<std::size_t>(PairKernel::chunk_size, pairs.size() - first));
      kernel->compute(list.cells.data(), &pairs[first], n, 1e-6, forces.data());
      for (unsigned int i = 0; i < n; ++i)
        {
          for (unsigned int c = 0; c < 4; ++c)
            for (unsigned int d = 0; d < 3; ++d)
              {
                checksum.add(forces[i].on_a[c][d]);
                checksum.add(forces[i].on_b[c][d]);
              }
          checksum.add(forces[i].energy);
          checksum.add(forces[i].friction_loss);
          checksum.add(forces[i].damping_loss);
          const ContactMemory &memory = pairs[first + i].memory;
          checksum.add(memory.initial_potential);
          for (const double x : memory.slip)
            checksum.add(x);
          checksum.add(memory.stiffness);
          checksum.add(memory.damping_force);
          checksum.add(gaps[first + i]);
          checksum.add(axes[first + i]);
        }
    }
  std::cout << checksum.value << "\n";
}
