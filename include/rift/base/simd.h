#ifndef rift_base_simd_h
#define rift_base_simd_h

#include <rift/base/types.h>
#include <rift/base/vector3.h>

#include <cmath>
#include <cstring>

#ifdef __AVX512DQ__
#include <immintrin.h>
#endif

/**
 * @file
 *
 * SIMD arithmetic with the vector types of GCC and Clang. deal.II's
 * VectorizedArray has one lane in Debian's package, and std::experimental::simd
 * lacks the shuffles that the gather and scatter below live on.
 */
namespace rift
{
  /** One number for each lane of a batch. */
  using Simd = double __attribute__((vector_size(8 * batch_size)));

  /** What comparisons of Simd give: all bits set in a lane where true. */
  using SimdMask = std::int64_t __attribute__((vector_size(8 * batch_size)));

  /** The data of one node: x, y, z and one unused place, aligned. */
  using Row = double __attribute__((vector_size(32)));

  /** A Row that may be read from and written to an array of double. */
  using AliasingRow = double __attribute__((vector_size(32), may_alias));

  /**
   * A vector per node, stored as an aligned row of four numbers so that a
   * node's data is read and written at once.
   */
  struct alignas(32) NodalVector
  {
    /** x, y, z and an unused number. */
    double v[4] = {0, 0, 0, 0};

    /** Component 0, 1 or 2. */
    double &
    operator[](const unsigned int d)
    {
      return v[d];
    }

    /** Component 0, 1 or 2. */
    double
    operator[](const unsigned int d) const
    {
      return v[d];
    }

    /** The three components, for formulas. */
    Vector3<double>
    vector() const
    {
      return {{v[0], v[1], v[2]}};
    }

    /** All four numbers, to be read and written at once. */
    AliasingRow &
    row()
    {
      return reinterpret_cast<AliasingRow &>(v);
    }

    /** All four numbers, to be read at once. */
    const AliasingRow &
    row() const
    {
      return reinterpret_cast<const AliasingRow &>(v);
    }
  };

  /** The same number in all lanes. */
  inline Simd
  broadcast(const double a)
  {
    return Simd{} + a;
  }

  /** Whether a mask is true in any lane. */
  inline bool
  any(const SimdMask &mask)
  {
    std::int64_t bits = 0;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      bits |= mask[lane];
    return bits != 0;
  }

  /** Bit `lane` of the result is the sign of that lane: lanes where a mask is
   * true. */
  inline unsigned int
  sign_bits(const SimdMask &mask)
  {
#ifdef __AVX512DQ__
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(mask));
#else
    unsigned int bits = 0;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      bits |= static_cast<unsigned int>(mask[lane] < 0) << lane;
    return bits;
#endif
  }

  /** The mask that is true in the lanes whose bits are set: the inverse of
   * sign_bits(). */
  inline SimdMask
  mask_of(const unsigned int bits)
  {
    static_assert(batch_size == 8, "one shift for each of eight lanes");
    const SimdMask shifts = {63, 62, 61, 60, 59, 58, 57, 56};
    return ((SimdMask{} + bits) << shifts) < 0;
  }

  /** The mask itself, so that a law has one text for double and Simd. */
  inline bool
  any(const bool mask)
  {
    return mask;
  }

  // The functions below exist for double and for Simd, so that a law can be
  // written once for both.

  /** `if_true` in lanes where the mask is true, `if_false` in the others. */
  inline Simd
  select(const SimdMask &mask, const Simd &if_true, const Simd &if_false)
  {
    return mask ? if_true : if_false;
  }

  /** `mask ? if_true : if_false`, for laws with double. */
  inline double
  select(const bool mask, const double if_true, const double if_false)
  {
    return mask ? if_true : if_false;
  }

  /** Lane by lane; the second one where the two do not compare. */
  template <typename Number>
  inline Number
  max(const Number &a, const Number &b)
  {
    return select(a > b, a, b);
  }

  /** Lane by lane; the second one where the two do not compare. */
  template <typename Number>
  inline Number
  min(const Number &a, const Number &b)
  {
    return select(a < b, a, b);
  }

  /** The square root of a number, for laws that are templates. */
  inline double
  sqrt(const double a)
  {
    return std::sqrt(a);
  }

  /** Lane by lane; not a number where negative. */
  inline Simd
  sqrt(const Simd &a)
  {
    Simd result{};
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      result[lane] = __builtin_sqrt(a[lane]);
    return result;
  }

  /** Reads a number for each lane from anywhere. */
  inline Simd
  load(const double *data)
  {
    Simd result;
    std::memcpy(&result, data, sizeof(result));
    return result;
  }

  /** Writes the numbers of all lanes to anywhere. */
  inline void
  store(const Simd &value, double *data)
  {
    std::memcpy(data, &value, sizeof(value));
  }

  /** For each set of lanes, bit by bit, their numbers in ascending order. */
  struct LaneOrders
  {
    constexpr LaneOrders()
      : lanes{}
    {
      for (unsigned int bits = 0; bits < 1 << batch_size; ++bits)
        for (unsigned int lane = 0, n = 0; lane < batch_size; ++lane)
          if (bits >> lane & 1)
            lanes[bits][n++] = static_cast<std::int8_t>(lane);
    }

    /** Lanes that follow the last one of a set are 0. */
    alignas(64) std::int8_t lanes[1 << batch_size][batch_size];
  };

  /** Moves the lanes of a set to the front. */
  class LanePacking
  {
  public:
    /** @param bits of the set. */
    explicit LanePacking(const unsigned int bits)
    {
      using Bytes = std::int8_t __attribute__((vector_size(batch_size)));
      Bytes bytes;
      std::memcpy(&bytes, orders.lanes[bits], sizeof(bytes));
      order = __builtin_convertvector(bytes, SimdMask);
    }

    /** Lanes that follow the last one of the set have any of the numbers. */
    Simd
    operator()(const Simd &value) const
    {
#ifdef __clang__
      Simd result;
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        result[lane] = value[order[lane]];
      return result;
#else
      return __builtin_shuffle(value, order);
#endif
    }

  private:
    static constexpr LaneOrders orders{};

    SimdMask order;
  };

  /** Eight numbers of each lane, as rows or as columns. */
  inline std::array<Simd, 8>
  transpose(const std::array<Simd, 8> &r)
  {
    static_assert(batch_size == 8, "the shuffles below are for eight lanes");
    std::array<Simd, 8> t, u, result;
    for (unsigned int i = 0; i < 8; i += 2)
      {
        t[i] =
          __builtin_shufflevector(r[i], r[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        t[i + 1] =
          __builtin_shufflevector(r[i], r[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
      }
    for (unsigned int i = 0; i < 8; i += 4)
      for (unsigned int j = i; j < i + 2; ++j)
        {
          u[j] =
            __builtin_shufflevector(t[j], t[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
          u[j + 2] =
            __builtin_shufflevector(t[j], t[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (unsigned int j = 0; j < 4; ++j)
      {
        result[j] =
          __builtin_shufflevector(u[j], u[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        result[j + 4] =
          __builtin_shufflevector(u[j], u[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
      }
    return result;
  }

  /**
   * Reads eight rows of four numbers and transposes them: number d of row
   * `rows[lane]` comes to lane `lane` of `result[d]`.
   */
  inline std::array<Simd, 4>
  gather_rows(const NodalVector *data, const std::uint32_t *rows)
  {
    static_assert(batch_size == 8, "the shuffles below are for eight lanes");
    const auto pair = [&](const unsigned int lane) {
      const Row low  = data[rows[lane]].row();
      const Row high = data[rows[lane + 4]].row();
      return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const Simd a = pair(0), b = pair(1), c = pair(2), d = pair(3);

    const Simd ab_02 = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    const Simd ab_13 = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
    const Simd cd_02 = __builtin_shufflevector(c, d, 0, 8, 2, 10, 4, 12, 6, 14);
    const Simd cd_13 = __builtin_shufflevector(c, d, 1, 9, 3, 11, 5, 13, 7, 15);
    return {
      {__builtin_shufflevector(ab_02, cd_02, 0, 1, 8, 9, 4, 5, 12, 13),
       __builtin_shufflevector(ab_13, cd_13, 0, 1, 8, 9, 4, 5, 12, 13),
       __builtin_shufflevector(ab_02, cd_02, 2, 3, 10, 11, 6, 7, 14, 15),
       __builtin_shufflevector(ab_13, cd_13, 2, 3, 10, 11, 6, 7, 14, 15)}};
  }

  /** The vectors of eight nodes, component by component; see gather_rows(). */
  inline Vector3<Simd>
  gather(const NodalVector *data, const NodeIndex *nodes)
  {
    const auto rows = gather_rows(data, nodes);
    return {{rows[0], rows[1], rows[2]}};
  }

  /** The transpose of gather(): one row (x, y, z, 0) for each lane. */
  inline std::array<Row, batch_size>
  transpose_to_rows(const Vector3<Simd> &value)
  {
    const Simd zero{};
    const Simd xy_02 =
      __builtin_shufflevector(value[0], value[1], 0, 8, 2, 10, 4, 12, 6, 14);
    const Simd xy_13 =
      __builtin_shufflevector(value[0], value[1], 1, 9, 3, 11, 5, 13, 7, 15);
    const Simd z0_02 =
      __builtin_shufflevector(value[2], zero, 0, 8, 2, 10, 4, 12, 6, 14);
    const Simd z0_13 =
      __builtin_shufflevector(value[2], zero, 1, 9, 3, 11, 5, 13, 7, 15);
    const Simd rows[4] = {
      __builtin_shufflevector(xy_02, z0_02, 0, 1, 8, 9, 4, 5, 12, 13),
      __builtin_shufflevector(xy_13, z0_13, 0, 1, 8, 9, 4, 5, 12, 13),
      __builtin_shufflevector(xy_02, z0_02, 2, 3, 10, 11, 6, 7, 14, 15),
      __builtin_shufflevector(xy_13, z0_13, 2, 3, 10, 11, 6, 7, 14, 15)};
    std::array<Row, batch_size> result;
    for (unsigned int i = 0; i < 4; ++i)
      {
        result[i]     = __builtin_shufflevector(rows[i], rows[i], 0, 1, 2, 3);
        result[i + 4] = __builtin_shufflevector(rows[i], rows[i], 4, 5, 6, 7);
      }
    return result;
  }
} // namespace rift

#endif
