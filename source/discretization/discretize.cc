#include <rift/base/check.h>
#include <rift/base/exceptions.h>
#include <rift/discretization/discretize.h>
#include <rift/discretization/fragment_labels.h>
#include <rift/mesh/node_splitter.h>

#include <deal.II/base/multithread_info.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_fe.h>

#include <algorithm>
#include <limits>

namespace rift
{
  namespace
  {
    using Triangulation = dealii::parallel::fullydistributed::Triangulation<3>;
    using CellIterator  = dealii::DoFHandler<3>::active_cell_iterator;

    /** All cells that this rank sees, in canonical order. */
    std::vector<std::pair<GlobalCellIndex, CellIterator>>
    sorted_cells(const dealii::DoFHandler<3> &dof_handler)
    {
      std::vector<std::pair<GlobalCellIndex, CellIterator>> cells;
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (!cell->is_artificial())
          cells.emplace_back(cell->id().get_coarse_cell_id(), cell);
      std::sort(cells.begin(), cells.end(), [](const auto &a, const auto &b) {
        return a.first < b.first;
      });
      return cells;
    }

    Topology
    make_topology(
      const std::vector<std::pair<GlobalCellIndex, CellIterator>> &cells,
      const Triangulation &triangulation,
      const int            own_rank)
    {
      // Vertices in the order in which cells need them.
      std::vector<VertexIndex> numbers(triangulation.n_vertices(),
                                       invalid_index);
      VertexIndex              n_vertices = 0;
      std::vector<LocalCell>   local_cells;
      local_cells.reserve(cells.size());
      for (const auto &[global_index, cell] : cells)
        {
          LocalCell local{global_index, {}, 0};
          local.material = static_cast<std::uint16_t>(cell->material_id());
          local.owner    = static_cast<int>(cell->subdomain_id());
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              VertexIndex &number = numbers[cell->vertex_index(c)];
              if (number == invalid_index)
                number = n_vertices++;
              local.vertices[c] = number;
            }
          local_cells.push_back(local);
        }
      return Topology(local_cells, n_vertices, own_rank);
    }
  } // namespace

  namespace
  {
    bool
    is_positive(const double mass)
    {
      return mass > 0;
    }

    /**
     * Keeps FEValues from taking over the gradients of the cell before where
     * both have the same shape: they differ in the last bits, and which cell
     * is before depends on the rank. deal.II does so on one thread only.
     */
    class CellByCell
    {
    public:
      CellByCell()
      {
        dealii::MultithreadInfo::set_thread_limit(2);
      }

      ~CellByCell()
      {
        dealii::MultithreadInfo::set_thread_limit(n_threads);
      }

    private:
      const unsigned int n_threads = dealii::MultithreadInfo::n_threads();
    };

    /**
     * Fills in volumes, gradients of the shape functions and the places of the
     * corners.
     *
     * @param cells in the order of their slots.
     */
    template <typename Cells>
    void
    fill_cells(const dealii::DoFHandler<3> &dof_handler,
               const Cells                 &cells,
               Discretization              &result)
    {
      const auto                    &fe = dof_handler.get_fe();
      const dealii::MappingFE<3>     mapping(dealii::FE_SimplexP<3>(1));
      const dealii::QGaussSimplex<3> quadrature(1);
      dealii::FEValues<3>            fe_values(mapping,
                                    fe,
                                    quadrature,
                                    dealii::update_gradients |
                                      dealii::update_JxW_values);
      const Topology                &topology = result.topology;
      result.reference.resize(topology.n_batches(), ReferenceBatch{});
      result.state.resize(topology.n_nodes());
      CellIndex slot = 0;
      for (const auto &[global_index, cell] : cells)
        {
          while (topology.cell_global_indices[slot] != global_index)
            ++slot;
          fe_values.reinit(cell);
          ReferenceBatch    &batch = result.reference[slot / batch_size];
          const unsigned int lane  = slot % batch_size;
          batch.volume[lane]       = fe_values.JxW(0);
          rift_check(batch.volume[lane] > 0);
          for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
            {
              const auto [component, corner] = fe.system_to_component_index(i);
              if (component != 0 || corner == 0)
                continue;
              for (unsigned int d = 0; d < dim; ++d)
                batch.gradients[corner - 1][d][lane] =
                  fe_values.shape_grad(i, 0)[d];
            }
          for (unsigned int c = 0; c < n_corners; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              result.state.reference[topology.node(slot, c)][d] =
                cell->vertex(c)[d];
        }
    }
  } // namespace

  Discretization
  discretize(const Triangulation       &triangulation,
             const std::vector<double> &densities,
             const Communicator        &communicator,
             const std::vector<bool>   &parted)
  {
    // The vector-valued space of the displacement; its scalar shape functions
    // are the same for the three components, so that of x is asked.
    const dealii::FESystem<3> fe(dealii::FE_SimplexP<3>(1), dim);
    dealii::DoFHandler<3>     dof_handler(triangulation);
    dof_handler.distribute_dofs(fe);
    const CellByCell cell_by_cell;

    const auto     cells = sorted_cells(dof_handler);
    Discretization result{
      communicator,
      make_topology(cells, triangulation, communicator.rank()),
      {},
      {},
      {},
      {},
      densities};
    Topology &topology = result.topology;

    if (parted.empty())
      separate_touching_pieces(topology);
    else
      separate_materials(topology, parted);
    result.exchange = GhostExchange(communicator, topology);
    fill_cells(dof_handler, cells, result);
    for (NodeIndex node = 0; node < topology.n_nodes(); ++node)
      result.state.mass[node] =
        topology.is_complete(topology.node_vertices[node]) ?
          lumped_mass(topology, result.reference, densities, node) :
          std::numeric_limits<double>::infinity();
    rift_check(std::all_of(result.state.mass.begin(),
                           result.state.mass.end(),
                           is_positive));
    result.activity = Activity(topology);
    result.bodies   = label_bodies(topology, communicator).of_cell;
    return result;
  }
} // namespace rift
