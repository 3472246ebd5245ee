#include <rift/base/exceptions.h>
#include <rift/mesh/msh_file.h>

#include <fstream>
#include <sstream>

namespace rift
{
  namespace
  {
    bool
    contains(const std::string &text, const std::string &tag)
    {
      return text.find(tag) != std::string::npos;
    }
  } // namespace

  void
  check_msh_file(const std::string &file)
  {
    std::ifstream      in(file, std::ios::binary);
    std::ostringstream buffer;
    // Fails also if there is nothing to copy.
    if (!in || !(buffer << in.rdbuf()))
      throw InputError("The mesh file '" + file +
                       "' is empty or cannot be read.");
    const std::string text = buffer.str();

    std::string       heading, version;
    std::stringstream first_lines(text.substr(0, 100));
    first_lines >> heading >> version;
    if (heading != "$MeshFormat")
      throw InputError("The file '" + file +
                       "' does not begin with $MeshFormat, so it is no MSH "
                       "file. Write the mesh with gmsh, format MSH 4.1.");
    if (version != "2.2" && version != "4.1")
      throw InputError("The mesh file '" + file + "' is of MSH version " +
                       version +
                       ", but only 2.2 and 4.1 can be read. Convert it: gmsh " +
                       file + " -save -format msh41 -o new.msh");

    for (const std::string section : {"MeshFormat", "Nodes", "Elements"})
      {
        if (!contains(text, "$" + section))
          throw InputError("The mesh file '" + file + "' has no section $" +
                           section +
                           ". It is cut off or damaged: write it again.");
        if (!contains(text, "$End" + section))
          throw InputError("The mesh file '" + file + "' has no $End" +
                           section +
                           ". It is cut off or damaged: write it "
                           "again.");
      }
  }
} // namespace rift
