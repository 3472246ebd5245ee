#include <rift/base/bytes.h>
#include <rift/base/check.h>
#include <rift/base/disjoint_sets.h>
#include <rift/base/exceptions.h>
#include <rift/mesh/face_table.h>
#include <rift/rigid/rigid_pieces.h>

namespace rift
{
  namespace
  {
    [[noreturn]] void
    refuse_shared_face(const MeshData       &mesh,
                       const GlobalCellIndex a,
                       const GlobalCellIndex b)
    {
      throw InputError(
        "the mesh " + mesh.source + ": the rigid material \"" +
        mesh.material_names[mesh.cell_materials[a]] + "\" and the material \"" +
        mesh.material_names[mesh.cell_materials[b]] +
        "\" share faces, but a rigid material acts on others by contact alone. "
        "Mesh the two volumes apart, with a small gap between them, such as "
        "1e-6 m (in gmsh without Coherence and BooleanFragments).");
    }
  } // namespace

  RigidPieces
  find_rigid_pieces(const MeshData                        &mesh,
                    const std::vector<MaterialParameters> &materials)
  {
    const auto is_rigid = [&](const GlobalCellIndex cell) {
      return materials[mesh.cell_materials[cell]].is_rigid();
    };
    DisjointSets    sets(mesh.cells.size());
    const FaceTable faces(mesh);
    for (VertexIndex vertex = 0; vertex < faces.n_vertices(); ++vertex)
      {
        const auto sides = faces.faces_of(vertex);
        for (std::size_t i = 1; i < sides.size(); ++i)
          {
            const FaceTable::Side &a = sides.first[i - 1], &b = sides.first[i];
            if (a.middle != b.middle || a.largest != b.largest)
              continue;
            if (mesh.cell_materials[a.cell] == mesh.cell_materials[b.cell])
              sets.unite(a.cell, b.cell);
            else if (is_rigid(a.cell))
              refuse_shared_face(mesh, a.cell, b.cell);
            else if (is_rigid(b.cell))
              refuse_shared_face(mesh, b.cell, a.cell);
          }
      }

    RigidPieces pieces;
    pieces.body_of_cell.assign(mesh.cells.size(), invalid_index);
    for (GlobalCellIndex cell = 0; cell < mesh.cells.size(); ++cell)
      if (is_rigid(cell))
        {
          const GlobalCellIndex first_cell = sets.find(cell);
          if (first_cell == cell)
            {
              pieces.body_of_cell[cell] =
                static_cast<std::uint32_t>(pieces.materials.size());
              pieces.materials.push_back(mesh.cell_materials[cell]);
            }
          else
            {
              rift_check(first_cell < cell &&
                         pieces.body_of_cell[first_cell] != invalid_index);
              pieces.body_of_cell[cell] = pieces.body_of_cell[first_cell];
            }
        }
    return pieces;
  }

  RigidPieces
  broadcast_pieces(const RigidPieces &pieces, const Communicator &communicator)
  {
    RigidPieces shared       = pieces;
    const auto  share_vector = [&](auto &values) {
      using T           = std::decay_t<decltype(values[0])>;
      std::string bytes = to_bytes(values);
      communicator.broadcast(bytes);
      values = from_bytes<T>(bytes);
    };
    share_vector(shared.body_of_cell);
    share_vector(shared.materials);
    return shared;
  }
} // namespace rift
