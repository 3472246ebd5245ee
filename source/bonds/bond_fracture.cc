#include <rift/bonds/bond_fracture.h>
#include <rift/mesh/mesh_data.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rift
{
  BondFracture::BondFracture(Discretization &body,
                             InternalForce  &internal_force,
                             const std::vector<MaterialParameters> &materials,
                             const unsigned int                     seed)
    : Fracture(body.topology)
    , body(body)
    , internal_force(internal_force)
    , strengths(body.topology, body.state.reference, materials, seed)
    , bonds(body.topology, body.reference, strengths, planes)
    , insertion(body.topology,
                body.reference,
                internal_force,
                strengths,
                planes)
  {
  }

  std::vector<std::string>
  BondFracture::warnings(const Discretization &body,
                         double,
                         std::uint64_t) const
  {
    return strengths.warnings(body.state.reference, body.communicator);
  }

  void
  BondFracture::prepare(Discretization &body, const StepBound &)
  {
    bounds = strengths.stress_bounds(body.communicator);
    internal_force.watch(bounds);
  }

  void
  BondFracture::choose_cuts(const StepContext &, std::vector<FaceIndex> &faces)
  {
    faces = insertion.take_due_faces();
  }

  void
  BondFracture::follow_cut(const StepContext    &step,
                           const TopologyChange &change)
  {
    const std::vector<CrackFaces::Face> &faces    = bonds.faces().faces;
    const std::size_t                    n_before = faces.size();
    bonds.rebuild(body.state, change.splits, step.time_step);
    for (std::size_t i = n_before; i < faces.size(); ++i)
      advance_state(faces[i], FaceState::opening);
  }

  void
  BondFracture::hold_partings(StepContext &step)
  {
    bonds.hold(body.state, step.time_step, step.prescribed_acceleration);
    insertion.look(body.state, internal_force.hot_cells(), step.news);
    tell_failed(step.news);
  }

  void
  BondFracture::tell_failed(std::vector<CornerNews> &news) const
  {
    for (const VertexBonds::FanFace &failed : bonds.newly_failed())
      {
        const Face &face =
          topology.faces[bonds.faces().faces[failed.face].index];
        const unsigned int corner =
          face_corners[face.local_faces[0]][failed.corner];
        const VertexIndex vertex = topology.vertex(face.cells[0], corner);
        for (unsigned int side = 0; side < 2; ++side)
          news.push_back(
            {face.cells[side],
             static_cast<std::uint8_t>(
               topology.corner_at_vertex(face.cells[side], vertex)),
             face.local_faces[side],
             CornerNews::Kind::failed,
             {}});
      }
  }

  void
  BondFracture::fail_corner(const std::uint32_t place,
                            const unsigned int  corner,
                            const double        time)
  {
    constexpr std::uint8_t all  = 7;
    CrackFaces::Face      &face = bonds.faces().faces[place];
    if (face.failed == all)
      return;
    face.failed |= 1u << corner;
    if (face.failed == all)
      face.failure_time = time;
    advance_state(face,
                  face.failed == all ? FaceState::failed : FaceState::opening);
  }

  void
  BondFracture::advance_state(const CrackFaces::Face &face,
                              const FaceState         next)
  {
    FaceState &state = body.topology.face_states[face.index];
    state            = std::max(state, next);
  }

  void
  BondFracture::after_drift(StepContext &step)
  {
    for (const VertexBonds::FanFace &failed : bonds.newly_failed())
      fail_corner(failed.face, failed.corner, body.state.time);
    for (const CornerNews &item : step.news)
      if (item.kind == CornerNews::Kind::failed)
        {
          const FaceIndex index =
            topology.cell_faces[item.cell][item.local_face];
          if (index == invalid_index)
            continue;
          const Face &face   = topology.faces[index];
          const auto  vertex = topology.vertex(item.cell, item.corner);
          for (unsigned int c = 0; c < 3; ++c)
            if (topology.vertex(face.cells[0],
                                face_corners[face.local_faces[0]][c]) == vertex)
              fail_corner(bonds.faces().add(index, body.state.time),
                          c,
                          body.state.time);
        }
    insertion.take_in(step.news);
    if (contact_interval > 0 && body.state.step % contact_interval == 0)
      {
        release_faces();
        bonds.release();
      }
  }

  void
  BondFracture::release_faces()
  {
    // Nodes that are pressed together lie apart by rounding.
    constexpr double rounding = 1e-6;
    for (std::uint32_t i = 0; i < bonds.faces().faces.size(); ++i)
      {
        const CrackFaces::Face &face  = bonds.faces().faces[i];
        FaceState              &state = body.topology.face_states[face.index];
        if (state != FaceState::failed)
          continue;
        const FaceFrame frame = bonds.faces().current_frame(body.state, i);
        const double    size =
          std::sqrt(.5 * norm(cross(frame.edges[0], frame.edges[1])));
        double largest_opening = 0, largest_slip = 0;
        bool   is_open = true;
        for (unsigned int c = 0; c < 3; ++c)
          {
            const Vector3<double> jump =
              body.state.displacement[face.nodes[1][c]].vector() -
              body.state.displacement[face.nodes[0][c]].vector();
            const double opening = dot(jump, frame.normal);
            is_open &= opening > rounding * size;
            largest_opening = std::max(largest_opening, opening);
            largest_slip =
              std::max(largest_slip, norm(jump - opening * frame.normal));
          }
        if ((is_open && largest_opening > contact_opening * size) ||
            largest_slip > slip_to_contact * size)
          state = FaceState::released;
      }
  }

  void
  BondFracture::account(const Discretization &, EnergyTable &energies) const
  {
    // All ranks must name them.
    for (const auto &[name, part] :
         {std::make_pair("fracture", &BondEnergy::fracture),
          std::make_pair("friction", &BondEnergy::friction),
          std::make_pair("closing", &BondEnergy::closing)})
      {
        ExactSum &sum = energies[name];
        for (const VertexBonds &group : bonds.vertices())
          if (topology.owns_node(group.parts[0].node))
            sum.add(group.energy.*part);
      }
  }

  std::optional<OpenFace>
  BondFracture::open_face(const std::size_t index) const
  {
    const CrackFaces::Face &face = bonds.faces().faces[index];
    OpenFace                result{face.index, {}};
    for (unsigned int side = 0; side < 2; ++side)
      std::copy(face.nodes[side],
                face.nodes[side] + 3,
                result.nodes[side].begin());
    return result;
  }

  std::vector<FaceMeans>
  BondFracture::means(const State &state) const
  {
    const auto &faces = bonds.faces().faces;
    // Of each corner; one that has not parted counts as intact.
    std::vector<std::array<FaceMeans, 3>> corners(faces.size());
    for (const VertexBonds &group : bonds.vertices())
      for (std::size_t i = 0; i < group.bonds.size(); ++i)
        {
          const Bond        &bond    = group.bonds[i];
          const BondHistory &history = group.histories[i];
          FaceMeans          mean{};
          mean.damage = history.memory.damage;
          mean.slip_damage =
            std::clamp(history.memory.slip_damage, 0., mean.damage);
          mean.opening_damage        = mean.damage - mean.slip_damage;
          const Vector3<double> jump = jump_of(group, bond, state);
          mean.opening               = dot(jump, bond.normal);
          mean.slip                  = norm(jump - mean.opening * bond.normal);
          const auto t = BondLaw::split(bond.traction, bond.normal);
          mean.normal  = t.normal;
          mean.shear   = norm(t.shear);
          for (auto f = history.fan_begin; f < history.fan_end; ++f)
            corners[group.fan[f].face][group.fan[f].corner] = mean;
        }
    std::vector<FaceMeans> result(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
      {
        result[i].start_time   = faces[i].start_time;
        result[i].failure_time = faces[i].failure_time;
        for (double FaceMeans::*const value : {&FaceMeans::damage,
                                               &FaceMeans::opening_damage,
                                               &FaceMeans::slip_damage,
                                               &FaceMeans::opening,
                                               &FaceMeans::slip,
                                               &FaceMeans::normal,
                                               &FaceMeans::shear})
          for (const FaceMeans &corner : corners[i])
            result[i].*value += corner.*value / 3;
      }
    return result;
  }

  namespace
  {
    struct CrackFaceRecord
    {
      FaceName face;

      /** See CrackFaces::Face. */
      std::uint64_t failed;
      double        start_time, failure_time;
    };
  } // namespace

  template <>
  struct HasPlainBytes<CrackFaceRecord> : std::true_type
  {
    static_assert(sizeof(CrackFaceRecord) == 4 * 8);
  };

  void
  BondFracture::save(const Discretization &body, Archive &archive) const
  {
    std::vector<CrackFaceRecord> faces;
    for (const CrackFaces::Face &face : bonds.faces().faces)
      if (topology.owns_face(face.index))
        faces.push_back({topology.face_name(face.index),
                         face.failed,
                         face.start_time,
                         face.failure_time});
    archive.write_list("crack faces", faces);
    archive.write_list("bonds", bonds.records());
    planes.save(topology, archive);
    insertion.save(body.state, archive);
  }

  void
  BondFracture::load(const Discretization &body, const Archive &archive)
  {
    planes.load(topology, archive);
    // In the order in which they have begun to open.
    auto faces = archive.read_list<CrackFaceRecord>("crack faces");
    std::sort(
      faces.begin(),
      faces.end(),
      [](const CrackFaceRecord &a, const CrackFaceRecord &b) {
        return std::make_tuple(a.start_time, a.face.cell, a.face.local_face) <
               std::make_tuple(b.start_time, b.face.cell, b.face.local_face);
      });
    for (const CrackFaceRecord &record : faces)
      if (const FaceIndex index = topology.find_face(record.face);
          index != invalid_index)
        {
          CrackFaces::Face &face =
            bonds.faces().faces[bonds.faces().add(index, record.start_time)];
          face.failed       = static_cast<std::uint8_t>(record.failed);
          face.failure_time = record.failure_time;
        }
    bonds.restore(body.state, archive.read_list<BondRecord>("bonds"));
    insertion.load(archive);
  }

  void
  BondFracture::count_items(const Topology &topology, WorkItems &items) const
  {
    for (const VertexBonds &group : bonds.vertices())
      items[*topology.vertex_cells_first(group.vertex)] += group.bonds.size();
  }
} // namespace rift
