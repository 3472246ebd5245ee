#ifndef rift_base_disjoint_sets_h
#define rift_base_disjoint_sets_h

#include <rift/base/check.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rift
{
  /**
   * A partition of the numbers 0 to n - 1 into sets, each of which is named by
   * its smallest member (union-find). At first each number is alone.
   */
  class DisjointSets
  {
  public:
    /** Makes n sets of one number each. */
    explicit DisjointSets(const std::size_t n)
      : parent(n)
    {
      std::iota(parent.begin(), parent.end(), std::uint32_t(0));
    }

    /** The smallest member of the set that `i` belongs to. */
    std::uint32_t
    find(std::uint32_t i)
    {
      rift_check(i < parent.size());
      while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    }

    /** Makes one set of those of `i` and `j`. */
    void
    unite(const std::uint32_t i, const std::uint32_t j)
    {
      const std::uint32_t a = find(i), b = find(j);
      parent[std::max(a, b)] = std::min(a, b);
      rift_check(find(i) == std::min(a, b) && find(j) == std::min(a, b));
    }

  private:
    std::vector<std::uint32_t> parent;
  };
} // namespace rift

#endif
