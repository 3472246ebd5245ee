#ifndef rift_mesh_gmsh_session_h
#define rift_mesh_gmsh_session_h

#include <map>
#include <string>

namespace rift
{
  /**
   * The lifetime of the gmsh library: it is initialised silent, without the
   * user's configuration files, with one thread and with rift's choice of
   * meshing algorithms, which a script may overrule.
   *
   * gmsh keeps numbers, options and the rest of a line that it could not
   * parse beyond its finalisation, so that one process should have only one
   * session: see run_in_child_process().
   */
  class GmshSession
  {
  public:
    /** `numbers` are known to the scripts that are opened, by name. */
    explicit GmshSession(const std::map<std::string, double> &numbers = {});

    ~GmshSession();

    GmshSession(const GmshSession &) = delete;
    GmshSession &
    operator=(const GmshSession &) = delete;
  };
} // namespace rift

#endif
