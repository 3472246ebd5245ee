# Runs SCENE with RIFT twice in FOLDER: without a cohesive model, and with one
# whose strength is never reached. Fails unless both end in the same state to
# the last bit. LAW: of the cohesive model, if not the one by default.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})

# run(NAME OPTIONS...) sets NAME_hash and NAME_inserted.
function(run name)
  execute_process(COMMAND ${RIFT} ${SCENE} --output ${FOLDER}/${name} ${ARGN}
    RESULT_VARIABLE code OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "rift returned ${code}:\n${printed}")
  endif()
  file(READ ${FOLDER}/${name}/summary.json summary)
  string(JSON hash GET ${summary} state_hash)
  string(JSON inserted GET ${summary} faces_inserted)
  set(${name}_hash ${hash} PARENT_SCOPE)
  set(${name}_inserted ${inserted} PARENT_SCOPE)
endfunction()

set(rock "Material rock")
set(breakable
  --set "Fracture/Cohesive model=extrinsic"
  --set "${rock}/Cohesion=60e6"
  --set "${rock}/Friction angle=50"
  --set "${rock}/Fracture energy I=400"
  --set "${rock}/Fracture energy II=400")

if(LAW)
  list(APPEND breakable --set "Fracture/Cohesive law=${LAW}")
endif()

run(plain)
run(strong ${breakable} --set "${rock}/Tensile strength=60e6")
run(weak ${breakable} --set "${rock}/Tensile strength=5e6")

if(NOT strong_inserted EQUAL 0 OR NOT strong_hash STREQUAL plain_hash)
  message(FATAL_ERROR "With a strength that is never reached "
    "${strong_inserted} faces were cut and the state is ${strong_hash}, "
    "without a cohesive model it is ${plain_hash}")
endif()
# The comparison can fail.
if(weak_inserted EQUAL 0 OR weak_hash STREQUAL plain_hash)
  message(FATAL_ERROR "A weak rock does not break, or no difference is seen")
endif()
