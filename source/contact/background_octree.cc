#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/base/types.h>
#include <rift/contact/background_octree.h>

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <limits>
#include <map>

namespace rift
{
  namespace
  {
    using Octree = dealii::parallel::distributed::Triangulation<3>;

    static_assert(SpaceDivision::n_levels == P8EST_MAXLEVEL);

    /** So many leaves would be enough for each rank if all were equal. */
    constexpr std::int64_t leaves_per_rank = 16;

    /** A leaf of fewer points is not worth dividing. */
    constexpr std::int64_t least_number = 8;

    /** Of the 18 that p4est has: points may lie at one place. */
    constexpr int largest_level = 16;

    /** The unit cube of the octree in space. */
    struct Cube
    {
      Vector3<double> lower;
      double          edge;
    };

    /** Around the points of all ranks. */
    Cube
    enclose(const std::vector<Vector3<double>> &points,
            const Communicator                 &communicator)
    {
      constexpr double none = std::numeric_limits<double>::lowest();
      Cube             cube{{}, std::numeric_limits<double>::min()};
      for (unsigned int d = 0; d < dim; ++d)
        {
          double upper = none, minus_lower = none;
          for (const Vector3<double> &point : points)
            {
              upper       = std::max(upper, point[d]);
              minus_lower = std::max(minus_lower, -point[d]);
            }
          cube.lower[d] = -communicator.max(minus_lower);
          cube.edge =
            std::max(cube.edge, communicator.max(upper) - cube.lower[d]);
        }
      return cube;
    }

    /** The division of the unit cube as p4est has it. */
    SpaceDivision
    division_of(const Octree &octree, const Cube &cube)
    {
      const auto                *forest = octree.get_p4est();
      std::vector<std::uint64_t> first_keys;
      for (int rank = 1; rank < forest->mpisize; ++rank)
        {
          const auto &first     = forest->global_first_position[rank];
          const bool  is_at_end = first.p.which_tree > 0;
          first_keys.push_back(
            is_at_end ? std::uint64_t(1) << 3 * SpaceDivision::n_levels :
                        morton_key({{static_cast<std::uint32_t>(first.x),
                                     static_cast<std::uint32_t>(first.y),
                                     static_cast<std::uint32_t>(first.z)}}));
        }
      return {cube.lower, cube.edge, first_keys};
    }

    /** Places on the curve of the points that lie in the part of this rank,
     * ascending. */
    std::vector<std::uint64_t>
    own_keys(const std::vector<Vector3<double>> &points,
             const SpaceDivision                &division,
             const Communicator                 &communicator)
    {
      std::map<int, std::vector<std::uint64_t>> keys;
      for (const Vector3<double> &point : points)
        keys[division.rank_of(point)].push_back(division.key_of(point));
      std::vector<std::uint64_t> result;
      for (const auto &[rank, of_rank] : communicator.exchange(keys))
        result.insert(result.end(), of_rank.begin(), of_rank.end());
      std::sort(result.begin(), result.end());
      return result;
    }

    /** The number of points in a leaf. */
    std::int64_t
    count_points(const Octree::cell_iterator      &leaf,
                 const std::vector<std::uint64_t> &keys)
    {
      const SpaceDivision unit_cube({}, 1, {});
      const auto          centre = leaf->center();
      const unsigned int  n_bits =
        3 *
        (SpaceDivision::n_levels - static_cast<unsigned int>(leaf->level()));
      const std::uint64_t n_keys = std::uint64_t(1) << n_bits;
      const std::uint64_t first =
        unit_cube.key_of({{centre[0], centre[1], centre[2]}}) & ~(n_keys - 1);
      return std::lower_bound(keys.begin(), keys.end(), first + n_keys) -
             std::lower_bound(keys.begin(), keys.end(), first);
    }

    /** Whether each key is in one of the leaves of this rank. */
    bool
    have_leaves(const Octree &octree, const std::vector<std::uint64_t> &keys)
    {
      std::int64_t n = 0;
      for (const auto &leaf : octree.active_cell_iterators())
        if (leaf->is_locally_owned())
          n += count_points(leaf, keys);
      return n == static_cast<std::int64_t>(keys.size());
    }

    /** Marks the leaves in which there are too many points. */
    bool
    mark_full_leaves(Octree                           &octree,
                     const std::vector<std::uint64_t> &keys,
                     const std::int64_t                largest_number)
    {
      bool any = false;
      for (const auto &leaf : octree.active_cell_iterators())
        if (leaf->is_locally_owned() && leaf->level() < largest_level &&
            count_points(leaf, keys) > largest_number)
          {
            leaf->set_refine_flag();
            any = true;
          }
      return any;
    }

    /** Gives each rank about as many points. */
    void
    balance(Octree &octree, const std::vector<std::uint64_t> &keys)
    {
      // deal.II adds 1000 to the weight of each leaf.
      const auto connection = octree.signals.cell_weight.connect(
        [&keys](const Octree::cell_iterator &leaf, const Octree::CellStatus) {
          return static_cast<unsigned int>(
            std::min<std::int64_t>(1000 * count_points(leaf, keys),
                                   std::numeric_limits<int>::max()));
        });
      octree.repartition();
      connection.disconnect();
    }
  } // namespace

  SpaceDivision
  divide_space(const std::vector<Vector3<double>> &points,
               const Communicator                 &communicator)
  {
    const Cube         cube = enclose(points, communicator);
    const std::int64_t largest_number =
      std::max(least_number,
               communicator.sum(static_cast<std::int64_t>(points.size())) /
                 (leaves_per_rank * communicator.size()));
    Octree octree(communicator.mpi(),
                  dealii::Triangulation<3>::none,
                  Octree::no_automatic_repartitioning);
    dealii::GridGenerator::hyper_cube(octree);
    while (true)
      {
        const std::vector<std::uint64_t> keys =
          own_keys(points, division_of(octree, cube), communicator);
        rift_check(have_leaves(octree, keys));
        const bool is_full = mark_full_leaves(octree, keys, largest_number);
        if (!communicator.any(is_full))
          {
            balance(octree, keys);
            return division_of(octree, cube);
          }
        octree.execute_coarsening_and_refinement();
        octree.repartition();
      }
  }
} // namespace rift
