#include <rift/bonds/node_star.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rift
{
  void
  cells_at_node(const Topology        &topology,
                const NodeIndex        node,
                std::vector<StarCell> &cells)
  {
    cells.clear();
    const VertexIndex         vertex = topology.node_vertices[node];
    const CellIndex *const    first  = topology.vertex_cells_first(vertex);
    const CellIndex *const    last   = topology.vertex_cells_last(vertex);
    const std::uint8_t *const corner = topology.vertex_corners_first(vertex);
    for (std::ptrdiff_t i = 0; i < last - first; ++i)
      if (topology.node(first[i], corner[i]) == node)
        cells.push_back({first[i], corner[i]});
  }

  std::vector<StarCell>
  cells_at_node(const Topology &topology, const NodeIndex node)
  {
    std::vector<StarCell> cells;
    cells_at_node(topology, node, cells);
    return cells;
  }

  namespace
  {
    /** The side of the plane on which a cell is; none: the plane passes. */
    enum class Side : int
    {
      below = -1,
      none  = 0,
      above = 1
    };

    Side
    opposite(const Side side)
    {
      return static_cast<Side>(-static_cast<int>(side));
    }

    /** A face of the star that parts two of its cells. */
    struct Link
    {
      FaceIndex       face;
      unsigned int    cells[2];
      Vector3<double> area_vector;
      bool            is_cut;

      /** Area that a cut costs, and how much of it a flow has used. */
      double capacity, flow;
    };

    /** The star of a node and the sides of its cells. */
    struct Star
    {
      std::vector<StarCell> cells;
      std::vector<Side>     sides;

      /** Sum of the distances of the three other corners from the plane over
       * the longest edge. */
      std::vector<double> heights;
      std::vector<Link>   links;

      bool
      has(const Side side) const
      {
        return std::find(sides.begin(), sides.end(), side) != sides.end();
      }
    };

    void
    place_cells(Star                  &star,
                const Topology        &topology,
                const State           &state,
                const Vector3<double> &normal)
    {
      for (const auto &[cell, here] : star.cells)
        {
          const Vector3<double> origin =
            state.reference[topology.node(cell, here)].vector();
          double lowest = std::numeric_limits<double>::max(), highest = -lowest,
                 sum = 0, longest = 0;
          for (unsigned int c = 0; c < n_corners; ++c)
            if (c != here)
              {
                const Vector3<double> edge =
                  state.reference[topology.node(cell, c)].vector() - origin;
                const double height = dot(edge, normal);
                lowest              = std::min(lowest, height);
                highest             = std::max(highest, height);
                sum += height;
                longest = std::max(longest, norm(edge));
              }
          const double rounding = 1e-6 * longest;
          star.heights.push_back(sum / longest);
          star.sides.push_back(lowest >= -rounding ? Side::above :
                               highest <= rounding ? Side::below :
                                                     Side::none);
        }
    }

    void
    find_links(Star                                 &star,
               const Topology                       &topology,
               const ReferenceCellData              &reference,
               const std::function<bool(FaceIndex)> &is_breakable)
    {
      for (unsigned int i = 0; i < star.cells.size(); ++i)
        for (unsigned int local = 0; local < n_corners; ++local)
          {
            const auto [cell, here] = star.cells[i];
            const FaceIndex index   = topology.cell_faces[cell][local];
            if (index == invalid_index || local == here ||
                topology.faces[index].cells[0] != cell)
              continue;
            const CellIndex behind = topology.faces[index].cells[1];
            const auto      other =
              std::lower_bound(star.cells.begin(),
                               star.cells.end(),
                               behind,
                               [](const StarCell &c, const CellIndex index) {
                                 return c.cell < index;
                               });
            if (other == star.cells.end() || other->cell != behind)
              continue;
            const Vector3<double> area =
              reference_area_vector(reference, cell, local);
            const bool is_cut =
              topology.face_states[index] != FaceState::intact;
            const double capacity =
              is_cut              ? 0. :
              is_breakable(index) ? norm(area) :
                                    std::numeric_limits<double>::infinity();
            star.links.push_back(
              {index,
               {i, static_cast<unsigned int>(other - star.cells.begin())},
               area,
               is_cut,
               capacity,
               0});
          }
    }

    /**
     * Puts the cells beside faces that are cut already on their own sides. Where
     * all cells lie on one side of the plane, as at the surface of another
     * crack, these faces alone decide.
     *
     * @return whether there are such faces.
     */
    bool
    carry_cracks_on(Star &star, const Vector3<double> &normal)
    {
      std::vector<int> votes(star.cells.size(), 0);
      bool             any = false;
      for (const Link &link : star.links)
        {
          constexpr double smallest_cosine = .2;
          const double     along           = dot(link.area_vector, normal);
          if (!link.is_cut ||
              std::abs(along) < smallest_cosine * norm(link.area_vector))
            continue;
          votes[link.cells[0]] -= along > 0 ? 1 : -1;
          votes[link.cells[1]] += along > 0 ? 1 : -1;
          any = true;
        }
      if (any && (!star.has(Side::above) || !star.has(Side::below)))
        std::fill(star.sides.begin(), star.sides.end(), Side::none);
      for (std::size_t i = 0; i < votes.size(); ++i)
        if (votes[i] != 0 && star.sides[i] == Side::none)
          star.sides[i] = votes[i] > 0 ? Side::above : Side::below;
      return any;
    }

    /** Gives a side without cells the one that reaches farthest to it; false
     * where none does by some tenth of its size. */
    bool
    fill_side(Star &star, const Side side)
    {
      if (star.has(side))
        return true;
      constexpr double least = .3;
      std::size_t      best  = 0;
      const double     sign  = static_cast<int>(side);
      for (std::size_t i = 1; i < star.cells.size(); ++i)
        if (sign * star.heights[i] > sign * star.heights[best])
          best = i;
      if (sign * star.heights[best] <= least ||
          star.sides[best] == opposite(side))
        return false;
      star.sides[best] = side;
      return true;
    }

    /**
     * The cells that remain connected to those above when the smallest cut has
     * been made: the largest flow from above to below through the links, by
     * augmenting paths.
     *
     * @return by cell whether it can be reached; nothing if no cut is finite.
     */
    std::optional<std::vector<bool>>
    smallest_cut(Star &star)
    {
      const std::size_t n    = star.cells.size();
      const auto        room = [](const Link &link, const unsigned int from) {
        const double used = link.cells[0] == from ? link.flow : -link.flow;
        return link.capacity - used;
      };
      for (;;)
        {
          std::vector<bool>         is_reached(n, false);
          std::vector<Link *>       by(n, nullptr);
          std::vector<unsigned int> queue;
          for (unsigned int i = 0; i < n; ++i)
            if (star.sides[i] == Side::above)
              {
                is_reached[i] = true;
                queue.push_back(i);
              }
          std::size_t end = n;
          for (std::size_t q = 0; q < queue.size() && end == n; ++q)
            for (Link &link : star.links)
              {
                const unsigned int from = queue[q];
                if (link.cells[0] != from && link.cells[1] != from)
                  continue;
                const unsigned int to =
                  link.cells[link.cells[0] == from ? 1 : 0];
                if (is_reached[to] ||
                    !(room(link, from) > 1e-9 * norm(link.area_vector)))
                  continue;
                is_reached[to] = true;
                by[to]         = &link;
                queue.push_back(to);
                if (star.sides[to] == Side::below)
                  {
                    end = to;
                    break;
                  }
              }
          if (end == n)
            return is_reached;
          const auto walk = [&](const auto &visit) {
            for (std::size_t to = end; by[to] != nullptr;)
              {
                const unsigned int from =
                  by[to]->cells[by[to]->cells[0] == to ? 1 : 0];
                visit(*by[to], from);
                to = from;
              }
          };
          double least = std::numeric_limits<double>::infinity();
          walk([&](const Link &link, const unsigned int from) {
            least = std::min(least, room(link, from));
          });
          if (least == std::numeric_limits<double>::infinity())
            return {};
          walk([least](Link &link, const unsigned int from) {
            link.flow += link.cells[0] == from ? least : -least;
          });
        }
    }
  } // namespace

  std::optional<StarCut>
  cut_star(const Topology                       &topology,
           const ReferenceCellData              &reference,
           const State                          &state,
           const NodeIndex                       node,
           const Vector3<double>                &normal,
           const std::function<bool(FaceIndex)> &is_breakable)
  {
    Star star;
    star.cells = cells_at_node(topology, node);
    place_cells(star, topology, state, normal);
    find_links(star, topology, reference, is_breakable);
    const bool any_crack = carry_cracks_on(star, normal);
    if (any_crack ?
          !star.has(Side::above) || !star.has(Side::below) :
          !fill_side(star, Side::above) || !fill_side(star, Side::below))
      return {};
    const auto is_above = smallest_cut(star);
    if (!is_above)
      return {};

    StarCut         cut{{}, 0, 0};
    Vector3<double> area = {{0, 0, 0}};
    for (const Link &link : star.links)
      {
        const bool above[2] = {(*is_above)[link.cells[0]],
                               (*is_above)[link.cells[1]]};
        if (above[0] == above[1])
          continue;
        area += (above[0] ? -1. : 1.) * link.area_vector;
        if (!link.is_cut)
          {
            cut.faces.push_back(link.face);
            cut.new_area += norm(link.area_vector);
          }
      }
    cut.projected_area = std::abs(dot(area, normal));
    if (cut.projected_area == 0)
      return {};
    return cut;
  }
} // namespace rift
