#include <rift/base/check.h>
#include <rift/contact/space_division.h>

#include <algorithm>

namespace rift
{
  namespace
  {
    constexpr std::uint32_t last_coordinate =
      (std::uint32_t(1) << SpaceDivision::n_levels) - 1;

    /** Puts two zeros between any two of the lowest 21 bits. */
    std::uint64_t
    spread(std::uint64_t bits)
    {
      bits = (bits | bits << 32) & 0x001f00000000ffffu;
      bits = (bits | bits << 16) & 0x001f0000ff0000ffu;
      bits = (bits | bits << 8) & 0x100f00f00f00f00fu;
      bits = (bits | bits << 4) & 0x10c30c30c30c30c3u;
      return (bits | bits << 2) & 0x1249249249249249u;
    }
  } // namespace

  std::uint64_t
  morton_key(const std::array<std::uint32_t, 3> &point)
  {
    return spread(point[0]) | spread(point[1]) << 1 | spread(point[2]) << 2;
  }

  SpaceDivision::SpaceDivision(const Vector3<double>     &lower,
                               const double               edge,
                               std::vector<std::uint64_t> first_keys)
    : origin(lower)
    , inverse_edge(1 / edge)
    , first_keys(std::move(first_keys))
  {
    rift_check(
      std::is_sorted(this->first_keys.begin(), this->first_keys.end()));
  }

  SpaceDivision::GridPoint
  SpaceDivision::grid_point_of(const Vector3<double> &point) const
  {
    GridPoint result;
    for (unsigned int d = 0; d < 3; ++d)
      {
        const double x =
          (point[d] - origin[d]) * inverse_edge * (last_coordinate + 1.);
        // What is not a number goes to the first.
        result[d] = !(x > 0)               ? 0 :
                    !(x < last_coordinate) ? last_coordinate :
                                             static_cast<std::uint32_t>(x);
      }
    return result;
  }

  std::uint64_t
  SpaceDivision::key_of(const Vector3<double> &point) const
  {
    return morton_key(grid_point_of(point));
  }

  int
  SpaceDivision::rank_of_key(const std::uint64_t key) const
  {
    return static_cast<int>(
      std::upper_bound(first_keys.begin(), first_keys.end(), key) -
      first_keys.begin());
  }

  int
  SpaceDivision::rank_of(const Vector3<double> &point) const
  {
    return first_keys.empty() ? 0 : rank_of_key(key_of(point));
  }

  std::vector<int>
  SpaceDivision::ranks_of(const Box &box) const
  {
    const GridPoint lower = grid_point_of(box.lower),
                    upper = grid_point_of(box.upper);
    // No point of a box comes before its lower corner or after its upper one.
    const int first = rank_of_key(morton_key(lower));
    if (first == rank_of_key(morton_key(upper)))
      return {first};
    std::vector<int> ranks;
    collect_ranks(lower, upper, {}, 0, ranks);
    rift_check(!ranks.empty() && std::is_sorted(ranks.begin(), ranks.end()));
    return ranks;
  }

  void
  SpaceDivision::collect_ranks(const GridPoint   &lower,
                               const GridPoint   &upper,
                               const GridPoint   &corner,
                               const unsigned int level,
                               std::vector<int>  &ranks) const
  {
    rift_check(level <= n_levels);
    const std::uint32_t edge = std::uint32_t(1) << (n_levels - level);
    for (unsigned int d = 0; d < 3; ++d)
      if (upper[d] < corner[d] || lower[d] >= corner[d] + edge)
        return;
    const std::uint64_t first_key = morton_key(corner);
    const std::uint64_t n_keys    = std::uint64_t(1) << 3 * (n_levels - level);
    const int           first     = rank_of_key(first_key);
    if (first == rank_of_key(first_key + n_keys - 1))
      {
        // They come in the order of the curve.
        if (ranks.empty() || ranks.back() != first)
          ranks.push_back(first);
        return;
      }
    for (std::uint32_t child = 0; child < 8; ++child)
      {
        GridPoint child_corner = corner;
        for (unsigned int d = 0; d < 3; ++d)
          child_corner[d] += (child >> d & 1) * edge / 2;
        collect_ranks(lower, upper, child_corner, level + 1, ranks);
      }
  }
} // namespace rift
