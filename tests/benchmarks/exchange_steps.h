#ifndef rift_tests_benchmarks_exchange_steps_h
#define rift_tests_benchmarks_exchange_steps_h

#include <rift/app/body.h>
#include <rift/solid/internal_force.h>
#include <rift/time_integration/central_difference.h>

#include <ctime>
#include <utility>

/** Two ways in which ranks can take an elastic step together. */
namespace rift::test
{
  /** s; stable for cells of 1 mm. */
  constexpr double time_step = 1e-8;

  inline std::vector<Elasticity>
  laws_of(const Body &body)
  {
    std::vector<Elasticity> laws;
    for (const MaterialParameters &material : body.materials)
      laws.push_back(make_elasticity(material));
    return laws;
  }

  /** A step that measures its stages. */
  class Steps
  {
  public:
    Steps(Topology                &topology,
          const ReferenceCellData &reference,
          State                   &state,
          std::vector<Elasticity>  laws)
      : topology(topology)
      , state(state)
      , activity(topology)
      , force(topology, reference, std::move(laws))
    {
      activity.wake_all(topology);
    }
    virtual ~Steps() = default;

    virtual void
    step() = 0;

    /** Seconds of the processor for forces, kick and drift since the last
       * call: not disturbed by what else the machine does. */
    double
    take_computing_time()
    {
      return std::exchange(computing_time, 0.);
    }

  protected:
    template <typename Function>
    void
    compute(const Function &f)
    {
      const long start = processor_nanoseconds();
      f();
      computing_time += 1e-9 * (processor_nanoseconds() - start);
    }

    void
    add_forces()
    {
      compute([this] { force.add_to(state, activity); });
    }

    void
    move()
    {
      compute([this] { advance(state, activity, time_step); });
    }

    Topology &topology;
    State    &state;
    Activity  activity;

  private:
    static long
    processor_nanoseconds()
    {
      timespec time;
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
      return 1000000000l * time.tv_sec + time.tv_nsec;
    }

    InternalForce force;
    double        computing_time = 0;
  };

  class GhostSteps : public Steps
  {
  public:
    explicit GhostSteps(Body &body)
      : Steps(body.discretization.topology,
              body.discretization.reference,
              body.discretization.state,
              laws_of(body))
      , exchange(body.discretization.exchange)
    {
    }

    void
    step() override
    {
      add_forces();
      move();
      exchange.send(topology, state, {}, {});
      exchange.receive(topology, state, activity);
    }

  private:
    GhostExchange &exchange;
  };

  /** The cells that a rank owns, as a body of their own. */
  struct OwnedPart
  {
    explicit OwnedPart(const Discretization &all)
      : vertex_numbers(all.topology.n_vertices(), invalid_index)
      , cells(select_cells(all.topology))
      , topology(cells, n_vertices)
    {
      reference.resize(topology.n_batches(), ReferenceBatch{});
      state.resize(topology.n_nodes());
      for (CellIndex cell = 0; cell < topology.n_cell_slots(); ++cell)
        if (!topology.is_padding(cell))
          copy_cell(cell, all);
      for (VertexIndex v = 0; v < vertex_numbers.size(); ++v)
        if (const VertexIndex node = vertex_numbers[v]; node != invalid_index)
          {
            state.reference[node]    = all.state.reference[v];
            state.displacement[node] = all.state.displacement[v];
            state.mass[node]         = all.state.mass[v];
          }
    }

    /** The number here of each vertex of the whole; invalid_index if none. */
    std::vector<VertexIndex> vertex_numbers;
    VertexIndex              n_vertices = 0;
    std::vector<LocalCell>   cells;
    Topology                 topology;
    ReferenceCellData        reference;
    State                    state;

  private:
    std::vector<LocalCell>
    select_cells(const Topology &all)
    {
      std::vector<LocalCell> cells;
      for (CellIndex cell = 0; cell < all.n_cell_slots(); ++cell)
        {
          if (!all.owns_cell(cell))
            continue;
          LocalCell local{all.cell_global_indices[cell],
                          {},
                          all.material(cell)};
          for (unsigned int c = 0; c < n_corners; ++c)
            {
              VertexIndex &number = vertex_numbers[all.vertex(cell, c)];
              if (number == invalid_index)
                number = n_vertices++;
              local.vertices[c] = number;
            }
          cells.push_back(local);
        }
      return cells;
    }

    void
    copy_cell(const CellIndex cell, const Discretization &all)
    {
      const CellIndex from =
        all.topology.find_cell(topology.cell_global_indices[cell]);
      const ReferenceBatch &source = all.reference[from / batch_size];
      ReferenceBatch       &target = reference[cell / batch_size];
      const unsigned int    lane = cell % batch_size, of = from % batch_size;
      target.volume[lane] = source.volume[of];
      for (unsigned int c = 0; c + 1 < n_corners; ++c)
        for (unsigned int d = 0; d < dim; ++d)
          target.gradients[c][d][lane] = source.gradients[c][d][of];
    }
  };

  class SumSteps : public Steps
  {
  public:
    SumSteps(const Body &body, OwnedPart &part)
      : Steps(part.topology, part.reference, part.state, laws_of(body))
      , communicator(body.communicator.mpi())
    {
      find_partners(body.discretization.topology, part.vertex_numbers);
    }

    void
    step() override
    {
      add_forces();
      exchange_forces();
      move();
    }

    std::size_t
    n_bytes() const
    {
      std::size_t sum = 0;
      for (const Partner &partner : partners)
        sum += sizeof(double) * partner.sent.size();
      return sum;
    }

  private:
    struct Partner
    {
      int                    rank;
      std::vector<NodeIndex> nodes;
      std::vector<double>    sent, received;
    };

    /** Both sides list the vertices they share by their first cell. */
    void
    find_partners(const Topology                 &all,
                  const std::vector<VertexIndex> &vertex_numbers)
    {
      using Name = std::pair<CellIndex, unsigned int>;
      std::map<int, std::map<Name, NodeIndex>> shared;
      for (VertexIndex v = 0; v < all.n_vertices(); ++v)
        {
          if (vertex_numbers[v] == invalid_index)
            continue;
          const CellIndex first = *all.vertex_cells_first(v);
          const Name      name(first, all.corner_at_vertex(first, v));
          for (auto cell = all.vertex_cells_first(v);
               cell != all.vertex_cells_last(v);
               ++cell)
            if (!all.owns_cell(*cell))
              shared[all.cell_owners[*cell]][name] = vertex_numbers[v];
        }
      for (const auto &[rank, nodes] : shared)
        {
          Partner partner{rank, {}, {}, {}};
          for (const auto &[name, node] : nodes)
            partner.nodes.push_back(node);
          partner.sent.resize(dim * nodes.size());
          partner.received.resize(dim * nodes.size());
          partners.push_back(std::move(partner));
        }
      requests.resize(2 * partners.size());
    }

    void
    exchange_forces()
    {
      for (std::size_t i = 0; i < partners.size(); ++i)
        {
          Partner  &p = partners[i];
          const int n = static_cast<int>(p.sent.size());
          MPI_Irecv(p.received.data(),
                    n,
                    MPI_DOUBLE,
                    p.rank,
                    tag,
                    communicator,
                    &requests[2 * i]);
          double *at = p.sent.data();
          for (const NodeIndex node : p.nodes)
            at = std::copy_n(state.force[node].v, dim, at);
          MPI_Isend(p.sent.data(),
                    n,
                    MPI_DOUBLE,
                    p.rank,
                    tag,
                    communicator,
                    &requests[2 * i + 1]);
        }
      MPI_Waitall(static_cast<int>(requests.size()),
                  requests.data(),
                  MPI_STATUSES_IGNORE);
      for (const Partner &p : partners)
        {
          const double *at = p.received.data();
          for (const NodeIndex node : p.nodes)
            for (unsigned int d = 0; d < dim; ++d)
              state.force[node][d] += *at++;
        }
    }

    static constexpr int tag = 4;

    MPI_Comm                 communicator;
    std::vector<Partner>     partners;
    std::vector<MPI_Request> requests;
  };

} // namespace rift::test

#endif
