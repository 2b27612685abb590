# Functions that have left the interface: a compiler refuses each with its successor, as the table of
# removed names (cxx_core/keys/removed_names.hpp) has it.
# Arguments: CC, CXX (compilers), INCLUDE (folder of the headers), TABLE (that file), WORK (a folder to
# write to).
set(call_of_wrc_solver_forget "wrc_solver_forget(solver, 0);")
set(call_of_wrc_measure_transform "double time; wrc_measure_transform(8, 8, 1, &time);")
set(call_of_none "wrc_solver_clear(solver);")
file(READ ${TABLE} table)
string(REGEX MATCHALL "NameOf::function, \"wrc_[^;\n]*" entries "${table}")
if(NOT entries)
  message(FATAL_ERROR "${TABLE} has no removed function")
endif()
foreach(entry IN LISTS entries ITEMS "NameOf::function, \"none\", \"\"}")
  if(NOT entry MATCHES "^NameOf::function, \"([a-z_]+)\", \"([^\"]*)\"")
    message(FATAL_ERROR "not understood: ${entry}")
  endif()
  set(name ${CMAKE_MATCH_1})
  set(successor "${CMAKE_MATCH_2}")
  foreach(language c cpp)
    file(WRITE ${WORK}/program.${language} "#include <wrcontact.h>
int main(void) {
  wrc_solver* solver = 0;
  ${call_of_${name}}
  return wrc_solver_error(solver) == 0;
}
")
    if(language STREQUAL c)
      set(command ${CC} -std=c99 -pedantic-errors -Wall -Wextra -Wstrict-prototypes -Werror)
    else()
      set(command ${CXX} -Wall -Wextra -Werror)
    endif()
    execute_process(COMMAND ${command} -c -o ${WORK}/program.o -I${INCLUDE} ${WORK}/program.${language}
      RESULT_VARIABLE status ERROR_VARIABLE messages)
    if(name STREQUAL none AND NOT status EQUAL 0)
      message(SEND_ERROR "a program of now does not compile: ${messages}")
    elseif(NOT name STREQUAL none AND
           (status EQUAL 0 OR NOT messages MATCHES "error: [^\n]*${name}[^\n]*${successor}"))
      message(SEND_ERROR "${language}: ${name} compiles, or the message does not say \"${successor}\": ${messages}")
    endif()
  endforeach()
endforeach()
