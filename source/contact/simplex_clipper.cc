#include <rift/base/check.h>
#include <rift/contact/simplex_clipper.h>


namespace rift
{
  namespace
  {
    /** Of a chunk, and a place for lanes that are none. */
    constexpr unsigned int no_body = SimplexClipper::capacity;

    /** Simplices that wait to be cut, one after the other in tiles, each of
     * which lies together in memory. */
    class Queue
    {
    public:
      unsigned int
      size() const
      {
        return n;
      }

      void
      clear()
      {
        n = 0;
      }

      /** @param lanes bits of those to be added. */
      void
      push(const SimplexBatch &simplices, const unsigned int lanes)
      {
        if (lanes == 0)
          return;
        rift_check(n + batch_size <= most);
        const LanePacking  packed(lanes);
        Tile              &tile  = tiles[n / tile_size];
        const unsigned int first = n % tile_size;
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            store(packed(simplices.corners[c][k]),
                  &tile.fields[c * n_point_coordinates + k][first]);
        store(packed(simplices.volume), &tile.fields[volume_field][first]);
        store(packed((Simd)simplices.body), &tile.fields[body_field][first]);
        const unsigned int n_added = __builtin_popcount(lanes);
        n += n_added;
        if (first + n_added > tile_size)
          for (unsigned int i = 0; i < n_fields; ++i)
            store(load(&tile.fields[i][tile_size]),
                  &tiles[n / tile_size].fields[i][0]);
      }

      /** @param first a multiple of batch_size. */
      SimplexBatch
      read(const unsigned int first) const
      {
        const Tile &tile  = tiles[first / tile_size];
        const auto  field = [&](const unsigned int i) {
          return load(&tile.fields[i][first % tile_size]);
        };
        SimplexBatch result;
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            result.corners[c][k] = field(c * n_point_coordinates + k);
        result.volume = field(volume_field);
        result.body   = (SimdMask)field(body_field);
        return result;
      }

      /** Bits of the lanes that read() fills. */
      unsigned int
      lanes(const unsigned int first) const
      {
        return n - first >= batch_size ? (1 << batch_size) - 1 :
                                         (1 << (n - first)) - 1;
      }

    private:
      static constexpr unsigned int volume_field = 4 * n_point_coordinates,
                                    body_field   = volume_field + 1,
                                    n_fields     = body_field + 1;

      // A body is there in up to three parts.
      static constexpr unsigned int tile_size = 64,
                                    most =
                                      3 * SimplexClipper::capacity + batch_size;

      /** What does not fit is copied to the next tile. */
      struct Tile
      {
        alignas(64) double fields[n_fields][tile_size + batch_size];
      };

      unsigned int n = 0;
      Tile         tiles[most / tile_size + 1];
    };

    /** The coordinate of the four corners of simplices by which they are cut.
     */
    using Plane = std::array<Simd, 4>;

    /** How often each corner of simplices counts in the means over a part of
     * them: the sum is the share of the volume. */
    using Weights = std::array<Simd, 4>;

    /** Exchanges two numbers where a mask is true. */
    void
    exchange(const SimdMask &where, Simd &a, Simd &b)
    {
      const Simd old = a;
      a              = select(where, b, a);
      b              = select(where, old, b);
    }

    /** The points of a plane's cut, or numbers that belong to them: p0 to p3
     * are the corners of a simplex in descending order of their coordinate. */
    struct CutPoints
    {
      Simd p0, p1, p2, p3, x, y, z, w;
    };

    /**
     * A plane's cut through simplices. With t_ij, how far it is from corner i
     * inside to the plane on the way to corner j outside, the cuts of edges are
     * x at t_03; y at t_02, or with three corners inside at t_13; z at t_12,
     * with one inside at t_01, with three at t_23; w at t_13. The inner side
     * consists of three simplices, or of the first of them. All of a simplex
     * that is wholly inside is that.
     */
    class Cut
    {
    public:
      explicit Cut(Plane f)
      {
        const auto sort_two =
          [&](SimdMask &swap, const unsigned int i, const unsigned int j) {
            swap         = f[i] < f[j];
            const Simd a = f[i];
            f[i]         = select(swap, f[j], a);
            f[j]         = select(swap, a, f[j]);
          };
        sort_two(swaps[0], 0, 1);
        sort_two(swaps[1], 2, 3);
        sort_two(swaps[2], 0, 2);
        sort_two(swaps[3], 1, 3);
        sort_two(swaps[4], 1, 2);
        has_one               = f[1] < 0;
        has_three             = f[2] >= 0;
        const SimdMask is_cut = (f[0] >= 0) & (f[3] < 0);
        const Simd     one    = broadcast(1), zero{};

        const Simd y_in  = select(has_three, f[1], f[0]),
                   y_out = select(has_three, f[3], f[2]),
                   z_in  = select(has_one, f[0], select(has_three, f[2], f[1])),
                   z_out = select(has_one, f[1], select(has_three, f[3], f[2]));
        // One division for all: they take longest.
        const Simd dx = f[0] - f[3], dy = y_in - y_out, dz = z_in - z_out,
                   dw  = select(has_one | has_three, one, f[1] - f[3]);
        const Simd dxy = dx * dy, dzw = dz * dw;
        const Simd inverse = one / select(is_cut, dxy * dzw, one);
        const Simd of_xy = inverse * dzw, of_zw = inverse * dxy;
        x = min(f[0] * (dy * of_xy), one);
        y = min(y_in * (dx * of_xy), one);
        z = select(is_cut, min(z_in * (dw * of_zw), one), one);
        w = min(f[1] * (dz * of_zw), one);

        shares[0] =
          select(f[0] < 0,
                 zero,
                 select(has_three, z, y * x) * select(has_one, z, one));
        shares[1] = select(has_one,
                           zero,
                           select(has_three, y * (one - z), (one - y) * x * z));
        shares[2] = select(
          has_one,
          zero,
          select(has_three, x * (one - y) * (one - z), (one - x) * z * w));
      }

      /** Numbers of the corners at the points. */
      CutPoints
      points(const Plane &f) const
      {
        CutPoints p{f[0], f[1], f[2], f[3], {}, {}, {}, {}};
        exchange(swaps[0], p.p0, p.p1);
        exchange(swaps[1], p.p2, p.p3);
        exchange(swaps[2], p.p0, p.p2);
        exchange(swaps[3], p.p1, p.p3);
        exchange(swaps[4], p.p1, p.p2);
        const auto between = [](const Simd &in,
                                const Simd &out,
                                const Simd &t) { return in + t * (out - in); };
        p.x                = between(p.p0, p.p3, x);
        p.y                = between(select(has_three, p.p1, p.p0),
                      select(has_three, p.p3, p.p2),
                      y);
        p.z = between(select(has_one, p.p0, select(has_three, p.p2, p.p1)),
                      select(has_one, p.p1, select(has_three, p.p3, p.p2)),
                      z);
        p.w = between(p.p1, p.p3, w);
        return p;
      }

      /** Of the corners of an inner simplex. */
      std::array<Simd, 4>
      part(const CutPoints &p, const unsigned int number) const
      {
        switch (number)
          {
          case 0:
            return {{p.p0,
                     select(has_one, p.z, p.p1),
                     select(has_three, p.p2, p.y),
                     select(has_three, p.z, p.x)}};
          case 1:
            return {{select(has_three, p.p0, p.x), p.p1, p.y, p.z}};
          default:
            return {{select(has_three, p.p0, p.p1),
                     p.x,
                     select(has_three, p.y, p.w),
                     p.z}};
          }
      }

      /** The weights of the corners of the whole. @param inner those of the
       * inner simplices, as parts of these. */
      Weights
      weights(const std::array<Weights, 3> &inner) const
      {
        Weights a, b, c;
        for (unsigned int i = 0; i < 4; ++i)
          {
            a[i] = shares[0] * inner[0][i];
            b[i] = shares[1] * inner[1][i];
            c[i] = shares[2] * inner[2][i];
          }
        const Simd one  = broadcast(1), zero{};
        const Simd at_x = c[1] + select(has_three, zero, a[3] + b[0]),
                   at_y = b[2] + select(has_three, c[2], a[2]),
                   at_z = (b[3] + c[3]) +
                          select(has_three, a[3], select(has_one, a[1], zero)),
                   at_w = select(has_three, zero, c[2]);
        const Simd y_in = (one - y) * at_y, y_out = y * at_y,
                   z_in = (one - z) * at_z, z_out = z * at_z;
        const SimdMask has_two = ~(has_one | has_three);
        Weights        r;
        r[0] = (a[0] + (one - x) * at_x) +
               select(has_three, b[0] + c[0], y_in) +
               select(has_one, z_in, zero);
        r[1] = (b[1] + (one - w) * at_w) + select(has_one, z_out, a[1]) +
               select(has_three, y_in, c[0] + select(has_two, z_in, zero));
        r[2] =
          select(has_three, a[2] + z_in, y_out) + select(has_two, z_out, zero);
        r[3] = (x * at_x + w * at_w) + select(has_three, y_out + z_out, zero);
        exchange(swaps[4], r[1], r[2]);
        exchange(swaps[3], r[1], r[3]);
        exchange(swaps[2], r[0], r[2]);
        exchange(swaps[1], r[2], r[3]);
        exchange(swaps[0], r[0], r[1]);
        return r;
      }

      /** Whether one corner is inside, or three. */
      SimdMask has_one, has_three;

      /** Volumes of the inner simplices over that of the whole. */
      Simd shares[3];

    private:
      /** How the corners were sorted. */
      SimdMask swaps[5];

      /** t_ij of the cuts. */
      Simd x, y, z, w;
    };

    /** The weights of the corners in the part of simplices that is inside of n
     * planes. */
    template <std::size_t n>
    Weights
    inside(const std::array<Plane, n> &planes)
    {
      if constexpr (n == 0)
        {
          const Simd quarter = broadcast(.25);
          return {{quarter, quarter, quarter, quarter}};
        }
      else
        {
          const Cut                cut(planes[0]);
          std::array<CutPoints, n> points;
          std::array<Weights, 3>   inner;
          for (std::size_t k = 1; k < n; ++k)
            points[k] = cut.points(planes[k]);
          for (unsigned int i = 0; i < 3; ++i)
            {
              std::array<Plane, n - 1> others;
              for (std::size_t k = 1; k < n; ++k)
                others[k - 1] = cut.part(points[k], i);
              inner[i] = inside<n - 1>(others);
            }
          return cut.weights(inner);
        }
    }

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
      static_assert(n >= 1 && n <= 3);
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
          if constexpr (n == 3)
            {
              planes[0][c] = select(by_0, x[0], x[1]);
              planes[1][c] = select(by_0 & by_1, x[1], x[2]);
              planes[2][c] = select((by_0 & by_1) & by_2, x[2], x[3]);
            }
        }
      return planes;
    }

    /** The plane that leaves least to do for the others: the one with the
     * fewest corners inside, and of these with the shallowest. */
    struct Choice
    {
      explicit Choice(const std::array<PointBatch, 4> &p)
      {
        // Coordinates may be as large, but then it only decides worse.
        const Simd outside = broadcast(-1e3);
        Simd       keys[4];
        for (unsigned int k = 0; k < 4; ++k)
          {
            const auto key = [&](const Simd &x) {
              return select(x < 0, outside, x);
            };
            keys[k] =
              (key(p[0][k]) + key(p[1][k])) + (key(p[2][k]) + key(p[3][k]));
          }
        const Simd least = min(min(keys[0], keys[1]), min(keys[2], keys[3]));
        is[0]            = keys[0] == least;
        is[1]            = (keys[1] == least) & ~is[0];
        is[2]            = (keys[2] == least) & ~(is[0] | is[1]);
        is[3]            = ~(is[0] | is[1] | is[2]);
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
  } // namespace

  struct SimplexClipper::Workspace
  {
    /** Takes in simplices that are cut by fewer than four planes; the others
     * are returned. */
    unsigned int
    sort_in(const SimplexBatch &simplices, unsigned int lanes);

    /** Adds the parts of simplices that are inside. Lane by lane: a body may be
     * there more than once. */
    void
    accumulate(const SimplexBatch &whole,
               const Weights      &weights,
               unsigned int        lanes);

    /** Cuts simplices by one of four planes. */
    void
    divide(const SimplexBatch &whole, unsigned int lanes);

    /** Replaces simplices by their only corner inside of a plane. */
    void
    cut_corners();

    template <std::size_t n>
    void
    finish(Queue &queue);

    BodyPart parts[no_body + 1];

    /** Simplices by the number of planes that cut them. */
    Queue queues[5];

    /** Those of which a plane leaves only one corner. What is then left of
     * these may be such again: that waits for the next round. */
    Queue        corners[2];
    unsigned int n_rounds = 0;
  };

  unsigned int
  SimplexClipper::Workspace::sort_in(const SimplexBatch &simplices,
                                     const unsigned int  lanes)
  {
    const Kinds kinds = kinds_of(simplices.corners, lanes);
    if (kinds.cut_by[0] != 0)
      accumulate(simplices, inside<0>({}), kinds.cut_by[0]);
    for (unsigned int n = 1; n < 4; ++n)
      queues[n].push(simplices, kinds.cut_by[n]);
    corners[n_rounds % 2].push(simplices, kinds.corner);
    return kinds.cut_by[4];
  }

  void
  SimplexClipper::Workspace::accumulate(const SimplexBatch &whole,
                                        const Weights      &weights,
                                        const unsigned int  lanes)
  {
    Weights w;
    for (unsigned int c = 0; c < 4; ++c)
      w[c] = whole.volume * weights[c];
    std::array<Simd, 8> columns{};
    columns[0] = (w[0] + w[1]) + (w[2] + w[3]);
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      columns[1 + k] =
        (w[0] * whole.corners[0][k] + w[1] * whole.corners[1][k]) +
        (w[2] * whole.corners[2][k] + w[3] * whole.corners[3][k]);
    const std::array<Simd, 8> rows = transpose(columns);
    const SimdMask body = mask_of(lanes) ? whole.body : SimdMask{} + no_body;
    for (unsigned int lane = 0; lane < batch_size; ++lane)
      {
        double *const part = &parts[body[lane]].volume;
        store(load(part) + rows[lane], part);
      }
  }

  void
  SimplexClipper::Workspace::divide(const SimplexBatch &whole,
                                    const unsigned int  lanes)
  {
    const Choice choice(whole.corners);
    const Cut    cut(choice.plane);
    SimplexBatch inner[3];
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      {
        CutPoints points = cut.points({{whole.corners[0][k],
                                        whole.corners[1][k],
                                        whole.corners[2][k],
                                        whole.corners[3][k]}});
        // Exactly in the plane, which they are not cut by again.
        if (k < 4)
          for (Simd *const x : {&points.x, &points.y, &points.z, &points.w})
            *x = select(choice.is[k], Simd{}, *x);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const auto corners = cut.part(points, i);
            for (unsigned int c = 0; c < 4; ++c)
              inner[i].corners[c][k] = corners[c];
          }
      }
    for (unsigned int i = 0; i < 3; ++i)
      {
        inner[i].volume = whole.volume * cut.shares[i];
        inner[i].body   = whole.body;
        // What is not a number has a volume, too.
        sort_in(inner[i], lanes & ~sign_bits(inner[i].volume == 0));
      }
  }

  void
  SimplexClipper::Workspace::cut_corners()
  {
    Queue &now = corners[n_rounds % 2];
    ++n_rounds;
    for (unsigned int i = 0; i < now.size(); i += batch_size)
      {
        SimplexBatch       simplex = now.read(i);
        const unsigned int lanes   = now.lanes(i);
        const CornerPlane  choice(simplex.corners);
        Plane              f = choice.plane;
        SimdMask           is_inside[4];
        for (unsigned int c = 1; c < 4; ++c)
          {
            is_inside[c] = f[c] >= 0;
            exchange(is_inside[c], f[0], f[c]);
          }
        const Simd d1 = f[0] - f[1], d2 = f[0] - f[2], d3 = f[0] - f[3];
        const Simd d12 = d1 * d2, one = broadcast(1);
        const Simd of_12 = f[0] / (d12 * d3), of_3 = of_12 * d3;
        const Simd t[4] = {one,
                           min(of_3 * d2, one),
                           min(of_3 * d1, one),
                           min(of_12 * d12, one)};
        for (unsigned int k = 0; k < n_point_coordinates; ++k)
          {
            auto &p  = simplex.corners;
            Simd  p0 = p[0][k];
            for (unsigned int c = 1; c < 4; ++c)
              exchange(is_inside[c], p0, p[c][k]);
            p[0][k] = p0;
            for (unsigned int c = 1; c < 4; ++c)
              {
                const Simd x = p0 + t[c] * (p[c][k] - p0);
                p[c][k]      = k < 4 ? select(choice.is[k], Simd{}, x) : x;
              }
          }
        simplex.volume *= t[1] * t[2] * t[3];
        sort_in(simplex, lanes & ~sign_bits(simplex.volume == 0));
      }
    now.clear();
  }

  template <std::size_t n>
  void
  SimplexClipper::Workspace::finish(Queue &queue)
  {
    for (unsigned int i = 0; i < queue.size(); i += batch_size)
      {
        const SimplexBatch whole = queue.read(i);
        accumulate(whole,
                   inside<n>(cutting_planes<n>(whole.corners)),
                   queue.lanes(i));
      }
    queue.clear();
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
    workspace->queues[4].push(simplices, workspace->sort_in(simplices, lanes));
  }

  void
  SimplexClipper::clip()
  {
    Queue &whole = workspace->queues[4];
    for (unsigned int i = 0; i < whole.size(); i += batch_size)
      workspace->divide(whole.read(i), whole.lanes(i));
    whole.clear();
    while (workspace->corners[workspace->n_rounds % 2].size() > 0)
      workspace->cut_corners();
    workspace->finish<1>(workspace->queues[1]);
    workspace->finish<2>(workspace->queues[2]);
    workspace->finish<3>(workspace->queues[3]);
  }

  const BodyPart *
  SimplexClipper::parts() const
  {
    return workspace->parts;
  }
} // namespace rift
