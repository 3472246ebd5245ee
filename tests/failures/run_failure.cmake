# Runs rift on a bad scene and compares exit code and error message exactly.
#
#   cmake -D RIFT=... -D MPIEXEC=... -D CASES=... -D NAME=... -D FOLDER=...
#     -P run_failure.cmake
#
# RIFT is the program, MPIEXEC what starts it on several ranks, CASES the folder
# of the cases, NAME the case, FOLDER a folder to run in. See README.md beside
# this file for what belongs to a case.

# The case's own folder, so that messages show relative paths and a case can
# leave something behind. In it are its files and those that belong to no case.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(GLOB names RELATIVE ${CASES} ${CASES}/*)
foreach(name ${names})
  string(REGEX REPLACE "\\..*" "" case ${name})
  if(case STREQUAL NAME OR NOT EXISTS ${CASES}/${case}.error)
    file(CREATE_LINK ${CASES}/${name} ${FOLDER}/${name} SYMBOLIC)
  endif()
endforeach()

set(arguments ${NAME}.prm)
if(EXISTS ${CASES}/${NAME}.args)
  file(STRINGS ${CASES}/${NAME}.args arguments)
endif()
if(EXISTS ${CASES}/${NAME}.sh)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env RIFT=${RIFT} bash ${NAME}.sh
    WORKING_DIRECTORY ${FOLDER}
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${NAME}.sh failed:\n${output}")
  endif()
endif()

file(READ ${CASES}/${NAME}.error expected)
set(command ${RIFT})
if(EXISTS ${CASES}/${NAME}.limit)
  # MPI is told to make no files of its own for shared memory.
  file(STRINGS ${CASES}/${NAME}.limit limit)
  set(command ${CMAKE_COMMAND} -E env PMIX_MCA_gds=hash OMPI_MCA_btl=self
    bash -c "ulimit -f ${limit} && exec \"$@\"" limited
    ${RIFT})
endif()
if(EXISTS ${CASES}/${NAME}.ranks)
  # Quiet, so that only rift speaks.
  file(STRINGS ${CASES}/${NAME}.ranks ranks)
  set(command ${CMAKE_COMMAND} -E env OMPI_ALLOW_RUN_AS_ROOT=1
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 ${MPIEXEC} -q -np ${ranks} --oversubscribe
    ${RIFT})
endif()
execute_process(COMMAND ${command} ${arguments} WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE error)
if(NOT "${code}\n${error}" STREQUAL "${expected}")
  message(FATAL_ERROR "${NAME}: rift returned and said\n${code}\n${error}\n"
    "but should have returned and said\n${expected}")
endif()
