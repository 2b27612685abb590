# Fails unless PROGRAM stops with a non-zero status and the library's text on stderr.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE out ERROR_VARIABLE error RESULT_VARIABLE status)
if(status EQUAL 0 OR out MATCHES "went on")
  message(FATAL_ERROR "the failure did not end the program: ${out}")
endif()
if(NOT error MATCHES "wrcontact: unknown key pose.sideways")
  message(FATAL_ERROR "the text is missing: ${error}")
endif()
