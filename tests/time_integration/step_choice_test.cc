#include <rift/time_integration/step_choice.h>

#include <gtest/gtest.h>

using namespace rift;

namespace
{
  CriticalTimeStep
  bound(const double time_step, const double mean)
  {
    return {time_step, 4 / (time_step * time_step), mean, 17, "cell 17"};
  }
} // namespace

TEST(StepChoice, WarnsOfNothingThatIsUsual)
{
  EXPECT_TRUE(warnings({.9e-7, 1000}, bound(1e-7, .99e-6)).empty());
}

TEST(StepChoice, WarnsOfACellThatIsMuchSmallerThanOthers)
{
  EXPECT_EQ(
    warnings({.9e-7, 1000}, bound(1e-7, 1.25e-6)),
    std::vector<std::string>{
      "the smallest or flattest cell, 17 of the mesh, allows 0.08 times the "
      "time step that cells allow on average, so that the run takes so many "
      "more steps. Is it a sliver? Try another \"Element size\", or "
      "\"Mesh.Algorithm3D = 10;\" in the .geo."});
}

TEST(StepChoice, WarnsOfManyStepsAndOfStepsAboveTheBound)
{
  EXPECT_EQ(warnings({1e-7, 1000000000}, bound(1e-7, 1e-7)),
            std::vector<std::string>{
              "these are many steps. Is the end time in seconds?"});
  EXPECT_EQ(warnings({1.01e-7, 1000}, bound(1e-7, 1e-7)),
            std::vector<std::string>{"the time step is above the bound at "
                                     "which it is sure to be stable"});
}
