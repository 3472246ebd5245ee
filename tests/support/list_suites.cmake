# Writes a file for ctest with a test for each suite of a googletest program, or
# one for each suite and number of ranks.
#
#   cmake -D PROGRAM=... -D PREFIX=... -D RANKS=... -D MPIEXEC=...
#     -D ENVIRONMENT=... -D LIST=... -P list_suites.cmake
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE output
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+\\." suites "${output}")
set(text)
function(add name n_processors)
  string(APPEND text "add_test([=[${name}]=]")
  foreach(argument ${ARGN})
    string(APPEND text " [=[${argument}]=]")
  endforeach()
  string(APPEND text ")\nset_tests_properties([=[${name}]=] PROPERTIES TIMEOUT 120"
    " LABELS checked PROCESSORS ${n_processors} ENVIRONMENT"
    " [=[${ENVIRONMENT}]=])\n")
  set(text "${text}" PARENT_SCOPE)
endfunction()
foreach(suite ${suites})
  string(STRIP "${suite}" suite)
  string(REGEX REPLACE "\\.$" "" suite "${suite}")
  set(command ${PROGRAM} --gtest_filter=${suite}.*)
  if(NOT RANKS)
    add(${PREFIX}/${suite} 1 ${command})
  endif()
  foreach(n ${RANKS})
    add(${PREFIX}/${suite}/mpirun=${n} ${n}
      ${MPIEXEC} -np ${n} --oversubscribe ${command})
  endforeach()
endforeach()
if(NOT text)
  message(FATAL_ERROR "${PROGRAM} has no tests")
endif()
file(WRITE ${LIST} "${text}")
