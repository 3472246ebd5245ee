# Runs shattered_cylinder.prm, which is to end well, with a warning.
#
#   cmake -D RIFT=... -D SCENE=... -P unpaid_energy.cmake
execute_process(COMMAND ${RIFT} ${SCENE}
  RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
set(warning
  "WARNING: the balance has a cohesive energy of -0[.][0-9]+ J: so much has")
if(NOT code EQUAL 0 OR NOT output MATCHES "${warning}")
  message(FATAL_ERROR
    "rift returned ${code}, or did not say ${warning}:\n${output}")
endif()
