#ifndef rift_rigid_rigid_pieces_h
#define rift_rigid_rigid_pieces_h

#include <rift/base/communicator.h>
#include <rift/material/material_parameters.h>
#include <rift/mesh/mesh_data.h>

namespace rift
{
  /** Which cells are rigid together. */
  struct RigidPieces
  {
    /** The body that each cell belongs to; invalid_index: deformable. */
    std::vector<std::uint32_t> body_of_cell;

    /** Material of each body. */
    std::vector<std::uint16_t> materials;
  };

  /**
   * Cells of one rigid material that hang together by faces are one body.
   * Bodies are numbered in the order of their first cells.
   *
   * @param materials by material index of the mesh.
   * @throws InputError where a rigid material shares a face with another one:
   *   it acts on others by contact alone.
   */
  RigidPieces
  find_rigid_pieces(const MeshData                        &mesh,
                    const std::vector<MaterialParameters> &materials);

  /** The pieces of rank 0, on all ranks. Collective. */
  RigidPieces
  broadcast_pieces(const RigidPieces &pieces, const Communicator &communicator);
} // namespace rift

#endif
