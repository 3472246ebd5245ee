#include <rift/app/elasticity_tool.h>
#include <rift/base/exceptions.h>

#include <iostream>

int
main(int argc, char **argv)
{
  try
    {
      rift::run_elasticity_tool(argc, argv, std::cout);
      if (!std::cout.flush())
        throw rift::DiskError("cannot write to the standard output.");
    }
  catch (const rift::Error &error)
    {
      std::cerr << "rift-elasticity: error: " << error.what() << '\n';
      return static_cast<int>(error.exit_code);
    }
  return 0;
}
