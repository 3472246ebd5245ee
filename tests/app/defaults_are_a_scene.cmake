# Fails unless "RIFT --validate" accepts what "RIFT --defaults" prints.
execute_process(COMMAND ${RIFT} --defaults RESULT_VARIABLE code
  OUTPUT_FILE ${FILE})
if(NOT code EQUAL 0)
  message(FATAL_ERROR "rift --defaults returned ${code}")
endif()
execute_process(COMMAND ${RIFT} --validate ${FILE} RESULT_VARIABLE code
  OUTPUT_VARIABLE printed)
if(NOT code EQUAL 0 OR NOT printed MATCHES "materials:  rock")
  message(FATAL_ERROR "rift --validate returned ${code}:\n${printed}")
endif()
