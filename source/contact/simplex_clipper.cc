#include <rift/base/check.h>
#include <rift/contact/simplex_clipper.h>
#include <rift/contact/simplex_cut.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    /** The part to which lanes go that are none. */
    constexpr unsigned int no_body = SimplexClipper::capacity;

    /** Simplices that wait to be cut: no body is there twice. */
    class Queue
    {
    public:
      /** @param lanes bits of those to be added. */
      void
      push(const SimplexBatch &simplices, const unsigned int lanes)
      {
        if (lanes == 0)
          return;
        const LanePacking packed(lanes);
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            store(packed(simplices.corners[c][k]), &corners[c][k][n]);
        store(packed(simplices.volume), &volumes[n]);
        store(packed((Simd)simplices.body), &bodies[n]);
        n += __builtin_popcount(lanes);
        rift_check(n <= SimplexClipper::capacity);
      }

      /** Takes out the last ones.
       * @return bits of the lanes that there were: none if it is empty. */
      unsigned int
      take(SimplexBatch &simplices)
      {
        const unsigned int n_taken = std::min(n, batch_size);
        n -= n_taken;
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            simplices.corners[c][k] = load(&corners[c][k][n]);
        simplices.volume = load(&volumes[n]);
        simplices.body   = (SimdMask)load(&bodies[n]);
        return (1U << n_taken) - 1;
      }

    private:
      static constexpr unsigned int length =
        SimplexClipper::capacity + batch_size;

      unsigned int n = 0;
      alignas(64) double corners[4][n_point_coordinates][length];
      alignas(64) double volumes[length];
      alignas(64) double bodies[length];
    };

    /** How planes cut simplices: bits of lanes. What is wholly outside of a
     * plane is nowhere. */
    struct Kinds
    {
      /** By the number of planes that cut them. */
      unsigned int cut_by[5];

      /** Those of two planes and more of which one has but one corner inside.
       */
      unsigned int corner;
    };

    Kinds
    kinds_of(const std::array<PointBatch, 4> &p, const unsigned int lanes)
    {
      SimdMask outside{}, three_outside{}, s[4];
      for (unsigned int k = 0; k < 4; ++k)
        {
          const SimdMask a = (SimdMask)p[0][k], b = (SimdMask)p[1][k],
                         c = (SimdMask)p[2][k], d = (SimdMask)p[3][k];
          const SimdMask ab = a & b, cd = c & d, a_b = a | b, c_d = c | d;
          outside |= ab & cd;
          three_outside |= (ab & c_d) | (cd & a_b);
          s[k] = a_b | c_d;
        }
      const unsigned int in   = lanes & ~sign_bits(outside);
      const SimdMask     both = s[0] & s[1], also_both = s[2] & s[3],
                     either = s[0] | s[1], or_either = s[2] | s[3];
      const unsigned int one    = in & sign_bits(either | or_either),
                         two    = in & sign_bits(both | also_both |
                                              (either & or_either)),
                         three  = in & sign_bits((both & or_either) |
                                                (also_both & either)),
                         four   = in & sign_bits(both & also_both),
                         corner = two & sign_bits(three_outside);
      return {{in & ~one,
               one & ~two,
               two & ~(three | corner),
               three & ~(four | corner),
               four & ~corner},
              corner};
    }

    /** Planes with one corner inside. */
    struct CornerPlane
    {
      explicit CornerPlane(const std::array<PointBatch, 4> &p)
      {
        for (unsigned int k = 0; k < 3; ++k)
          {
            const SimdMask a = (SimdMask)p[0][k], b = (SimdMask)p[1][k],
                           c = (SimdMask)p[2][k], d = (SimdMask)p[3][k];
            is[k] = (((a & b) & (c | d)) | ((c & d) & (a | b))) < 0;
          }
        is[1] &= ~is[0];
        is[2] &= ~(is[0] | is[1]);
        is[3] = ~(is[0] | is[1] | is[2]);
        for (unsigned int c = 0; c < 4; ++c)
          plane[c] =
            select(is[0],
                   p[c][0],
                   select(is[1], p[c][1], select(is[2], p[c][2], p[c][3])));
      }

      /** Whether it is the plane of that coordinate. */
      SimdMask is[4];

      Plane plane;
    };

    /** Replaces simplices by the part at their only corner inside of a plane.
     */
    void
    cut_to_corner(SimplexBatch &simplices)
    {
      const CornerPlane choice(simplices.corners);
      Plane             f = choice.plane;
      SimdMask          is_inside[4];
      for (unsigned int c = 1; c < 4; ++c)
        {
          is_inside[c] = f[c] >= 0;
          exchange(is_inside[c], f[0], f[c]);
        }
      const Simd d1 = f[0] - f[1], d2 = f[0] - f[2], d3 = f[0] - f[3];
      const Simd d12 = d1 * d2, one = broadcast(1);
      const Simd over_all = f[0] / (d12 * d3), over_12 = over_all * d3;
      const Simd t[4] = {one,
                         min(over_12 * d2, one),
                         min(over_12 * d1, one),
                         min(over_all * d12, one)};
      for (unsigned int k = 0; k < n_point_coordinates; ++k)
        {
          auto &p  = simplices.corners;
          Simd  p0 = p[0][k];
          for (unsigned int c = 1; c < 4; ++c)
            exchange(is_inside[c], p0, p[c][k]);
          p[0][k] = p0;
          for (unsigned int c = 1; c < 4; ++c)
            {
              // Exactly in the plane, which it is not cut by again.
              const Simd x = p0 + t[c] * (p[c][k] - p0);
              p[c][k]      = k < 4 ? select(choice.is[k], Simd{}, x) : x;
            }
        }
      simplices.volume *= t[1] * t[2] * t[3];
    }

    SimdMask
    cuts(const std::array<PointBatch, 4> &p, const unsigned int k)
    {
      return (((SimdMask)p[0][k] | (SimdMask)p[1][k]) |
              ((SimdMask)p[2][k] | (SimdMask)p[3][k])) < 0;
    }

    /** The first n of the planes that cut. */
    template <std::size_t n>
    std::array<Plane, n>
    cutting_planes(const std::array<PointBatch, 4> &p)
    {
      static_assert(n >= 1 && n <= 4);
      const SimdMask by_0 = cuts(p, 0), by_1 = cuts(p, 1), by_2 = cuts(p, 2);
      std::array<Plane, n> planes;
      for (unsigned int c = 0; c < 4; ++c)
        {
          const PointBatch &x = p[c];
          if constexpr (n == 1)
            planes[0][c] =
              select(by_0, x[0], select(by_1, x[1], select(by_2, x[2], x[3])));
          if constexpr (n == 2)
            {
              planes[0][c] = select(by_0, x[0], select(by_1, x[1], x[2]));
              planes[1][c] = select(by_0 & by_1,
                                    x[1],
                                    select(by_2 & (by_0 | by_1), x[2], x[3]));
            }
          if constexpr (n == 4)
            for (unsigned int k = 0; k < n; ++k)
              planes[k][c] = x[k];
          if constexpr (n == 3)
            {
              planes[0][c] = select(by_0, x[0], x[1]);
              planes[1][c] = select(by_0 & by_1, x[1], x[2]);
              planes[2][c] = select((by_0 & by_1) & by_2, x[2], x[3]);
            }
        }
      return planes;
    }
  } // namespace

  struct SimplexClipper::Workspace
  {
    /** Sorts simplices into the queues, or records those that need no cut. */
    void
    sort_in(const SimplexBatch &simplices, unsigned int lanes);

    /** Sets the parts of bodies. @param weights of the corners of what is left
     * of them, in what is inside. */
    void
    record(const SimplexBatch &rest,
           const Weights      &weights,
           unsigned int        lanes);

    /** Replaces simplices by their only corner inside of a plane. */
    void
    cut_corners();

    template <std::size_t n>
    void
    finish();

    BodyPart parts[no_body + 1];

    /** Simplices by the number of planes that cut them, and those of which a
     * plane leaves only one corner. */
    Queue queues[5], corners;
  };

  void
  SimplexClipper::Workspace::sort_in(const SimplexBatch &simplices,
                                     const unsigned int  lanes)
  {
    const Kinds kinds = kinds_of(simplices.corners, lanes);
    if (kinds.cut_by[0] != 0)
      record(simplices, inside<0>({}), kinds.cut_by[0]);
    for (unsigned int n = 1; n <= 4; ++n)
      queues[n].push(simplices, kinds.cut_by[n]);
    corners.push(simplices, kinds.corner);
  }

  void
  SimplexClipper::Workspace::record(const SimplexBatch &rest,
                                    const Weights      &weights,
                                    const unsigned int  lanes)
  {
    Weights w;
    for (unsigned int c = 0; c < 4; ++c)
      w[c] = rest.volume * weights[c];
    std::array<Simd, 8> columns{};
    columns[0] = (w[0] + w[1]) + (w[2] + w[3]);
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      columns[1 + k] = (w[0] * rest.corners[0][k] + w[1] * rest.corners[1][k]) +
                       (w[2] * rest.corners[2][k] + w[3] * rest.corners[3][k]);
    const std::array<Simd, 8> rows = transpose(columns);
    const SimdMask body = mask_of(lanes) ? rest.body : SimdMask{} + no_body;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      store(rows[lane], &parts[body[lane]].volume);
  }

  void
  SimplexClipper::Workspace::cut_corners()
  {
    SimplexBatch simplices;
    while (const unsigned int lanes = corners.take(simplices))
      {
        cut_to_corner(simplices);
        sort_in(simplices, lanes);
      }
  }

  template <std::size_t n>
  void
  SimplexClipper::Workspace::finish()
  {
    SimplexBatch simplices;
    while (const unsigned int lanes = queues[n].take(simplices))
      record(simplices, inside<n>(cutting_planes<n>(simplices.corners)), lanes);
  }

  SimplexClipper::SimplexClipper()
    : workspace(std::make_unique<Workspace>())
  {
  }

  SimplexClipper::~SimplexClipper() = default;

  void
  SimplexClipper::start(const unsigned int n_bodies)
  {
    rift_check(n_bodies <= capacity);
    for (unsigned int i = 0; i < n_bodies; ++i)
      workspace->parts[i] = {};
  }

  void
  SimplexClipper::add(const SimplexBatch &simplices, const unsigned int lanes)
  {
    workspace->sort_in(simplices, lanes);
  }

  void
  SimplexClipper::clip()
  {
    workspace->cut_corners();
    workspace->finish<1>();
    workspace->finish<2>();
    workspace->finish<3>();
    workspace->finish<4>();
  }

  const BodyPart *
  SimplexClipper::parts() const
  {
    return workspace->parts;
  }
} // namespace rift
