# Runs PROGRAM in an empty FOLDER with PRELOAD: it must succeed, print nothing and make none of the
# calls that are caught there. Arguments: PROGRAM, COUNT, SEED, THREADS, FOLDER, PRELOAD (may be empty).
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env LD_PRELOAD=${PRELOAD} ${PROGRAM} ${COUNT} ${SEED} 100
    ${THREADS}
  WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE out ERROR_VARIABLE error RESULT_VARIABLE status)
if(EXISTS ${FOLDER}/no_side_effects.txt)
  file(READ ${FOLDER}/no_side_effects.txt calls)
  message(SEND_ERROR "calls of the library: ${calls}")
endif()
if(NOT status EQUAL 0 OR NOT "${out}${error}" STREQUAL "")
  message(FATAL_ERROR "status ${status}, printed: ${out}${error}")
endif()
