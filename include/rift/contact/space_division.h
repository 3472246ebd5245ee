#ifndef rift_contact_space_division_h
#define rift_contact_space_division_h

#include <rift/contact/box_index.h>

namespace rift
{
  /**
   * Which rank owns which point of space: a cube is cut into 2^57 small ones
   * in the order of Morton's curve, and each rank owns a stretch of it. Points
   * outside go to the nearest small cube.
   */
  class SpaceDivision
  {
  public:
    /** The cube is cut into 2^n_levels along each edge. */
    static constexpr unsigned int n_levels = 19;

    /** All belongs to rank 0. */
    SpaceDivision() = default;

    /**
     * @param lower corner of the cube, m.
     * @param edge m.
     * @param first_keys where the ranks after the first begin, not descending.
     */
    SpaceDivision(const Vector3<double>     &lower,
                  double                     edge,
                  std::vector<std::uint64_t> first_keys);

    /** The rank that owns a point, m. */
    int
    rank_of(const Vector3<double> &point) const;

    /** The ranks that own points of a box, ascending. */
    std::vector<int>
    ranks_of(const Box &box) const;

    /** Place of a point on the curve. */
    std::uint64_t
    key_of(const Vector3<double> &point) const;

  private:
    using GridPoint = std::array<std::uint32_t, 3>;

    GridPoint
    grid_point_of(const Vector3<double> &point) const;

    int
    rank_of_key(std::uint64_t key) const;

    void
    collect_ranks(const GridPoint  &lower,
                  const GridPoint  &upper,
                  const GridPoint  &corner,
                  unsigned int      level,
                  std::vector<int> &ranks) const;

    Vector3<double>            origin{};
    double                     inverse_edge = 0;
    std::vector<std::uint64_t> first_keys;
  };

  /** Place on Morton's curve of a small cube, x in the lowest bit. */
  std::uint64_t
  morton_key(const std::array<std::uint32_t, 3> &point);
} // namespace rift

#endif
