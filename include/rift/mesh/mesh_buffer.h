#ifndef rift_mesh_mesh_buffer_h
#define rift_mesh_mesh_buffer_h

#include <rift/mesh/mesh_data.h>

#include <string>

namespace rift
{
  /** All of a mesh as bytes, to be sent to another process of this machine. */
  std::string
  pack_mesh(const MeshData &mesh);

  /**
   * The inverse of pack_mesh().
   *
   * @throws std::length_error if `buffer` is not what pack_mesh() made.
   */
  MeshData
  unpack_mesh(const std::string &buffer);
} // namespace rift

#endif
