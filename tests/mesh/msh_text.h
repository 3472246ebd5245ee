#ifndef rift_tests_mesh_msh_text_h
#define rift_tests_mesh_msh_text_h

#include <string>
#include <vector>

namespace rift
{
  /**
   * The text of an MSH 2.2 ASCII file, written by hand so that it can be as
   * wrong as a test needs it. Nodes and elements are lines without their tags,
   * which count from 1.
   */
  struct MshText
  {
    /** Lines `dimension tag "name"`. */
    std::vector<std::string> names = {"3 1 \"rock\""};

    /** Lines `x y z`. */
    std::vector<std::string> nodes;

    /** Lines `type 2 physical elementary node node ...`. */
    std::vector<std::string> elements;

    std::string
    str() const
    {
      std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
      text += "$PhysicalNames\n" + std::to_string(names.size()) + "\n";
      for (const auto &name : names)
        text += name + "\n";
      text += "$EndPhysicalNames\n";
      return text + section("Nodes", nodes) + section("Elements", elements);
    }

  private:
    static std::string
    section(const std::string &name, const std::vector<std::string> &lines)
    {
      std::string text =
        "$" + name + "\n" + std::to_string(lines.size()) + "\n";
      for (std::size_t i = 0; i < lines.size(); ++i)
        text += std::to_string(i + 1) + " " + lines[i] + "\n";
      return text + "$End" + name + "\n";
    }
  };

  /** Two tetrahedra above and below a triangle in the plane z = 0. */
  inline MshText
  two_tetrahedra()
  {
    MshText text;
    text.nodes    = {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "0 0 -1"};
    text.elements = {"4 2 1 1 1 2 3 4", "4 2 1 1 1 3 2 5"};
    return text;
  }
} // namespace rift

#endif
