#include "shaken_cells.h"

using namespace rift;
using namespace rift::test;

namespace
{
  Outcome
  check(const Body &shape, const double reach, const double tolerance)
  {
    return check_shaken(shape, reach, tolerance, "faces");
  }
} // namespace

// Softened, mostly; softened a lot; failed at once.
TEST(Stability, TwoCells)
{
  EXPECT_EQ(check(two_cells(), 3e-6, 1e-6).n_failed, 0u);
  EXPECT_EQ(check(two_cells(), 1e-5, 1e-5).n_failed, 0u);
  const Outcome failed = check(two_cells(), 5e-5, 1e-3);
  EXPECT_EQ(failed.n_failed, 1u);
  EXPECT_GT(failed.n_reversals, 50u);
}

TEST(Stability, CellSurroundedByFour)
{
  EXPECT_EQ(check(five_cells(), 2e-6, 1e-5).n_failed, 0u);
  EXPECT_EQ(check(five_cells(), 1e-5, 1e-4).n_failed, 4u);
  const Outcome failed = check(five_cells(), 5e-5, 1e-3);
  EXPECT_EQ(failed.n_failed, 4u);
  EXPECT_GT(failed.n_reversals, 50u);
}
