// The canonical order, and that deal.II keeps it.

#include <rift/mesh/cell_ordering.h>
#include <rift/mesh/gmsh_reader.h>
#include <rift/mesh/mesh_checks.h>
#include <rift/mesh/partition.h>
#include <rift/mesh/triangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

using namespace rift;

namespace
{
  // A box of two materials: cells are given to the second at random.
  MeshData
  make_mesh(const double element_size = 0.15)
  {
    MeshParameters parameters;
    parameters.shape        = MeshParameters::Shape::box;
    parameters.box_size     = {{1, 1, 1}};
    parameters.element_size = element_size;
    MeshData mesh           = read_mesh(parameters);
    mesh.material_names     = {"a", "b"};
    std::mt19937 random(1);
    for (auto &material : mesh.cell_materials)
      material = random() % 2;
    // Some faces inside.
    mesh.surface_names.push_back("joint");
    for (GlobalCellIndex c = 0; c < mesh.cells.size(); c += 7)
      mesh.internal_faces.push_back({c, static_cast<std::uint8_t>(c % 4), 6});
    return mesh;
  }

  using Points = std::vector<Vector3<double>>;

  Points
  corners(const MeshData &mesh, const std::size_t cell)
  {
    Points result;
    for (const VertexIndex v : mesh.cells[cell])
      result.push_back(mesh.vertices[v]);
    return result;
  }

  Vector3<double>
  centre(const MeshData &mesh, const std::size_t cell)
  {
    Vector3<double> sum = {{0, 0, 0}};
    for (const auto &x : corners(mesh, cell))
      sum += x;
    return 0.25 * sum;
  }

  // Named faces as tag of the cell, local face and name.
  std::set<std::array<std::size_t, 3>>
  tagged(const MeshData &mesh, const std::vector<NamedFace> &faces)
  {
    std::set<std::array<std::size_t, 3>> result;
    for (const auto &face : faces)
      result.insert(std::array<std::size_t, 3>{
        {mesh.cell_tags[face.cell], face.local_face, face.name}});
    return result;
  }
} // namespace

TEST(CellOrdering, NothingIsLostOrChanged)
{
  const MeshData before = make_mesh();
  MeshData       after  = before;
  order_cells(after);
  check_mesh(after);

  ASSERT_EQ(after.cells.size(), before.cells.size());
  ASSERT_EQ(after.vertices.size(), before.vertices.size());
  std::map<std::size_t, std::size_t> index_of_tag;
  for (std::size_t c = 0; c < before.cells.size(); ++c)
    index_of_tag[before.cell_tags[c]] = c;
  for (std::size_t c = 0; c < after.cells.size(); ++c)
    {
      const std::size_t old = index_of_tag.at(after.cell_tags[c]);
      EXPECT_EQ(corners(after, c), corners(before, old));
      EXPECT_EQ(after.cell_materials[c], before.cell_materials[old]);
    }
  EXPECT_EQ(tagged(after, after.boundary_faces),
            tagged(before, before.boundary_faces));
  EXPECT_EQ(tagged(after, after.internal_faces),
            tagged(before, before.internal_faces));
}

TEST(CellOrdering, MaterialsThenCurveThenFirstTouch)
{
  MeshData mesh = make_mesh(0.08);
  order_cells(mesh);
  EXPECT_TRUE(
    std::is_sorted(mesh.cell_materials.begin(), mesh.cell_materials.end()));

  VertexIndex n_touched = 0;
  for (const auto &cell : mesh.cells)
    for (const VertexIndex v : cell)
      {
        ASSERT_LE(v, n_touched);
        n_touched = std::max(n_touched, v + 1);
      }
  EXPECT_EQ(n_touched, mesh.vertices.size());

  for (const auto *faces : {&mesh.boundary_faces, &mesh.internal_faces})
    for (std::size_t i = 1; i < faces->size(); ++i)
      EXPECT_LT(
        std::make_pair((*faces)[i - 1].cell, (*faces)[i - 1].local_face),
        std::make_pair((*faces)[i].cell, (*faces)[i].local_face));

  // Along a space-filling curve the mean distance of successive cells is that
  // of neighbours; any order by one coordinate makes it a third of the box.
  double mean = 0;
  for (std::size_t c = 1; c < mesh.cells.size(); ++c)
    mean += norm(centre(mesh, c) - centre(mesh, c - 1)) / mesh.cells.size();
  EXPECT_LT(mean, 0.08);
}

TEST(CellOrdering, LongBodiesAreCutAcross)
{
  MeshParameters parameters;
  parameters.shape        = MeshParameters::Shape::box;
  parameters.box_size     = {{1, 8, 1}};
  parameters.element_size = 0.3;
  MeshData mesh           = read_mesh(parameters);
  order_cells(mesh);

  // Each eighth of the order is about an eighth of the length, in which the
  // mean distance from the middle is a quarter; it is 1 in cells that lie in
  // a half of the length and a quarter of the section.
  const std::size_t n_parts = 8, size = mesh.cells.size() / n_parts;
  double            deviation = 0;
  for (std::size_t part = 0; part < n_parts; ++part)
    {
      double middle = 0;
      for (std::size_t c = part * size; c < (part + 1) * size; ++c)
        middle += centre(mesh, c)[1] / size;
      for (std::size_t c = part * size; c < (part + 1) * size; ++c)
        deviation += std::abs(centre(mesh, c)[1] - middle) / (size * n_parts);
    }
  EXPECT_LT(deviation, .4);
}

TEST(CellOrdering, IndependentOfTheOrderInTheFile)
{
  MeshData sorted = make_mesh();
  sorted.boundary_faces.clear();
  sorted.internal_faces.clear();
  MeshData shuffled = sorted;
  order_cells(sorted);

  std::vector<std::size_t> order(shuffled.cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(2));
  const MeshData copy = shuffled;
  for (std::size_t c = 0; c < order.size(); ++c)
    {
      shuffled.cells[c]          = copy.cells[order[c]];
      shuffled.cell_tags[c]      = copy.cell_tags[order[c]];
      shuffled.cell_materials[c] = copy.cell_materials[order[c]];
    }
  order_cells(shuffled);
  EXPECT_EQ(shuffled.cell_tags, sorted.cell_tags);
  EXPECT_EQ(shuffled.cells, sorted.cells);
  EXPECT_EQ(shuffled.vertices, sorted.vertices);

  // And a second time it changes nothing.
  const MeshData once = sorted;
  order_cells(sorted);
  EXPECT_EQ(sorted.cell_tags, once.cell_tags);
  EXPECT_EQ(sorted.cells, once.cells);
  EXPECT_EQ(sorted.vertices, once.vertices);
}

TEST(CellOrdering, EqualCentresKeepTheirOrder)
{
  MeshData mesh;
  mesh.vertices       = {{{1, 1, 1}},
                         {{1, -1, -1}},
                         {{-1, 1, -1}},
                         {{-1, -1, 1}},
                         {{-1, -1, -1}},
                         {{-1, 1, 1}},
                         {{1, -1, 1}},
                         {{1, 1, -1}}};
  mesh.cells          = {{{4, 5, 6, 7}}, {{0, 1, 2, 3}}};
  mesh.cell_tags      = {8, 3};
  mesh.cell_materials = {0, 0};
  order_cells(mesh);
  EXPECT_EQ(mesh.cell_tags, (std::vector<std::size_t>{8, 3}));
  EXPECT_EQ(mesh.cells[0], (std::array<VertexIndex, 4>{{0, 1, 2, 3}}));
}

// Also run on several ranks.
TEST(Triangulation, KeepsCellsVerticesAndNames)
{
  MeshData mesh = make_mesh();
  order_cells(mesh);
  const MPI_Comm     communicator = MPI_COMM_WORLD;
  const unsigned int rank =
    dealii::Utilities::MPI::this_mpi_process(communicator);
  const auto owners =
    partition_cells(mesh,
                    dealii::Utilities::MPI::n_mpi_processes(communicator),
                    MeshParameters::Partition::curve);
  const auto triangulation =
    make_triangulation(rank == 0 ? mesh : MeshData(),
                       rank == 0 ? owners : std::vector<int>(),
                       communicator);

  std::map<std::pair<std::size_t, unsigned int>, unsigned int> boundary_ids;
  for (const auto &face : mesh.boundary_faces)
    boundary_ids[{face.cell, face.local_face}] = face.name + 1;

  std::vector<std::size_t> owned;
  unsigned int             n_named = 0;
  for (const auto &cell : triangulation->active_cell_iterators())
    {
      if (cell->is_artificial())
        continue;
      const std::size_t c = cell->id().get_coarse_cell_id();
      ASSERT_LT(c, mesh.cells.size());
      EXPECT_EQ(cell->material_id(), mesh.cell_materials[c]);
      for (unsigned int i = 0; i < n_corners; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          EXPECT_EQ(cell->vertex(i)[d], mesh.vertices[mesh.cells[c][i]][d]);
      if (!cell->is_locally_owned())
        continue;
      owned.push_back(c);
      for (const auto f : cell->face_indices())
        if (cell->at_boundary(f))
          {
            // deal.II numbers the faces differently: find the opposite corner.
            unsigned int opposite = 0 + 1 + 2 + 3;
            for (unsigned int i = 0; i < 3; ++i)
              for (unsigned int a = 0; a < n_corners; ++a)
                if (cell->face(f)->vertex_index(i) == cell->vertex_index(a))
                  opposite -= a;
            EXPECT_EQ(cell->face(f)->boundary_id(),
                      boundary_ids.at({c, opposite}));
            ++n_named;
          }
    }
  // A contiguous share of the cells, and all of them together.
  ASSERT_FALSE(owned.empty());
  std::sort(owned.begin(), owned.end());
  EXPECT_EQ(owned.back() - owned.front() + 1, owned.size());
  const unsigned int n_ranks =
    dealii::Utilities::MPI::n_mpi_processes(communicator);
  EXPECT_LE(owned.size(), mesh.cells.size() / n_ranks + 1);
  EXPECT_EQ(dealii::Utilities::MPI::sum(owned.size(), communicator),
            mesh.cells.size());
  EXPECT_EQ(dealii::Utilities::MPI::sum(n_named, communicator),
            mesh.boundary_faces.size());
}

TEST(Triangulation, FacesWithoutNameHaveBoundaryIdZero)
{
  MeshData mesh = make_mesh(0.5);
  order_cells(mesh);
  mesh.boundary_faces.resize(1);
  const auto triangulation =
    make_triangulation(mesh,
                       std::vector<int>(mesh.cells.size(), 0),
                       MPI_COMM_SELF);
  unsigned int n_named = 0;
  for (const auto &cell : triangulation->active_cell_iterators())
    for (const auto f : cell->face_indices())
      if (cell->at_boundary(f))
        {
          const auto id = cell->face(f)->boundary_id();
          EXPECT_TRUE(id == 0 || id == mesh.boundary_faces[0].name + 1u);
          n_named += id != 0;
        }
  EXPECT_EQ(n_named, 1u);
}
