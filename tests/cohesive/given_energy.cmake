# Runs shattered_cylinder.prm, which is to end well, with a warning.
#
#   cmake -D RIFT=... -D SCENE=... -P given_energy.cmake
execute_process(COMMAND ${RIFT} ${SCENE}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
set(warning
  "WARNING: faces that broke while they were compressed have given 0[.][0-9]+ J to")
if(NOT code EQUAL 0 OR NOT output MATCHES "${warning}")
  message(FATAL_ERROR
    "rift returned ${code}, or did not say ${warning}:\n${output}")
endif()
