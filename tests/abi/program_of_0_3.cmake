# A program of 0.3 never runs with the library of now: an object compiled then is refused by the
# linker, with the shared library and with the archive; a program linked then by the loader, also
# where the new library has the old one's name; and one that loads the library at run time does not
# find what it asks for.
# Arguments: CC, SOURCE (program_of_0_3.c), LIBRARY, SONAME (its), ARCHIVE, WORK (a folder to write to).
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/old ${WORK}/beside ${WORK}/new)
execute_process(COMMAND ${CC} -c ${SOURCE} -o ${WORK}/program.o COMMAND_ERROR_IS_FATAL ANY)
foreach(library ${LIBRARY} ${ARCHIVE})
  execute_process(COMMAND ${CC} ${WORK}/program.o ${library} -o ${WORK}/program
    RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(status EQUAL 0 OR NOT messages MATCHES "wrc_scene_create[`']")
    message(SEND_ERROR "linked with ${library}, or for another reason not: ${messages}")
  endif()
endforeach()

# A library of 0.3, as far as the program uses it.
file(WRITE ${WORK}/old.c "
int wrc_scene_create(void** scene) { return scene == 0; }
int wrc_scene_set_number(void* scene, const char* key, double value) { return scene == 0 && key && value > 0.0; }
int wrc_scene_solve(void* scene) { return scene == 0; }
int wrc_scene_number(void* scene, const char* name, double* value) { *value = 50e3; return scene == 0 && name; }
")
file(WRITE ${WORK}/old.map "{ global: wrc_*; local: *; };")
execute_process(COMMAND ${CC} -shared -fPIC ${WORK}/old.c -o ${WORK}/old/libwrcontact.so.0
    -Wl,-soname,libwrcontact.so.0 -Wl,--version-script=${WORK}/old.map COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CC} ${WORK}/program.o ${WORK}/old/libwrcontact.so.0 -o ${WORK}/program
  COMMAND_ERROR_IS_FATAL ANY)
file(CREATE_LINK ${LIBRARY} ${WORK}/beside/${SONAME} SYMBOLIC)
file(CREATE_LINK ${LIBRARY} ${WORK}/new/libwrcontact.so.0 SYMBOLIC) # with the old one's name
foreach(path ${WORK}/old ${WORK}/beside ${WORK}/new)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${path} ${WORK}/program
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE messages)
  if(path STREQUAL ${WORK}/old)
    if(NOT status EQUAL 0 OR NOT output MATCHES "50000 N")
      message(SEND_ERROR "does not run with its own library: ${status} ${messages}")
    endif()
  elseif(status EQUAL 0 OR output MATCHES "N")
    message(SEND_ERROR "runs with ${path}: ${output}")
  endif()
endforeach()
