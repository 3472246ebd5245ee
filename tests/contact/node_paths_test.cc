// Paths of nodes: never shorter than the way between two times.

#include <rift/contact/node_paths.h>

#include <gtest/gtest.h>

#include <random>

using namespace rift;

TEST(NodePaths, AreNoShorterThanTheWay)
{
  std::mt19937                           engine(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  constexpr double                       time_step = .1;
  State                                  state;
  state.resize(200);
  NodePaths paths;
  paths.advance(state, time_step);
  struct Mark
  {
    double          path, path_of_any;
    Vector3<double> displacement;
  };
  std::vector<Mark> marks(state.n_nodes(), Mark{0, 0, {}});
  double            told = 0;
  for (unsigned int step = 0; step < 300; ++step)
    {
      // Few are fast, and others come to be.
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        for (unsigned int d = 0; d < dim; ++d)
          {
            state.velocity[i][d] = std::pow(uniform(engine), i % 50 ? 9 : 1);
            state.displacement[i][d] += time_step * state.velocity[i][d];
          }
      if (step % 10 == 5)
        {
          // Has moved like the node that it parts from.
          const NodeIndex from = engine() % state.n_nodes();
          const auto      part = static_cast<NodeIndex>(state.n_nodes());
          state.resize(part + 1);
          state.displacement[part] = state.displacement[from];
          marks.push_back(marks[from]);
        }
      paths.advance(state, time_step);
      if (step % 20 == 0)
        {
          paths.include(.2);
          told += .2;
        }
      for (NodeIndex i = 0; i < state.n_nodes(); ++i)
        {
          Mark                 &mark = marks[i];
          const Vector3<double> u    = state.displacement[i].vector();
          const double          way  = norm(u - mark.displacement) - 1e-12;
          ASSERT_GE(paths.of(i) - mark.path, way) << step;
          ASSERT_GE(paths.of_any() - mark.path_of_any, way) << step;
          if (engine() % 20 == 0)
            mark = {paths.of(i), paths.of_any(), u};
        }
    }
  EXPECT_GE(paths.of_any(), told);
  // What is slow is known to be slow.
  EXPECT_LT(paths.of(1), .9 * paths.of_any());
}
