#include <rift/base/bytes.h>
#include <rift/mesh/mesh_buffer.h>

#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace rift
{
  namespace
  {
    class Writer
    {
    public:
      template <typename Container>
      void
      operator()(const Container &data)
      {
        using Value            = typename Container::value_type;
        const std::size_t size = data.size();
        append(bytes, &size, 1);
        if constexpr (std::is_trivially_copyable<Value>::value)
          append(bytes, data.data(), size);
        else
          for (const auto &value : data)
            (*this)(value);
      }

      std::string bytes;
    };

    class Reader
    {
    public:
      explicit Reader(const std::string &bytes)
        : bytes(bytes)
      {
      }

      template <typename Container>
      void
      operator()(Container &data)
      {
        using Value      = typename Container::value_type;
        std::size_t size = 0;
        take(&size, sizeof(size));
        if (size > bytes.size())
          throw std::length_error("The packed mesh is damaged.");
        data.resize(size);
        if constexpr (std::is_trivially_copyable<Value>::value)
          take(data.data(), size * sizeof(Value));
        else
          for (auto &value : data)
            (*this)(value);
      }

    private:
      void
      take(void *target, const std::size_t n_bytes)
      {
        if (n_bytes > bytes.size() - position)
          throw std::length_error("The packed mesh is damaged.");
        if (n_bytes > 0)
          std::memcpy(target, bytes.data() + position, n_bytes);
        position += n_bytes;
      }

      const std::string &bytes;
      std::size_t        position = 0;
    };

    // The one list of what a mesh consists of.
    template <typename Archive, typename Mesh>
    void
    visit(Archive &archive, Mesh &mesh)
    {
      archive(mesh.source);
      archive(mesh.vertices);
      archive(mesh.cells);
      archive(mesh.cell_tags);
      archive(mesh.cell_materials);
      archive(mesh.material_names);
      archive(mesh.surface_names);
      archive(mesh.boundary_faces);
      archive(mesh.internal_faces);
    }
  } // namespace

  std::string
  pack_mesh(const MeshData &mesh)
  {
    Writer writer;
    visit(writer, mesh);
    return std::move(writer.bytes);
  }

  MeshData
  unpack_mesh(const std::string &buffer)
  {
    Reader   reader(buffer);
    MeshData mesh;
    visit(reader, mesh);
    return mesh;
  }
} // namespace rift
