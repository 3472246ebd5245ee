#ifndef rift_contact_separation_h
#define rift_contact_separation_h
#include <rift/contact/overlap.h>
#include <rift/contact/packed_motion.h>
namespace rift
{
  constexpr std::uint8_t no_axis = 255;
  void
  find_gaps(const PackedMotion *cells,
            const CellPair     *pairs,
            std::size_t         n,
            std::uint8_t       *axes,
            double             *gaps);
}
#endif
