// The pulses of prm/barre/block_*.prm against Christoffel's equation.

#include "../temporary_directory.h"

#include <deal.II/base/tensor.h>

#include <rift/app/simulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

using namespace rift;

namespace
{
  /** Velocities over time at one point, along the polarisations of the three
   * waves. */
  struct History
  {
    std::vector<double>                time;
    std::vector<std::array<double, 3>> velocity;
  };

  /** Speeds and polarisations from an independent program (numpy); in the frame
   * of the mesh, the fastest wave first. */
  constexpr std::array<double, 3> speeds = {{4067.963, 2668.136, 2539.226}};
  const std::array<Vector3<double>, 3> polarisations = {
    {{{0.986103, 0.116003, 0.118929}},
     {{-0.144334, 0.952683, 0.267511}},
     {{-0.082269, -0.280959, 0.956187}}}};

  /** Columns of probes.csv, the first of which holds the velocity along x. */
  History
  read_history(const std::string &path, const unsigned int first_column)
  {
    History            history;
    std::istringstream file(read_file(path));
    std::string        line;
    std::getline(file, line);
    while (std::getline(file, line))
      {
        std::vector<double> values;
        std::istringstream  row(line);
        for (std::string cell; std::getline(row, cell, ',');)
          values.push_back(std::stod(cell));
        history.time.push_back(values.at(0));
        history.velocity.emplace_back();
        for (unsigned int wave = 0; wave < 3; ++wave)
          {
            double along = 0;
            for (unsigned int d = 0; d < dim; ++d)
              along += polarisations[wave][d] * values.at(first_column + d);
            history.velocity.back()[wave] = along;
          }
      }
    return history;
  }

  /** A pulse has its top where the parabola through what is above half of its
   * largest velocity has it. */
  struct Pulse
  {
    double time, largest;

    /** Largest velocity of the other waves until the pulse has fallen to half;
     * what comes later may have been disturbed from the sides. */
    double others;
  };

  Pulse
  find_pulse(const History &history, const unsigned int wave)
  {
    const auto &velocity = history.velocity;
    const auto  less     = [wave](const auto &a, const auto &b) {
      return a[wave] < b[wave];
    };
    const std::size_t top =
      std::max_element(velocity.begin(), velocity.end(), less) -
      velocity.begin();
    Pulse        pulse{0, velocity[top][wave], 0};
    const double level = .5 * pulse.largest;
    std::size_t  first = top, last = top;
    while (first > 0 && velocity[first - 1][wave] > level)
      --first;
    while (last + 1 < velocity.size() && velocity[last + 1][wave] > level)
      ++last;
    if (first == 0 || last + 1 == velocity.size() || last - first < 6)
      throw std::runtime_error("no pulse has come and gone");

    // Least squares, times from the top in steps. With weights, so that it
    // does not matter which row is the first above.
    dealii::Tensor<2, 3> matrix;
    dealii::Tensor<1, 3> right;
    for (std::size_t i = first; i <= last; ++i)
      {
        const double s = static_cast<double>(i) - static_cast<double>(top);
        const double v = velocity[i][wave];
        const dealii::Tensor<1, 3> powers({1, s, s * s});
        matrix += (v - level) * outer_product(powers, powers);
        right += (v - level) * v * powers;
      }
    const dealii::Tensor<1, 3> parabola = invert(matrix) * right;
    const double               step = history.time[top] - history.time[top - 1];
    pulse.time = history.time[top] - step * parabola[1] / (2 * parabola[2]);
    for (std::size_t i = 0; i <= last; ++i)
      for (unsigned int other = 0; other < 3; ++other)
        if (other != wave)
          pulse.others = std::max(pulse.others, std::abs(velocity[i][other]));
    return pulse;
  }

  /** Sends the pulse of a wave and compares its speed.
   * @param cells edge of the cubes that the cells come from, m. */
  void
  send(const std::string &scene,
       const unsigned int wave,
       const std::string &cells = "1.2e-3")
  {
    TemporaryDirectory directory;
    Parameters         parameters =
      read_parameters(RIFT_SOURCE_DIRECTORY "/prm/barre/" + scene,
                      {"Mesh/Element size=" + cells});
    parameters.output.directory = directory / "results";
    Log        log(nullptr);
    Simulation simulation(parameters, log);
    simulation.run();

    const std::string table = directory / "results/probes.csv";
    const Pulse       near  = find_pulse(read_history(table, 1), wave);
    const Pulse       far   = find_pulse(read_history(table, 4), wave);
    const double      distance =
      parameters.probes.at(3).point[0] - parameters.probes.at(0).point[0];
    EXPECT_NEAR(distance / (far.time - near.time) / speeds[wave], 1, .005);
    // It has the velocity of the load over the impedance, and runs alone.
    for (const Pulse &pulse : {near, far})
      {
        EXPECT_NEAR(pulse.largest * 2610 * speeds[wave], 1e6, 1e4);
        EXPECT_LT(pulse.others, 1e-3 * pulse.largest);
      }
  }
} // namespace

TEST(BarreBlock, SpeedOfThePWave)
{
  send("block_p.prm", 0, "1.6e-3");
}

TEST(BarreBlock, SpeedOfTheFasterSWave)
{
  send("block_s1.prm", 1);
}

TEST(BarreBlock, SpeedOfTheSlowerSWave)
{
  send("block_s2.prm", 2);
}
