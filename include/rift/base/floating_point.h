#ifndef rift_base_floating_point_h
#define rift_base_floating_point_h

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace rift
{
  /**
   * While an object of this class lives, results too small for a normal
   * number become zero. In front of a wave the displacement falls off to such
   * numbers, on which the processor is a hundred times slower.
   */
  class FlushDenormals
  {
  public:
#if defined(__SSE__)
    FlushDenormals()
      : former(_mm_getcsr())
    {
      constexpr unsigned int flush_to_zero = 0x8000, denormals_are_zero = 0x40;
      _mm_setcsr(former | flush_to_zero | denormals_are_zero);
    }

    ~FlushDenormals()
    {
      _mm_setcsr(former);
    }

  private:
    const unsigned int former;
#endif
  };
} // namespace rift

#endif
