#ifndef rift_tests_support_single_pair_h
#define rift_tests_support_single_pair_h

#include <rift/contact/contact_pair.h>

#include "scalar_overlap.h"

#include <memory>

// The kernels of pairs for a single one.
namespace rift::test
{
  inline Overlap
  overlap_of_lane(const OverlapOctet &octet, const unsigned int lane)
  {
    Overlap result;
    result.potential       = octet.potential[lane];
    result.volume          = octet.volume[lane];
    result.volume_fraction = octet.volume_fraction[lane];
    for (unsigned int c = 0; c < 4; ++c)
      {
        for (unsigned int d = 0; d < 3; ++d)
          {
            result.gradient_a[c][d] = octet.gradient_a[c][d][lane];
            result.gradient_b[c][d] = octet.gradient_b[c][d][lane];
          }
        result.weights_a[c] = octet.weights_a[c][lane];
        result.weights_b[c] = octet.weights_b[c][lane];
      }
    return result;
  }

  inline Overlap
  overlap(const Tetrahedron &a, const Tetrahedron &b)
  {
    static const auto  batch    = std::make_unique<OverlapBatch>();
    const PackedMotion cells[2] = {pack(a), pack(b)};
    const CellPair     pair     = {0, 1};
    return overlap_of_lane(*batch->intersect(cells, &pair, 1), 0);
  }

  inline PairForces
  pair_forces(const CellMotion       &a,
              const CellMotion       &b,
              const ContactConstants &constants,
              const double            time_step,
              ContactMemory          &memory)
  {
    static const auto  kernel   = std::make_unique<PairKernel>();
    const PackedMotion cells[2] = {pack(a), pack(b)};
    ContactPair        pair     = {{0, 1}, constants, memory};
    PairForces         forces;
    kernel->compute(cells, &pair, 1, time_step, &forces);
    memory = pair.memory;
    return forces;
  }
} // namespace rift::test

#endif
