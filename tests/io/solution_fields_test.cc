// What is written for ParaView, and the hash, on several ranks.

#include <rift/base/bytes.h>
#include <rift/cohesive/cohesive_force.h>
#include <rift/discretization/fragment_labels.h>
#include <rift/discretization/fragments.h>
#include <rift/io/solution_fields.h>

#include "../cohesive/breaking_body.h"
#include "../support/divided_body.h"
#include "../support/vtu_file.h"

using namespace rift;
using namespace rift::test;

namespace
{
  const Communicator this_rank_alone;

  std::vector<MaterialParameters>
  two_granites()
  {
    std::vector<MaterialParameters> materials = {granite(), granite()};
    for (unsigned int i = 0; i < 2; ++i)
      materials[i].density = densities[i];
    return materials;
  }

  /**
   * A row for each cell with all that the file tells of it, in order: sets of
   * cells can then be compared however they are divided.
   */
  std::vector<std::string>
  rows(const Solution &piece)
  {
    std::vector<std::string> result;
    for (std::size_t cell = 0; cell < piece.cells.size() / piece.nodes_per_cell;
         ++cell)
      {
        std::string row;
        const auto add = [&row](const OutputField &field, const std::size_t i) {
          const auto begin = field.values.begin() + i * field.n_components;
          row +=
            to_bytes(std::vector<float>(begin, begin + field.n_components));
        };
        for (unsigned int c = 0; c < piece.nodes_per_cell; ++c)
          {
            const NodeIndex point =
              piece.cells[cell * piece.nodes_per_cell + c];
            const auto &x = piece.points.at(point);
            row += to_bytes(std::vector<double>(x.begin(), x.end()));
            for (const OutputField &field : piece.point_data)
              add(field, point);
          }
        for (const OutputField &field : piece.cell_data)
          add(field, cell);
        result.push_back(row);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::size_t
  row_length(const Solution &piece)
  {
    std::size_t of_point = sizeof(Vector3<double>), of_cell = 0;
    for (const OutputField &field : piece.point_data)
      of_point += field.n_components * sizeof(float);
    for (const OutputField &field : piece.cell_data)
      of_cell += field.n_components * sizeof(float);
    return piece.nodes_per_cell * of_point + of_cell;
  }

  /** The rows of all ranks, on all ranks. */
  std::vector<std::string>
  all_rows(const Solution &piece, const Communicator &communicator)
  {
    std::string own;
    for (const std::string &row : rows(piece))
      own += row;
    std::vector<std::string> result;
    for (const std::string &of_rank : communicator.all_gather(own))
      for (std::size_t i = 0; i < of_rank.size(); i += row_length(piece))
        result.push_back(of_rank.substr(i, row_length(piece)));
    std::sort(result.begin(), result.end());
    return result;
  }

  void
  expect_no_unused_points(const Solution &piece)
  {
    const std::set<NodeIndex> used(piece.cells.begin(), piece.cells.end());
    EXPECT_EQ(used.size(), piece.points.size());
  }

  Solution
  solid(const DiscreteBody   &body,
        const Communicator   &communicator,
        const FieldSelection &wanted = {})
  {
    const InternalForce force(body.topology,
                              body.reference,
                              laws_of(two_granites()));
    const auto          fragments =
      find_fragments(body.topology,
                     body.reference,
                     densities,
                     label_bodies(body.topology, communicator).of_cell,
                     body.state,
                     velocities(body.state),
                     communicator)
        .of_cell;
    FieldList fields(body.state, 0);
    declare_nodal_fields(fields);
    InternalForce::declare_fields(fields, &force);
    declare_labels(fields, &body.topology, &fragments);
    return solid_solution(body.topology, fields, wanted);
  }

  /** The faces of a force alone, as a module. */
  class FractureOf : public Fracture
  {
  public:
    FractureOf(const Topology &topology, const CohesiveForce &force)
      : Fracture(topology)
      , force(force)
    {
    }

    std::size_t
    n_faces() const override
    {
      return force.faces().size();
    }

    std::optional<OpenFace>
    open_face(const std::size_t index) const override
    {
      return force.open_face(index);
    }

    std::vector<FaceMeans>
    means(const State &state) const override
    {
      return force.means(state);
    }

    FaceCounts
    count_faces(const Communicator &communicator) const override
    {
      return force.count_faces(communicator);
    }

    void
    leave_failed_faces_to_contact(std::uint64_t, double) override
    {
    }

    double
    share_of_stiffness() const override
    {
      return 0;
    }

  private:
    const CohesiveForce &force;
  };

  /** All faces that are cut have begun to open and have been worked on. */
  Solution
  fracture(DiscreteBody &body, const FieldSelection &wanted = {})
  {
    for (FaceState &state : body.topology.face_states)
      state = std::min(state, FaceState::cut);
    const FaceStrengths strengths(body.topology,
                                  body.reference,
                                  two_granites(),
                                  {});
    CohesiveParameters  extrinsic;
    extrinsic.model = CohesiveModel::extrinsic;
    extrinsic.law   = "faces";
    CohesiveForce              force(body.topology,
                        body.reference,
                        strengths,
                        extrinsic,
                        [](FaceIndex) { return 1e13; });
    std::vector<OpeningCorner> openings;
    for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
      for (std::uint8_t c = 0;
           c < 3 && body.topology.face_states[face] != FaceState::intact;
           ++c)
        openings.push_back({face, c, {{0, 0, 0}}});
    force.start_openings(body.state, openings);
    force.add_to(body.state, Activity(body.topology));
    FieldList fields(body.state, 0);
    declare_nodal_fields(fields);
    const FractureOf fracture(body.topology, force);
    Fracture::declare_fields(fields, &fracture);
    return fracture_solution(body.topology, fracture, fields, wanted);
  }

  std::string
  hash(const DiscreteBody &body, const Communicator &communicator)
  {
    return state_hash(body.topology, body.state, communicator);
  }
} // namespace

TEST(SolutionFields, PiecesMakeTheWholeSolid)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      const DividedBody divided(seed, all);
      const Solution    piece = solid(divided.local, all);
      expect_no_unused_points(piece);
      EXPECT_EQ(piece.cells.size() / 4, divided.local.topology.n_owned_cells());
      EXPECT_EQ(all_rows(piece, all),
                rows(solid(divided.whole, this_rank_alone)))
        << "seed " << seed;
    }
}

TEST(SolutionFields, PiecesMakeTheWholeFracture)
{
  const Communicator all(MPI_COMM_WORLD);
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      DividedBody    divided(seed, all);
      const Solution piece = fracture(divided.local);
      expect_no_unused_points(piece);
      const auto expected = rows(fracture(divided.whole));
      EXPECT_EQ(expected.size(), divided.cuts.size());
      EXPECT_EQ(all_rows(piece, all), expected) << "seed " << seed;
    }
}

namespace
{
  /** Where a point was, and its displacement in single precision. */
  using PointRow = std::pair<Vector3<double>, std::array<float, dim>>;

  PointRow
  row_of(const Vector3<double> &reference, const Vector3<double> &displacement)
  {
    PointRow row{reference, {}};
    std::copy(displacement.begin(), displacement.end(), row.second.begin());
    return row;
  }

  /** Points and displacements of a file. */
  std::vector<PointRow>
  read_points(const Solution &solution)
  {
    const TemporaryDirectory directory;
    write_vtu(directory / "s.vtu", 0, solution);
    const VtuFile         file(directory / "s.vtu");
    const auto            points       = file.array<double>("Points");
    const auto            displacement = file.array<float>("displacement [m]");
    std::vector<PointRow> rows(points.size() / dim);
    EXPECT_EQ(points.size(), displacement.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        {
          rows[i].first[d]  = points[dim * i + d];
          rows[i].second[d] = displacement[dim * i + d];
        }
    return rows;
  }

  /** A body that has been cut, broken and moved, far from the origin. */
  DiscreteBody
  body_in_a_mine()
  {
    DiscreteBody body = DividedBody(1, this_rank_alone).whole;
    for (NodalVector &x : body.state.reference)
      x[1] += 5.1e5;
    return body;
  }
} // namespace

TEST(SolutionFields, PointsAreThoseOfTheUndeformedBody)
{
  const DiscreteBody    body  = body_in_a_mine();
  const State          &state = body.state;
  std::vector<PointRow> expected;
  for (NodeIndex node = 0; node < state.n_nodes(); ++node)
    expected.push_back(row_of(state.reference[node].vector(),
                              state.displacement[node].vector()));
  EXPECT_EQ(read_points(solid(body, this_rank_alone)), expected);
}

TEST(SolutionFields, FacesStandInTheUndeformedBodyToo)
{
  DiscreteBody       body     = body_in_a_mine();
  const Topology    &topology = body.topology;
  const auto         rows     = read_points(fracture(body));
  std::set<PointRow> expected;
  for (FaceIndex face = 0; face < topology.faces.size(); ++face)
    for (unsigned int c = 0; c < 3; ++c)
      if (topology.face_states[face] != FaceState::intact)
        {
          const auto &[cells, local_faces] = topology.faces[face];
          const NodeIndex minus =
            topology.node(cells[0], face_corners[local_faces[0]][c]);
          const NodeIndex plus = topology.node(
            cells[1],
            topology.corner_at_vertex(cells[1], topology.node_vertices[minus]));
          expected.insert(
            row_of(body.state.reference[plus].vector(),
                   .5 * (body.state.displacement[minus].vector() +
                         body.state.displacement[plus].vector())));
        }
  EXPECT_GT(rows.size(), 50u);
  EXPECT_EQ((std::set<PointRow>(rows.begin(), rows.end())), expected);
}

namespace
{
  std::vector<std::string>
  names(const std::vector<OutputField> &fields)
  {
    std::vector<std::string> result;
    for (const OutputField &field : fields)
      result.push_back(field.name);
    return result;
  }
} // namespace

TEST(SolutionFields, OnlyThoseThatAreWanted)
{
  using Names       = std::vector<std::string>;
  DiscreteBody body = DividedBody(1, this_rank_alone).whole;

  Solution piece = solid(body, this_rank_alone);
  EXPECT_EQ(names(piece.point_data),
            (Names{"displacement [m]", "velocity [m/s]"}));
  EXPECT_EQ(names(piece.cell_data),
            (Names{"stress [Pa]", "material", "fragment"}));
  piece = fracture(body);
  EXPECT_EQ(names(piece.point_data), Names{"displacement [m]"});
  EXPECT_EQ(names(piece.cell_data),
            (Names{"damage",
                   "mode",
                   "opening [m]",
                   "slip [m]",
                   "normal traction [Pa]",
                   "shear traction [Pa]",
                   "time of insertion [s]",
                   "time of failure [s]"}));

  const FieldSelection some{{"slip", "pressure", "velocity"}};
  piece = solid(body, this_rank_alone, {{"principal stress"}});
  EXPECT_EQ(piece.cell_data.at(0).components, (Names{"1", "2", "3"}));
  piece = solid(body, this_rank_alone, {{"velocity"}});
  EXPECT_TRUE(piece.point_data.at(0).components.empty());
  piece = solid(body, this_rank_alone, some);
  EXPECT_EQ(names(piece.point_data), Names{"velocity [m/s]"});
  EXPECT_EQ(names(piece.cell_data), Names{"pressure [Pa]"});
  piece = fracture(body, some);
  EXPECT_TRUE(piece.point_data.empty());
  EXPECT_EQ(names(piece.cell_data), Names{"slip [m]"});

  // Without values, and with them.
  Names known, written;
  for (const Field &field : known_output_fields())
    if (field.location != FieldLocation::material)
      known.push_back(title(field.name, field.unit));
  for (const Solution &all :
       {solid(body, this_rank_alone, {{"all"}}), fracture(body, {{"all"}})})
    for (const auto *fields : {&all.point_data, &all.cell_data})
      for (const std::string &name : names(*fields))
        written.push_back(name);
  std::sort(known.begin(), known.end());
  std::sort(written.begin(), written.end());
  written.erase(std::unique(written.begin(), written.end()), written.end());
  EXPECT_EQ(known, written);
}

TEST(StateHash, IsTheSameOnAnyNumberOfRanks)
{
  const Communicator    all(MPI_COMM_WORLD);
  std::set<std::string> hashes;
  for (unsigned int seed = 0; seed < 40; ++seed)
    {
      const DividedBody divided(seed, all);
      EXPECT_EQ(hash(divided.local, all), hash(divided.whole, this_rank_alone));
      EXPECT_EQ(hash(divided.local, all).size(), 32u);
      hashes.insert(hash(divided.local, all));
    }
  EXPECT_EQ(hashes.size(), 40u);
}

TEST(StateHash, TellsStatesApart)
{
  // Each cell has nodes of its own.
  std::mt19937 random(1);
  DiscreteBody body = discretize(make_box({2, 2, 1}), densities);
  cut(body, shuffled_faces(body.topology, random));
  move_at_random(body.state, random);
  const std::string before = hash(body, this_rank_alone);

  // One bit of a displacement, and of a velocity.
  for (auto *vector : {&body.state.displacement, &body.state.velocity})
    {
      double      &number = vector->back()[1];
      const double former = number;
      number              = std::nextafter(number, 1);
      EXPECT_NE(hash(body, this_rank_alone), before);
      number = former;
      EXPECT_EQ(hash(body, this_rank_alone), before);
    }

  // The same numbers, but of two cells that have changed places.
  for (unsigned int c = 0; c < n_corners; ++c)
    for (auto *vector : {&body.state.displacement, &body.state.velocity})
      std::swap((*vector)[body.topology.node(0, c)],
                (*vector)[body.topology.node(1, c)]);
  EXPECT_NE(hash(body, this_rank_alone), before);
}
