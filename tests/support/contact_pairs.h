#ifndef rift_tests_support_contact_pairs_h
#define rift_tests_support_contact_pairs_h

#include <rift/contact/contact_pair.h>

#include <cmath>
#include <random>
#include <vector>

// Random pairs of tetrahedra of all kinds. The same on all machines.
namespace rift::test
{
  inline double
  volume(const Tetrahedron &t)
  {
    return dot(t[1] - t[0], cross(t[2] - t[0], t[3] - t[0])) / 6;
  }

  enum class PairKind
  {
    deep,
    shallow,
    pressed,
    identical,
    tip_in_face,
    parted
  };

  constexpr PairKind all_pair_kinds[] = {PairKind::deep,
                                         PairKind::shallow,
                                         PairKind::pressed,
                                         PairKind::identical,
                                         PairKind::tip_in_face,
                                         PairKind::parted};

  class PairGenerator
  {
  public:
    explicit PairGenerator(const unsigned int seed)
      : engine(seed)
    {
    }

    double
    number(const double lower, const double upper)
    {
      return lower + (upper - lower) * (engine() / 4294967296.);
    }

    Vector3<double>
    vector(const double size)
    {
      return {{number(-size, size), number(-size, size), number(-size, size)}};
    }

    /** One of size 1 that is not flat. */
    Tetrahedron
    tetrahedron()
    {
      while (true)
        {
          Tetrahedron t{{vector(1), vector(1), vector(1), vector(1)}};
          if (volume(t) < 0)
            std::swap(t[0], t[1]);
          if (volume(t) > .05)
            return t;
        }
    }

    std::array<Tetrahedron, 2>
    pair(const PairKind kind)
    {
      const Tetrahedron a = tetrahedron();
      switch (kind)
        {
        case PairKind::deep:
          {
            Tetrahedron           b     = tetrahedron();
            const Vector3<double> shift = vector(.5);
            for (Vector3<double> &x : b)
              x += shift;
            return {{a, b}};
          }
        case PairKind::shallow:
          return {{a, beside(a, false, 1e-6)}};
        case PairKind::pressed:
          return {{grown(a, 1e-3), grown(beside(a, true, 0), 1e-3)}};
        case PairKind::identical:
          return {{a, a}};
        case PairKind::tip_in_face:
          return {{a, beside(a, false, number(.01, .3))}};
        default:
          {
            Tetrahedron           b     = tetrahedron();
            const Vector3<double> shift = {{number(1.5, 3), number(-1, 1), 0}};
            for (Vector3<double> &x : b)
              x += shift;
            return {{a, b}};
          }
        }
    }

    CellMotion
    moving(const Tetrahedron &t)
    {
      return {t, {{vector(1), vector(1), vector(1), vector(1)}}};
    }

  private:
    /** Behind a face of another one: on the face with its own, or into it with
     * a corner. */
    Tetrahedron
    beside(const Tetrahedron &a, const bool is_flat, const double depth)
    {
      const unsigned int     c = engine() % 4;
      const Vector3<double> &p = a[(c + 1) % 4], &q = a[(c + 2) % 4],
                            &r = a[(c + 3) % 4];
      Vector3<double> n        = cross(q - p, r - p);
      n                        = (1 / norm(n)) * n;
      if (dot(a[c] - p, n) > 0)
        n = -1. * n;
      const Vector3<double> middle = (1. / 3) * (p + q + r);
      Tetrahedron           b;
      if (is_flat)
        b = {{p, q, r, middle + number(.5, 1.5) * n + vector(.2)}};
      else
        {
          const Vector3<double> tip = middle - depth * n;
          b                         = {{tip,
                                        tip + number(.5, 1.5) * n + vector(.4),
                                        tip + number(.5, 1.5) * n + vector(.4),
                                        tip + number(.5, 1.5) * n + vector(.4)}};
        }
      if (volume(b) < 0)
        std::swap(b[1], b[2]);
      return volume(b) > .01 ? b : beside(a, is_flat, depth);
    }

    static Tetrahedron
    grown(const Tetrahedron &t, const double share)
    {
      Vector3<double> centre{};
      for (const Vector3<double> &x : t)
        centre += .25 * x;
      Tetrahedron result;
      for (unsigned int c = 0; c < 4; ++c)
        result[c] = t[c] + share * (t[c] - centre);
      return result;
    }

    std::mt19937 engine;
  };

  /** Many pairs, cell by cell. */
  struct PairList
  {
    void
    add(PairGenerator &make, const PairKind kind)
    {
      const auto both = make.pair(kind);
      pairs.push_back({static_cast<std::uint32_t>(cells.size()),
                       static_cast<std::uint32_t>(cells.size() + 1)});
      for (const Tetrahedron &t : both)
        cells.push_back(pack(make.moving(t)));
    }

    std::vector<PackedMotion> cells;
    std::vector<CellPair>     pairs;
  };

  /** The pairs with friction and damping, some of which have a past. */
  inline std::vector<ContactPair>
  contact_pairs(const PairList &list, PairGenerator &make)
  {
    std::vector<ContactPair> result;
    for (const CellPair &cells : list.pairs)
      {
        ContactPair pair{cells,
                         {1e9,
                          make.number(-.2, .8) > 0 ? .5 : 0,
                          make.number(-.2, .8) > 0 ? .1 : 0,
                          1e3},
                         {}};
        if (make.number(0, 1) < .5)
          {
            pair.memory.initial_potential = make.number(0, 1e-3);
            pair.memory.slip              = make.vector(1e-3);
            pair.memory.stiffness         = make.number(0, 1e9);
            pair.memory.damping_force     = make.number(-1e3, 1e3);
          }
        result.push_back(pair);
      }
    return result;
  }
} // namespace rift::test

#endif
