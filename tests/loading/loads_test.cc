// Pressure, traction, gravity and prescribed motion on bodies.

#include <rift/loading/body_force.h>
#include <rift/loading/prescribed_motion.h>
#include <rift/loading/surface_load.h>
#include <rift/time_integration/central_difference.h>

#include "../support/elastic_body.h"
#include "../temporary_directory.h"
#include <gtest/gtest.h>

#include <sstream>

using namespace rift;
using namespace rift::test;

namespace
{
  Vector3<double>
  resultant(const State &state)
  {
    Vector3<double> sum = {{0, 0, 0}};
    for (const auto &f : state.force)
      sum += f.vector();
    return sum;
  }

  Vector3<double>
  moment(const State &state)
  {
    Vector3<double> sum = {{0, 0, 0}};
    for (NodeIndex i = 0; i < state.n_nodes(); ++i)
      sum += cross(state.position(i), state.force[i].vector());
    return sum;
  }

  BoundaryParameters
  pressure(const std::string &text)
  {
    BoundaryParameters result;
    result.name     = "surface";
    result.pressure = text;
    return result;
  }

  BoundaryParameters
  traction(const std::array<std::string, 3> &text)
  {
    BoundaryParameters result;
    result.name     = "surface";
    result.traction = text;
    return result;
  }

  BoundaryParameters
  velocity(const std::array<std::string, 3> &text)
  {
    BoundaryParameters result;
    result.name     = "surface";
    result.velocity = text;
    return result;
  }

  Matrix3<double>
  random_deformation(Random &random)
  {
    auto h = random_matrix(random);
    for (auto &row : h)
      row = .1 * row;
    return rotated(random_rotation(random), h);
  }

  /** A bar without Poisson's ratio along z, 1 x 1 x 4. */
  struct Bar
  {
    Bar()
      : body(make_box({{1, 1, 4}}), material())
      , dt(.7 * body.critical_step())
    {
    }

    static MaterialParameters
    material()
    {
      MaterialParameters result = granite();
      result.poissons_ratio     = 0;
      return result;
    }

    Surface
    end(const double z) const
    {
      return plane_surface(body.discrete, 2, z);
    }

    ElasticBody  body;
    const double dt;
  };
} // namespace

TEST(Pressure, OnAClosedSurfaceHasNoResultant)
{
  Random random(1);
  for (unsigned int n = 0; n < 30; ++n)
    {
      ElasticBody body(make_box({{3, 2, 2}}, 1, .1, n), granite());
      SurfaceLoad load(body.topology,
                       whole_surface(body.topology),
                       pressure("2e6"));
      impose_gradient(body.state, random_deformation(random));
      // Any deformation, not only a uniform one.
      for (auto &u : body.state.displacement)
        for (unsigned int d = 0; d < 3; ++d)
          u[d] += .1 * random_matrix(random)[0][0];
      load.add_to(body.state, body.activity, 1e-6);
      double largest = 0;
      for (const auto &f : body.state.force)
        largest = std::max(largest, norm(f.vector()));
      EXPECT_GT(largest, 1e5);
      EXPECT_LT(norm(resultant(body.state)), 1e-12 * 2e6);
      EXPECT_LT(norm(moment(body.state)), 1e-11 * 2e6);
    }
}

TEST(Pressure, FollowsTheSurface)
{
  Random random(2);
  for (unsigned int n = 0; n < 20; ++n)
    {
      ElasticBody   body(make_box({{2, 2, 2}}), granite());
      const Surface top = plane_surface(body.discrete, 2, 2);
      SurfaceLoad   load(body.topology, top, pressure("3e6"));
      const auto    h = random_deformation(random);
      impose_gradient(body.state, h);
      load.add_to(body.state, body.activity, 1e-6);
      // The edges of the square are now F e_x and F e_y; pressure pushes in.
      const Vector3<double> a = {{2 + 2 * h[0][0], 2 * h[1][0], 2 * h[2][0]}};
      const Vector3<double> b = {{2 * h[0][1], 2 + 2 * h[1][1], 2 * h[2][1]}};
      const Vector3<double> expected = -3e6 * cross(a, b);
      EXPECT_LT(norm(resultant(body.state) - expected), 1e-13 * norm(expected));

      // The forces of the turned body are the turned forces.
      const std::vector<NodalVector> before = body.state.force;
      const auto                     r      = random_rotation(random);
      impose_gradient(body.state, rotated(r, h));
      std::fill(body.state.force.begin(),
                body.state.force.end(),
                NodalVector());
      load.add_to(body.state, body.activity, 1e-6);
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        EXPECT_LT(norm(body.state.force[i].vector() - r * before[i].vector()),
                  1e-6);
    }
}

TEST(Traction, KeepsDirectionAndSize)
{
  Random      random(3);
  ElasticBody body(make_box({{2, 3, 2}}, .5), granite());
  const auto  side = plane_surface(body.discrete, 0, 1);
  SurfaceLoad load(body.topology, side, traction({{"1e6", "-2e6*t", ""}}));
  body.state.time = .25;
  for (unsigned int n = 0; n < 10; ++n)
    {
      std::fill(body.state.force.begin(),
                body.state.force.end(),
                NodalVector());
      load.add_to(body.state, body.activity, 1e-6);
      // 1.5 m times 1 m, undeformed.
      const Vector3<double> f = resultant(body.state);
      EXPECT_NEAR(f[0], 1.5e6, 1e-7);
      EXPECT_NEAR(f[1], -.75e6, 1e-7);
      EXPECT_EQ(f[2], 0);
      const auto nodes = surface_nodes(body.topology, side);
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        EXPECT_EQ(body.state.force[i][0] > 0,
                  std::binary_search(nodes.begin(), nodes.end(), i));
      impose_gradient(body.state, random_deformation(random));
    }
}

TEST(Traction, SlowLoadDoesHalfOfForceTimesDisplacement)
{
  Bar          bar;
  ElasticBody &body = bar.body;
  // Raised from 0 to 1e4 Pa over 160 times that a wave runs along the bar.
  const double      c = std::sqrt(40.6e9 / 2641), end = 640 / c;
  const std::string t = std::to_string(M_PI / end);
  SurfaceLoad       load(body.topology,
                   bar.end(4),
                   traction({{"", "", "5e3*(1-cos(" + t + "*t))"}}));
  PrescribedMotion  motion(body.topology,
                          {{bar.end(0), velocity({{"", "", "0"}})}});
  while (body.state.time < end)
    {
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      load.add_to(body.state, body.activity, bar.dt);
      motion.impose(body.state, body.activity, bar.dt);
      load.count_work(body.state, bar.dt);
      advance(body.state, body.activity, bar.dt);
    }
  // u = F L / (E A) for a bar without Poisson's ratio.
  const double expected = .5 * 1e4 * (1e4 * 4 / 40.6e9);
  EXPECT_NEAR(load.work().sum().value(), expected, 1e-3 * expected);
  EXPECT_NEAR(body.force.strain_energy(body.state).value(),
              expected,
              1e-3 * expected);
  EXPECT_EQ(motion.work().sum().value(), 0);
}

namespace
{
  /** A function of time that rises from 0 to `height` and falls back. */
  struct Triangle
  {
    double begin, length, height;

    /** Its table in a file. */
    void
    write(const std::string &path, const std::string &unit) const
    {
      std::ostringstream table;
      table.precision(17);
      table << "time [s],value [" << unit << "]\n"
            << begin << ",0\n"
            << begin + .5 * length << ',' << height << '\n'
            << begin + length << ",0\n";
      write_file(path, table.str());
    }

    /** Integral up to a time. */
    double
    integral(const double time) const
    {
      const double s = std::clamp((time - begin) / length, 0., 1.);
      return height * length * (s < .5 ? s * s : .5 - (1 - s) * (1 - s));
    }
  };

  /** At the start, between steps, across one, longer than some. */
  std::vector<Triangle>
  triangles(const double time_step, const double integral)
  {
    std::vector<Triangle> result;
    for (const auto &[begin, length] :
         std::vector<std::pair<double, double>>{{0, .02},
                                                {.4, .3},
                                                {3.3, .1},
                                                {4.95, .1},
                                                {.2, 4.5},
                                                {7, 2}})
      result.push_back({begin * time_step,
                        length * time_step,
                        2 * integral / (length * time_step)});
    return result;
  }
} // namespace

TEST(Pressure, AllOfATableActs)
{
  TemporaryDirectory directory;
  Bar                bar;
  for (const Triangle &triangle : triangles(bar.dt, 10))
    {
      Bar          free_bar;
      ElasticBody &body = free_bar.body;
      triangle.write(directory / "t.csv", "Pa");
      SurfaceLoad load(body.topology,
                       free_bar.end(0),
                       pressure(directory / "t.csv"));
      for (unsigned int n = 0; n < 12; ++n)
        {
          EXPECT_FALSE(body.force.add_to(body.state, body.activity));
          load.add_to(body.state, body.activity, bar.dt);
          if (n == 0)
            start_velocities(body.state, bar.dt);
          advance(body.state, body.activity, bar.dt);
        }
      double momentum = 0;
      for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
        momentum += body.state.mass[i] * body.state.velocity[i][2];
      // 10 Pa s on 1 m^2, which hardly changes.
      EXPECT_NEAR(momentum, 10, 1e-5) << triangle.begin;
    }
}

TEST(PrescribedMotion, GoesAsFarAsItsTable)
{
  TemporaryDirectory directory;
  Bar                bar;
  for (const Triangle &triangle : triangles(bar.dt, 1e-6))
    {
      Bar          moved_bar;
      ElasticBody &body  = moved_bar.body;
      State       &state = body.state;
      triangle.write(directory / "t.csv", "m/s");
      PrescribedMotion motion(
        body.topology,
        {{bar.end(0), velocity({{"", "", directory / "t.csv"}})}});
      const NodeIndex node = surface_nodes(body.topology, bar.end(0))[0];
      for (unsigned int n = 0; n < 12; ++n)
        {
          EXPECT_FALSE(body.force.add_to(state, body.activity));
          const double velocity =
            state.velocity[node][2] +
            bar.dt * *motion.prescribed_acceleration(state, bar.dt, node, 2);
          motion.impose(state, body.activity, bar.dt);
          advance(state, body.activity, bar.dt);
          EXPECT_NEAR(state.velocity[node][2], velocity, 1e-12);
          EXPECT_NEAR(state.displacement[node][2],
                      triangle.integral(state.time),
                      1e-18);
        }
    }
}

TEST(PrescribedMotion, ImposesTheVelocityOfHalfAStepLater)
{
  Bar              bar;
  ElasticBody     &body = bar.body;
  PrescribedMotion motion(
    body.topology,
    {{bar.end(0), velocity({{"", "0", "1e-3*sin(1e3*t)+1e-4"}})},
     {bar.end(4), velocity({{"2e-4", "", ""}})}});
  const auto acceleration = [&](const NodeIndex    node,
                                const unsigned int component) {
    return motion.prescribed_acceleration(body.state, 1e-6, node, component);
  };
  for (const NodeIndex node : surface_nodes(body.topology, bar.end(0)))
    {
      EXPECT_FALSE(acceleration(node, 0));
      EXPECT_EQ(*acceleration(node, 1), 0);
      EXPECT_NEAR(*acceleration(node, 2),
                  (1e-3 * std::sin(5e-4) + 1e-4) / 1e-6,
                  1e-6);
    }
  for (const NodeIndex node : surface_nodes(body.topology, bar.end(4)))
    {
      EXPECT_NEAR(*acceleration(node, 0), 2e-4 / 1e-6, 1e-9);
      EXPECT_FALSE(acceleration(node, 1));
    }
  for (unsigned int n = 0; n < 200; ++n)
    {
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      motion.impose(body.state, body.activity, bar.dt);
      const double t = body.state.time + .5 * bar.dt;
      advance(body.state, body.activity, bar.dt);
      for (const NodeIndex node : surface_nodes(body.topology, bar.end(0)))
        {
          EXPECT_NEAR(body.state.velocity[node][2],
                      1e-3 * std::sin(1e3 * t) + 1e-4,
                      1e-17);
          EXPECT_NEAR(body.state.velocity[node][1], 0, 1e-17);
        }
      for (const NodeIndex node : surface_nodes(body.topology, bar.end(4)))
        EXPECT_NEAR(body.state.velocity[node][0], 2e-4, 1e-17);
    }
}

TEST(PrescribedMotion, FirstBoundaryCountsWhereTwoMeet)
{
  ElasticBody      body(make_box({{2, 2, 2}}), granite());
  const Surface    bottom = plane_surface(body.discrete, 2, 0);
  const Surface    side   = plane_surface(body.discrete, 0, 0);
  PrescribedMotion motion(
    body.topology,
    {{bottom, velocity({{"1", "", "2"}})}, {side, velocity({{"3", "", ""}})}});
  motion.impose(body.state, body.activity, 1e-6);
  advance(body.state, body.activity, 1e-6);
  for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
    {
      const auto x         = body.state.reference[i].vector();
      const bool at_bottom = x[2] == 0, at_side = x[0] == 0;
      EXPECT_NEAR(body.state.velocity[i][0],
                  at_bottom ? 1 :
                  at_side   ? 3 :
                              0,
                  1e-15);
      EXPECT_EQ(body.state.velocity[i][1], 0);
      EXPECT_NEAR(body.state.velocity[i][2], at_bottom ? 2 : 0, 1e-15);
    }
}

TEST(PrescribedMotion, ReactionsDoTheWorkOfTheKineticEnergy)
{
  // All nodes are moved alike, so that nothing else takes up energy.
  ElasticBody      body(make_box({{2, 2, 2}}, 1, .1), granite());
  const double     dt = .5 * body.critical_step();
  PrescribedMotion motion(
    body.topology,
    {{whole_surface(body.topology), velocity({{"5e2*t", "sin(3e3*t)", "0"}})}});
  // The inner vertex is on no surface; the body of eight cubes has one.
  double inner_mass = 0;
  for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
    if (!motion.prescribed_acceleration(body.state, dt, i, 0))
      inner_mass += body.state.mass[i];
  ASSERT_GT(inner_mass, 0);
  for (unsigned int n = 0; n < 300; ++n)
    {
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      motion.impose(body.state, body.activity, dt);
      const double energy =
        kinetic_energy(body.topology, body.state, dt).value() +
        body.force.strain_energy(body.state).value();
      EXPECT_NEAR(motion.work().sum().value(), energy, 1e-5 * energy);
      advance(body.state, body.activity, dt);
    }
  double speed_squared = 0;
  for (const auto &v : body.state.velocity)
    speed_squared = std::max(speed_squared, dot(v.vector(), v.vector()));
  EXPECT_GT(motion.work().sum().value(), .2 * 8 * 2641 * speed_squared);
}

TEST(PrescribedMotion, MovesNodesThatACrackHasMade)
{
  Bar              bar;
  ElasticBody     &body = bar.body;
  const Surface    end  = bar.end(0);
  PrescribedMotion motion(body.topology, {{end, velocity({{"", "", "7"}})}});
  SurfaceLoad      load(body.topology, end, pressure("1e6"));
  std::vector<FaceIndex> all;
  for (FaceIndex face = 0; face < body.topology.faces.size(); ++face)
    all.push_back(face);
  const TopologyChange change = split_nodes(body.topology, all);
  body.state.grow(change);
  for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
    body.state.mass[i] =
      lumped_mass(body.topology, body.discrete.reference, {2641}, i);
  body.activity.grow(body.state.n_nodes());
  motion.update_nodes();
  load.update_nodes();

  load.add_to(body.state, body.activity, bar.dt);
  EXPECT_NEAR(resultant(body.state)[2], 1e6, 1e-8);
  motion.impose(body.state, body.activity, bar.dt);
  advance(body.state, body.activity, bar.dt);
  // Two triangles at the end, of loose cells: six nodes.
  const auto nodes = surface_nodes(body.topology, end);
  EXPECT_EQ(nodes.size(), 6u);
  for (NodeIndex i = 0; i < body.state.n_nodes(); ++i)
    EXPECT_NEAR(body.state.velocity[i][2],
                std::binary_search(nodes.begin(), nodes.end(), i) ? 7 : 0,
                1e-14);
}

TEST(Gravity, FreeFall)
{
  ElasticBody     body(make_box({{2, 1, 2}}, 1, .1), granite());
  const double    dt = .5 * body.critical_step();
  const BodyForce gravity(Vector3<double>{{1, 2, -9.81}});
  const double    mass = 4 * 2641, g_squared = 1 + 4 + 9.81 * 9.81;
  for (unsigned int n = 0; n <= 500; ++n)
    {
      EXPECT_FALSE(body.force.add_to(body.state, body.activity));
      gravity.add_to(body.state);
      if (n == 0)
        {
          EXPECT_NEAR(norm(resultant(body.state)),
                      mass * std::sqrt(g_squared),
                      1e-12 * mass * 10);
          start_velocities(body.state, dt);
        }
      // Energy m v^- v^+ / 2 and drop are exact: v = g t, u = g t^2 / 2.
      const double t = body.state.time, scale = mass * g_squared;
      EXPECT_NEAR(gravity.work(body.topology, body.state).value(),
                  .5 * scale * t * t,
                  1e-11 * scale * t * t);
      EXPECT_NEAR(kinetic_energy(body.topology, body.state, dt).value(),
                  .5 * scale * (t * t - .25 * dt * dt),
                  1e-11 * scale * (t * t + dt * dt));
      advance(body.state, body.activity, dt);
    }
}
