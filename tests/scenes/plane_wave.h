#ifndef rift_tests_scenes_plane_wave_h
#define rift_tests_scenes_plane_wave_h

#include <rift/app/simulation.h>
#include <rift/base/floating_point.h>

#include <cmath>

namespace rift::test
{
  /**
   * A pulse in a bar along x that the sides confine so that only the component
   * `direction` moves, as in an infinite body: 0 for a P-wave, 1 or 2 for an
   * S-wave. It is two cells wide, since the wave does not depend on the width;
   * so meshes of all sizes are alike. The end x = 0 moves with half a period of `1 - cos`.
   */
  struct PlaneWave
  {
    MaterialParameters material;
    unsigned int       direction    = 0;
    double             element_size = 2e-3;

    /** Bar and pulse, m and s; `end_time` is before the far end is reached. */
    static constexpr double length    = .12;
    static constexpr double amplitude = .1, duration = 8e-6;
    double                  end_time = 20e-6;

    /** Displacement of the end x = 0 at the time t. */
    static double
    source(const double t)
    {
      const double omega = 2 * M_PI / duration;
      const double s     = std::clamp(t, 0., duration);
      return .5 * amplitude * (s - std::sin(omega * s) / omega);
    }

    static double
    source_velocity(const double t)
    {
      return t > 0 && t < duration ?
               .5 * amplitude * (1 - std::cos(2 * M_PI * t / duration)) :
               0;
    }

    Parameters
    scene() const
    {
      Parameters result;
      result.mesh.shape        = MeshParameters::Shape::box;
      result.mesh.box_size     = {{length, 2 * element_size, 2 * element_size}};
      result.mesh.element_size = element_size;
      result.mesh.material     = material.name;
      result.materials         = {material};
      result.time.end_time     = end_time;
      for (const char *side : {"y_min", "y_max", "z_min", "z_max"})
        {
          BoundaryParameters boundary;
          boundary.name = side;
          for (unsigned int d = 0; d < dim; ++d)
            if (d != direction)
              boundary.velocity[d] = "0";
          result.boundaries.push_back(boundary);
        }
      BoundaryParameters end;
      end.name     = "x_min";
      end.velocity = {{"0", "0", "0"}};
      end.velocity[direction] =
        "t < 8e-6 ? 0.05 * (1 - cos(2 * pi * t / 8e-6)) : 0";
      result.boundaries.push_back(end);
      return result;
    }

    /** What is left when the pulse is on its way. */
    struct Result
    {
      /** Error of the displacement in the L2 norm against d'Alembert's. */
      double error;

      /** Speed of the exact wave that fits the displacements best, m/s. */
      double speed;
    };

    Result
    run(const double exact_speed) const
    {
      Log            log(nullptr);
      Simulation     simulation(scene(), log);
      FlushDenormals flush_denormals;
      while (simulation.state().step < simulation.n_steps())
        simulation.step();

      // Least squares for the slowness, from that of the theory.
      const State &state    = simulation.state();
      double       slowness = 1 / exact_speed, error = 0;
      for (unsigned int iteration = 0; iteration < 10; ++iteration)
        {
          // Difference and norm, slope and curvature.
          std::vector<double> sums(4, 0.);
          for (std::size_t i = 0; i < state.n_nodes(); ++i)
            {
              if (!simulation.topology().owns_node(i))
                continue;
              const double x = state.reference[i][0];
              const double t = state.time - slowness * x;
              const double d = state.displacement[i][direction] - source(t);
              const double g = -x * source_velocity(t);
              sums[0] += state.mass[i] * d * d;
              sums[1] += state.mass[i] * source(t) * source(t);
              sums[2] += state.mass[i] * d * g;
              sums[3] += state.mass[i] * g * g;
            }
          MPI_Allreduce(MPI_IN_PLACE,
                        sums.data(),
                        static_cast<int>(sums.size()),
                        MPI_DOUBLE,
                        MPI_SUM,
                        MPI_COMM_WORLD);
          if (iteration == 0)
            error = std::sqrt(sums[0] / sums[1]);
          slowness += sums[2] / sums[3];
        }
      return {error, 1 / slowness};
    }
  };
} // namespace rift::test

#endif
