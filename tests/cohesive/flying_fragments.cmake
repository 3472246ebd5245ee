# Runs flying_fragments.prm and looks at the balance of its energies.
#
#   cmake -D RIFT=... -D SCENE=... -P flying_fragments.cmake
execute_process(COMMAND ${RIFT} ${SCENE}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "rift returned ${code}:\n${output}")
endif()
file(READ flying_fragments_results/summary.json summary)
string(JSON residual GET "${summary}" energy_residual_relative)
string(JSON fragments GET "${summary}" fragments)
message("residual ${residual}, ${fragments} fragments")
# CMake compares numbers with exponents as numbers.
if(NOT residual LESS 1e-5)
  message(FATAL_ERROR "the balance of energies is off by ${residual}")
endif()
if(NOT fragments GREATER 3)
  message(FATAL_ERROR "only ${fragments} fragments")
endif()
