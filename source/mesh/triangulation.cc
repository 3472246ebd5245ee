#include <rift/mesh/triangulation.h>

#include <deal.II/grid/tria.h>
#include <deal.II/grid/tria_description.h>

namespace rift
{
  namespace
  {
    dealii::SubCellData
    make_boundaries(const MeshData &mesh)
    {
      dealii::SubCellData boundaries;
      boundaries.boundary_quads.reserve(mesh.boundary_faces.size());
      for (const NamedFace &face : mesh.boundary_faces)
        {
          dealii::CellData<2> triangle(3);
          for (unsigned int i = 0; i < 3; ++i)
            triangle.vertices[i] =
              mesh.cells[face.cell][face_corners[face.local_face][i]];
          triangle.boundary_id = face.name + 1u;
          boundaries.boundary_quads.push_back(triangle);
        }
      return boundaries;
    }

    void
    make_serial_triangulation(const MeshData             &mesh,
                              dealii::Triangulation<dim> &triangulation)
    {
      std::vector<dealii::Point<dim>> vertices;
      vertices.reserve(mesh.vertices.size());
      for (const auto &x : mesh.vertices)
        vertices.emplace_back(x[0], x[1], x[2]);

      std::vector<dealii::CellData<dim>> cells;
      cells.reserve(mesh.cells.size());
      for (std::size_t c = 0; c < mesh.cells.size(); ++c)
        {
          dealii::CellData<dim> cell(n_corners);
          cell.vertices.assign(mesh.cells[c].begin(), mesh.cells[c].end());
          cell.material_id = mesh.cell_materials[c];
          cells.push_back(std::move(cell));
        }
      triangulation.create_triangulation(vertices,
                                         cells,
                                         make_boundaries(mesh));
    }
  } // namespace

  std::unique_ptr<dealii::parallel::fullydistributed::Triangulation<dim>>
  make_triangulation(const MeshData         &mesh,
                     const std::vector<int> &owners,
                     const MPI_Comm         &communicator)
  {
    const unsigned int n_ranks =
      dealii::Utilities::MPI::n_mpi_processes(communicator);
    const auto partition = [&](dealii::Triangulation<dim> &triangulation,
                               const MPI_Comm &,
                               const unsigned int) {
      for (const auto &cell : triangulation.active_cell_iterators())
        cell->set_subdomain_id(owners[cell->active_cell_index()]);
    };

    // One group of all ranks: rank 0 makes the description of all parts.
    const auto description = dealii::TriangulationDescription::Utilities::
      create_description_from_triangulation_in_groups<dim, dim>(
        [&](dealii::Triangulation<dim> &triangulation) {
          make_serial_triangulation(mesh, triangulation);
        },
        partition,
        communicator,
        static_cast<int>(n_ranks));

    auto triangulation =
      std::make_unique<dealii::parallel::fullydistributed::Triangulation<dim>>(
        communicator);
    triangulation->create_triangulation(description);
    return triangulation;
  }
} // namespace rift
