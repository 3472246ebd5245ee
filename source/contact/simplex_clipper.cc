#include <rift/base/check.h>
#include <rift/contact/simplex_clipper.h>

#include <limits>

namespace rift
{
  namespace
  {
    /** Of a chunk, and a place for lanes that are none. */
    constexpr unsigned int no_body = SimplexClipper::capacity;

    /** Simplices that wait to be cut. A body is in it at most
     * `most_per_body` times. */
    template <unsigned int most_per_body>
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
        const LanePacking packed(lanes);
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            store(packed(simplices.corners[c][k]), &corners[c][k][n]);
        store(packed(simplices.volume), &volumes[n]);
        store(packed((Simd)simplices.body), &bodies[n]);
        n += __builtin_popcount(lanes);
        rift_check(n + batch_size <= length);
      }

      SimplexBatch
      read(const unsigned int first) const
      {
        SimplexBatch result;
        for (unsigned int c = 0; c < 4; ++c)
          for (unsigned int k = 0; k < n_point_coordinates; ++k)
            result.corners[c][k] = load(&corners[c][k][first]);
        result.volume = load(&volumes[first]);
        result.body   = (SimdMask)load(&bodies[first]);
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
      static constexpr unsigned int length =
        most_per_body * SimplexClipper::capacity + 2 * batch_size;

      unsigned int n = 0;
      alignas(64) double corners[4][n_point_coordinates][length];
      alignas(64) double volumes[length];
      alignas(64) double bodies[length];
    };

    /** How planes cut simplices: bits of lanes. */
    struct Kinds
    {
      /** Not cut; cut by one plane; cut by more. What is wholly outside of a
       * plane is none. */
      unsigned int whole, last, more;
    };

    Kinds
    kinds_of(const std::array<PointBatch, 4> &p, const unsigned int lanes)
    {
      SimdMask outside{}, some[4];
      for (unsigned int k = 0; k < 4; ++k)
        {
          const SimdMask a = (SimdMask)p[0][k], b = (SimdMask)p[1][k],
                         c = (SimdMask)p[2][k], d = (SimdMask)p[3][k];
          outside |= a & b & c & d;
          some[k] = a | b | c | d;
        }
      const SimdMask cut     = some[0] | some[1] | some[2] | some[3];
      const SimdMask by_more = (some[0] & some[1]) | (some[2] & some[3]) |
                               ((some[0] | some[1]) & (some[2] | some[3]));
      const unsigned int is_cut = sign_bits(cut) & lanes & ~sign_bits(outside);
      const unsigned int more   = sign_bits(by_more) & is_cut;
      return {lanes & ~sign_bits(cut), is_cut & ~more, more};
    }

    /** Exchanges two numbers where a mask is true. */
    void
    exchange(const SimdMask &where, Simd &a, Simd &b)
    {
      const Simd old = a;
      a              = select(where, b, a);
      b              = select(where, old, b);
    }

    /**
     * A plane's cut through simplices. p0 to p3 are the corners in descending
     * order of their distance to the plane, t_ij is how far it is from corner i
     * inside to the plane, on the way to corner j outside.
     */
    class Cut
    {
    public:
      /** @param f the coordinates of the four corners: at least one is
       * negative, and one is not. */
      explicit Cut(std::array<Simd, 4> f)
      {
        for (unsigned int i = 0; i < 5; ++i)
          {
            Simd &a = f[exchanges[i][0]], &b = f[exchanges[i][1]];
            swaps[i]     = a < b;
            const Simd x = a;
            a            = select(swaps[i], b, a);
            b            = select(swaps[i], x, b);
          }
        has_one           = f[1] < 0;
        has_three         = f[2] >= 0;
        const auto cut_at = [](const Simd &in, const Simd &out) {
          return in / (in - out);
        };
        x = cut_at(f[0], f[3]);
        y =
          cut_at(select(has_three, f[1], f[0]), select(has_three, f[3], f[2]));
        z = cut_at(select(has_one, f[0], select(has_three, f[2], f[1])),
                   select(has_one, f[1], select(has_three, f[3], f[2])));
        w = cut_at(f[1], f[3]);

        const Simd one = broadcast(1), zero{};
        shares[0]      = select(has_three, z, y * x) * select(has_one, z, one);
        shares[1]      = select(has_one,
                           zero,
                           select(has_three, y * (one - z), (one - y) * x * z));
        shares[2]      = select(
          has_one,
          zero,
          select(has_three, x * (one - y) * (one - z), (one - x) * z * w));
      }

      /** Brings numbers of the corners into the order of p0 to p3. */
      void
      sort(Simd &p0, Simd &p1, Simd &p2, Simd &p3) const
      {
        exchange(swaps[0], p0, p1);
        exchange(swaps[1], p2, p3);
        exchange(swaps[2], p0, p2);
        exchange(swaps[3], p1, p3);
        exchange(swaps[4], p1, p2);
      }

      /** The inverse of sort(). */
      void
      unsort(Simd &p0, Simd &p1, Simd &p2, Simd &p3) const
      {
        exchange(swaps[4], p1, p2);
        exchange(swaps[3], p1, p3);
        exchange(swaps[2], p0, p2);
        exchange(swaps[1], p2, p3);
        exchange(swaps[0], p0, p1);
      }

      static constexpr unsigned int exchanges[5][2] = {{0, 1},
                                                       {2, 3},
                                                       {0, 2},
                                                       {1, 3},
                                                       {1, 2}};

      SimdMask swaps[5];

      /** Whether one corner is inside, or three; else there are two. */
      SimdMask has_one, has_three;

      /** t_03; t_02, of three inside t_13; t_12, of one inside t_01, of three
       * t_23; and t_13. */
      Simd x, y, z, w;

      /** Volumes of the three simplices inside, over that of the whole; of one
       * corner inside there is but the first. */
      Simd shares[3];
    };

    Simd
    between(const Simd &in, const Simd &out, const Simd &t)
    {
      return in + t * (out - in);
    }

    /** The coordinate of the only plane that cuts. */
    std::array<Simd, 4>
    last_plane(const std::array<PointBatch, 4> &p)
    {
      std::array<Simd, 4> f{{p[0][0], p[1][0], p[2][0], p[3][0]}};
      for (unsigned int k = 1; k < 4; ++k)
        {
          const SimdMask is_cut = ((SimdMask)p[0][k] | (SimdMask)p[1][k] |
                                   (SimdMask)p[2][k] | (SimdMask)p[3][k]) < 0;
          for (unsigned int c = 0; c < 4; ++c)
            f[c] = select(is_cut, p[c][k], f[c]);
        }
      return f;
    }
  } // namespace

  struct SimplexClipper::Workspace
  {
    /** Adds volumes and moments, lane by lane: a body may be there more than
     * once. */
    void
    accumulate(const Simd       &volume,
               const PointBatch &moment,
               const SimdMask   &body)
    {
      const std::array<Simd, 8> rows = transpose({{volume,
                                                   moment[0],
                                                   moment[1],
                                                   moment[2],
                                                   moment[3],
                                                   moment[4],
                                                   Simd{},
                                                   Simd{}}});
      for (unsigned int lane = 0; lane < batch_size; ++lane)
        {
          double *const part = &parts[body[lane]].volume;
          store(load(part) + rows[lane], part);
        }
    }

    void
    divide(const SimplexBatch &whole, unsigned int lanes, Queue<1> *children);

    void
    finish(const SimplexBatch &whole, unsigned int lanes);

    template <unsigned int level>
    void
    process(Queue<1> &queue);

    void
    flush();

    BodyPart parts[no_body + 1];

    /** Simplices that are cut by more than one plane: the bodies, then the
     * children of those of the level before. */
    Queue<1> bodies, children[2][3];

    /** Those that are cut by one plane. */
    Queue<9> last;
  };

  /** Adds simplices that a single plane cuts, without making any. */
  void
  SimplexClipper::Workspace::finish(const SimplexBatch &whole,
                                    const unsigned int  lanes)
  {
    const auto &p = whole.corners;
    const Cut   cut(last_plane(p));
    const auto &v   = cut.shares;
    const Simd  one = broadcast(1), zero{};

    // How often each corner of the inner simplices is there, by their volumes.
    const Simd of_x = select(cut.has_three, zero, v[0] + v[1]) + v[2],
               of_y = select(cut.has_three, v[2], v[0]) + v[1],
               of_z = select(cut.has_one | cut.has_three, v[0], zero) +
                      (v[1] + v[2]),
               of_w = select(cut.has_three, zero, v[2]);
    // And thus the corners of the whole.
    const Simd x_in = (one - cut.x) * of_x, x_out = cut.x * of_x,
               y_in = (one - cut.y) * of_y, y_out = cut.y * of_y,
               z_in = (one - cut.z) * of_z, z_out = cut.z * of_z,
               w_in        = select(cut.has_one, zero, (one - cut.w) * of_w),
               w_out       = select(cut.has_one, zero, cut.w * of_w);
    const SimdMask has_two = ~(cut.has_one | cut.has_three);
    Simd           w0 = v[0] + select(cut.has_three, v[1] + v[2], y_in) + x_in +
              select(cut.has_one, z_in, zero);
    Simd w1 = select(cut.has_one, z_out, v[0] + v[1]) +
              select(cut.has_three, y_in, select(has_two, v[2] + z_in, zero)) +
              w_in;
    Simd w2 =
      select(cut.has_three, v[0] + z_in, y_out) + select(has_two, z_out, zero);
    Simd w3 = x_out + w_out + select(cut.has_three, y_out + z_out, zero);
    cut.unsort(w0, w1, w2, w3);

    const Simd quarter = .25 * whole.volume;
    w0 *= quarter;
    w1 *= quarter;
    w2 *= quarter;
    w3 *= quarter;
    PointBatch moment;
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      moment[k] = (w0 * p[0][k] + w1 * p[1][k]) + (w2 * p[2][k] + w3 * p[3][k]);
    accumulate(whole.volume * (v[0] + v[1] + v[2]),
               moment,
               mask_of(lanes) ? whole.body : SimdMask{} + no_body);
  }

  namespace
  {
    /** The planes that leave least to do for the others: those with the fewest
     * corners inside, and of these with the shallowest. */
    struct Choice
    {
      explicit Choice(const std::array<PointBatch, 4> &p)
      {
        // Coordinates may be large, but then their sums only decide worse.
        constexpr double outside = -1e3;
        constexpr double largest = std::numeric_limits<double>::max();
        Simd             keys[4];
        for (unsigned int k = 0; k < 4; ++k)
          {
            SimdMask is_cut{};
            Simd     key{};
            for (unsigned int c = 0; c < 4; ++c)
              {
                const SimdMask is_outside = p[c][k] < 0;
                key += select(is_outside, broadcast(outside), p[c][k]);
                is_cut |= is_outside;
              }
            keys[k] = select(is_cut, key, broadcast(largest));
          }
        const Simd least = min(min(keys[0], keys[1]), min(keys[2], keys[3]));
        is[0]            = keys[0] == least;
        is[1]            = (keys[1] == least) & ~is[0];
        is[2]            = (keys[2] == least) & ~(is[0] | is[1]);
        is[3]            = ~(is[0] | is[1] | is[2]);
        for (unsigned int c = 0; c < 4; ++c)
          f[c] =
            select(is[0],
                   p[c][0],
                   select(is[1], p[c][1], select(is[2], p[c][2], p[c][3])));
      }

      /** Whether it is the plane of that coordinate. */
      SimdMask is[4];

      /** The coordinates of the corners. */
      std::array<Simd, 4> f;
    };
  } // namespace

  /** Cuts simplices by one of their planes. What is left of them is added,
   * waits for its last cut or goes to the children. */
  void
  SimplexClipper::Workspace::divide(const SimplexBatch &whole,
                                    const unsigned int  lanes,
                                    Queue<1>           *children)
  {
    const Choice plane(whole.corners);
    const Cut    cut(plane.f);

    SimplexBatch parts[3];
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      {
        Simd p0 = whole.corners[0][k], p1 = whole.corners[1][k],
             p2 = whole.corners[2][k], p3 = whole.corners[3][k];
        cut.sort(p0, p1, p2, p3);
        // Exactly in the plane, which they are not cut by again.
        const auto point = [&](const Simd &in, const Simd &out, const Simd &t) {
          const Simd value = between(in, out, t);
          return k < 4 ? select(plane.is[k], Simd{}, value) : value;
        };
        const Simd x = point(p0, p3, cut.x);
        const Simd y = point(select(cut.has_three, p1, p0),
                             select(cut.has_three, p3, p2),
                             cut.y);
        const Simd z =
          point(select(cut.has_one, p0, select(cut.has_three, p2, p1)),
                select(cut.has_one, p1, select(cut.has_three, p3, p2)),
                cut.z);
        const Simd w = point(p1, p3, cut.w);

        parts[0].corners[0][k] = p0;
        parts[0].corners[1][k] = select(cut.has_one, z, p1);
        parts[0].corners[2][k] = select(cut.has_three, p2, y);
        parts[0].corners[3][k] = select(cut.has_three, z, x);
        parts[1].corners[0][k] = select(cut.has_three, p0, x);
        parts[1].corners[1][k] = p1;
        parts[1].corners[2][k] = y;
        parts[1].corners[3][k] = z;
        parts[2].corners[0][k] = select(cut.has_three, p0, p1);
        parts[2].corners[1][k] = x;
        parts[2].corners[2][k] = select(cut.has_three, y, w);
        parts[2].corners[3][k] = z;
      }

    unsigned int       any_whole = 0;
    Simd               volume{};
    PointBatch         moment{};
    const unsigned int has_more = lanes & ~sign_bits(cut.has_one);
    for (unsigned int i = 0; i < 3; ++i)
      {
        parts[i].volume = whole.volume * cut.shares[i];
        parts[i].body   = whole.body;
        // What is not a number is a volume, too.
        const Kinds kinds = kinds_of(parts[i].corners,
                                     (i == 0 ? lanes : has_more) &
                                       ~sign_bits(parts[i].volume == 0));
        last.push(parts[i], kinds.last);
        if (children != nullptr)
          children[i].push(parts[i], kinds.more);
        if (kinds.whole == 0)
          continue;
        any_whole |= kinds.whole;
        const Simd v = select(mask_of(kinds.whole), parts[i].volume, Simd{});
        volume += v;
        const auto &p = parts[i].corners;
        for (unsigned int k = 0; k < n_point_coordinates; ++k)
          moment[k] +=
            select(mask_of(kinds.whole),
                   (.25 * v) * ((p[0][k] + p[1][k]) + (p[2][k] + p[3][k])),
                   Simd{});
      }
    if (any_whole != 0)
      accumulate(volume,
                 moment,
                 mask_of(lanes) ? whole.body : SimdMask{} + no_body);
  }

  template <unsigned int level>
  void
  SimplexClipper::Workspace::process(Queue<1> &queue)
  {
    Queue<1> *const next = level < 2 ? children[level] : nullptr;
    for (unsigned int i = 0; i < queue.size(); i += batch_size)
      divide(queue.read(i), queue.lanes(i), next);
    queue.clear();
    if constexpr (level == 0)
      flush();
    if constexpr (level < 2)
      for (unsigned int i = 0; i < 3; ++i)
        {
          process<level + 1>(next[i]);
          if constexpr (level == 0)
            flush();
        }
  }

  void
  SimplexClipper::Workspace::flush()
  {
    for (unsigned int i = 0; i < last.size(); i += batch_size)
      finish(last.read(i), last.lanes(i));
    last.clear();
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
    const Kinds kinds = kinds_of(simplices.corners, lanes);
    workspace->bodies.push(simplices, kinds.more);
    workspace->last.push(simplices, kinds.last);
    if (kinds.whole == 0)
      return;
    const auto &p = simplices.corners;
    PointBatch  moment;
    for (unsigned int k = 0; k < n_point_coordinates; ++k)
      moment[k] =
        (.25 * simplices.volume) * ((p[0][k] + p[1][k]) + (p[2][k] + p[3][k]));
    workspace->accumulate(simplices.volume,
                          moment,
                          mask_of(kinds.whole) ? simplices.body :
                                                 SimdMask{} + no_body);
  }

  void
  SimplexClipper::clip()
  {
    workspace->process<0>(workspace->bodies);
  }

  const BodyPart *
  SimplexClipper::parts() const
  {
    return workspace->parts;
  }
} // namespace rift
