#ifndef rift_discretization_ghost_exchange_h
#define rift_discretization_ghost_exchange_h

#include <rift/base/communicator.h>
#include <rift/discretization/activity.h>
#include <rift/discretization/corner_news.h>
#include <rift/discretization/state.h>

#include <vector>

namespace rift
{
  /** A corner of a face at which its two sides have just parted. */
  struct OpeningCorner
  {
    /** The face, by its index in Topology::faces. */
    FaceIndex face;

    /** 0, 1, 2 as seen from the minus side; see face_corners. */
    std::uint8_t corner;

    /** What the bond of the nodes did to the minus side until now, N. */
    Vector3<double> force;
  };

  /**
   * Keeps the nodes at incomplete vertices, those of ghost cells alone, as
   * they are on the rank that knows all cells around them: the owner of the
   * first cell here that has the vertex.
   *
   * Each step one message goes to each neighbour: the displacements of such
   * nodes and, when a crack has come there, which corners have got another
   * node and what their opening faces start with. A split takes effect with
   * the drift, so that nothing has to be told in the midst of a step.
   */
  class GhostExchange
  {
  public:
    /** Of a body that is not divided. */
    GhostExchange() = default;

    /**
     * Finds who tells whom, and gives the corners of ghost cells the nodes
     * that they have there. Collective.
     *
     * @param topology as separate_touching_pieces() or separate_materials()
     *   leaves it.
     */
    GhostExchange(const Communicator &communicator, Topology &topology);

    GhostExchange(const GhostExchange &) = delete;
    GhostExchange &
    operator=(const GhostExchange &) = delete;

    /** Can be moved, but not copied. */
    GhostExchange(GhostExchange &&) = default;

    /** Can be moved, but not copied. */
    GhostExchange &
    operator=(GhostExchange &&) = default;

    /** From now on velocities go with the displacements: for damping. On all
     * ranks or on none. */
    void
    include_velocities();

    /**
     * Sends what others need after the drift; does not wait.
     *
     * @param splits of this step at complete vertices.
     * @param openings of this step at complete vertices.
     * @param news at complete vertices.
     */
    void
    send(const Topology                   &topology,
         const State                      &state,
         const std::vector<NodeSplit>     &splits,
         const std::vector<OpeningCorner> &openings,
         const std::vector<CornerNews>    &news = {});

    /** What a crack has changed at incomplete vertices. */
    struct Change
    {
      /** Vertices at which corners have other nodes, and faces that open
       * there. */
      std::vector<VertexIndex>   vertices;
      std::vector<OpeningCorner> openings;

      /** What others tell of incomplete vertices. */
      std::vector<CornerNews> news;
    };

    /**
     * Waits for what the others have sent, and follows: nodes, displacements,
     * cells to be woken.
     */
    Change
    receive(Topology &topology, State &state, Activity &activity);

    /** Bytes that this rank sends in a step without cracks. */
    std::size_t
    n_bytes() const;

  private:
    struct CellCorner
    {
      CellIndex    cell;
      std::uint8_t corner;
    };

    /** The corners at one vertex among those of a partner. */
    struct VertexCorners
    {
      VertexIndex   vertex;
      std::uint32_t begin, end;
    };

    /**
     * A rank that is told of nodes or that tells of them. Both sides number
     * the corners and the nodes alike.
     */
    struct Partner
    {
      int rank;

      /** Corners that the receiver sees, vertex by vertex. */
      std::vector<CellCorner> corners;

      /** Number of the node that each corner has. */
      std::vector<std::uint32_t> corner_nodes;

      /** The nodes on this rank. */
      std::vector<NodeIndex> nodes;

      /** Ascending by vertex; only for receivers. */
      std::vector<VertexCorners> vertices;

      std::vector<char> buffer;
      MPI_Request       request = MPI_REQUEST_NULL;
    };

    /** A corner that uses another node than before. */
    struct ChangedCorner
    {
      std::uint32_t corner, node;
    };

    /** An OpeningCorner for a rank that has other face indices. */
    struct OpeningMessage
    {
      GlobalCellIndex minus_cell;
      std::uint16_t   local_face, corner;
      double          force[dim];
    };

    /** CornerNews by names that all ranks understand. */
    struct NewsMessage
    {
      GlobalCellIndex       cell;
      std::uint8_t          corner, local_face;
      CornerNews::Kind      kind;
      std::uint8_t          padding;
      std::array<double, 4> values;
    };

    struct Header
    {
      std::uint32_t n_changed, n_openings, n_news, padding;
    };

    void
    request_nodes(const Communicator &communicator, const Topology &topology);

    /** Gives numbers to the nodes of a receiver's corners at one vertex. */
    static std::vector<ChangedCorner>
    number_nodes(const Topology      &topology,
                 Partner             &receiver,
                 const VertexCorners &at_vertex);

    /**
     * Gives a corner here the node that it has on the sender; returns the one
     * that it had. A number that has not occurred yet means a new node.
     */
    static NodeIndex
    change_node(Topology &topology, Partner &sender, ChangedCorner changed);

    void
    name_first_nodes(const Communicator &communicator, Topology &topology);

    static std::vector<OpeningMessage>
    select_openings(const Topology                   &topology,
                    const Partner                    &receiver,
                    const std::vector<OpeningCorner> &openings);

    static std::vector<NewsMessage>
    select_news(const Topology                &topology,
                const Partner                 &receiver,
                const std::vector<CornerNews> &news);

    void
    receive_bytes(Partner &sender) const;

    void
    unpack_values(const char     *values,
                  const Partner  &sender,
                  const Topology &topology,
                  State          &state,
                  Activity       &activity) const;

    std::size_t
    bytes_per_node() const
    {
      return (has_velocities ? 2 : 1) * dim * sizeof(double);
    }

    MPI_Comm             communicator   = MPI_COMM_NULL;
    bool                 has_velocities = false;
    std::vector<Partner> receivers, senders;
  };
} // namespace rift

#endif
