#include <rift/io/fragments_file.h>

#include <gtest/gtest.h>

#include "../temporary_directory.h"

using namespace rift;

TEST(FragmentsFile, HasARowForEachFragment)
{
  const TemporaryDirectory directory;
  Fragment                 fragment{3, .5, 1000, {{1, 2, 3}}, {}, {{4, 5, 6}}};
  write_fragments(directory / "f.csv", {fragment, fragment});
  EXPECT_EQ(read_file(directory / "f.csv"),
            "fragment,cells,volume [m^3],mass [kg],x [m],y [m],z [m],"
            "velocity x [m/s],velocity y [m/s],velocity z [m/s]\n"
            "0,3,0.5,1000,1,2,3,4,5,6\n"
            "1,3,0.5,1000,1,2,3,4,5,6\n");
}
