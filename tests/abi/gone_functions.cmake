# Functions that have left the interface do not compile any more, and the message names them.
# Arguments: CC, CXX (compilers), INCLUDE (folder of the headers), WORK (a folder to write to).
set(text "#include <wrcontact.h>
int main(void) {
  wrc_solver* solver = 0;
  CALL
  return wrc_solver_error(solver) == 0;
}
")
set(calls "wrc_solver_forget|wrc_solver_forget(solver, 0)\\;"
  "wrc_measure_transform|double time\\; wrc_measure_transform(8, 8, 1, &time)\\;"
  "|wrc_solver_clear(solver)\\;")
foreach(pair IN LISTS calls)
  string(REGEX REPLACE "\\|.*" "" name "${pair}")
  string(REGEX REPLACE "^[^|]*\\|" "" call "${pair}")
  foreach(language c cpp)
    string(REPLACE CALL "${call}" program "${text}")
    file(WRITE ${WORK}/program.${language} "${program}")
    if(language STREQUAL c)
      set(command ${CC} -std=c99 -pedantic-errors)
    else()
      set(command ${CXX})
    endif()
    execute_process(COMMAND ${command} -fsyntax-only -I${INCLUDE} ${WORK}/program.${language}
      RESULT_VARIABLE status ERROR_VARIABLE messages)
    if(name STREQUAL "" AND NOT status EQUAL 0)
      message(SEND_ERROR "a program of now does not compile: ${messages}")
    elseif(NOT name STREQUAL "" AND (status EQUAL 0 OR NOT messages MATCHES "error: [^\n]*${name}"))
      message(SEND_ERROR "${language}: ${name} compiles, or the message does not name it: ${messages}")
    endif()
  endforeach()
endforeach()
