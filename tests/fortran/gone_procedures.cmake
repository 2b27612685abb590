# Procedures that have left the module do not compile any more, and the message names them.
# Arguments: COMPILER, MODULES (folder of wrcontact.mod), WORK (a folder to write to).
set(program_forget "use wrcontact, only: contact_solver
type(contact_solver) :: solver
call solver%forget(.true.)
end
")
set(program_measure_transform "use wrcontact, only: measure_transform
print *, measure_transform(8, 8, 1)
end
")
set(program_clear "use wrcontact, only: contact_solver
type(contact_solver) :: solver
call solver%clear()
end
")
foreach(name forget measure_transform clear)
  file(WRITE ${WORK}/${name}.f90 "${program_${name}}")
  execute_process(COMMAND ${COMPILER} -fsyntax-only -I${MODULES} ${WORK}/${name}.f90
    RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(name STREQUAL clear AND NOT status EQUAL 0)
    message(SEND_ERROR "a program of now does not compile: ${messages}")
  elseif(NOT name STREQUAL clear AND (status EQUAL 0 OR NOT messages MATCHES "Error: [^\n]*${name}"))
    message(SEND_ERROR "${name} compiles, or the message does not name it: ${messages}")
  endif()
endforeach()
