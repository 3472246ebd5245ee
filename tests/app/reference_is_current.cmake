# Fails when FILE is not what "RIFT --reference" prints.
execute_process(COMMAND ${RIFT} --reference RESULT_VARIABLE code
  OUTPUT_VARIABLE printed)
file(READ ${FILE} current)
if(NOT code EQUAL 0 OR NOT printed STREQUAL current)
  message(FATAL_ERROR
    "doc/parameters.md is stale: rift --reference > doc/parameters.md")
endif()
