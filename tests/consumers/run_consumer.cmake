# Builds the program of a LANGUAGE (c, cxx, fortran, f77, f77_from_c) against the installation at PREFIX in a WAY,
# in an empty folder, runs it and compares what it prints with wrc_case.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
set(libraries ${PREFIX}/${LIBDIR})
set(ENV{PKG_CONFIG_PATH} ${libraries}/pkgconfig)

set(entry wrcontact) # of pkg-config
if(LANGUAGE STREQUAL fortran)
  set(entry wrcontact-fortran)
elseif(LANGUAGE MATCHES "f77")
  set(entry wrcontact-f77)
endif()
function(ask_pkg_config result)
  execute_process(COMMAND pkg-config ${ARGN} ${entry} OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  set(${result} ${flags} PARENT_SCOPE)
endfunction()

if(LANGUAGE STREQUAL fortran)
  set(compile ${FORTRAN_COMPILER} ${SOURCES}/program.f90)
  set(module_library wrcontact_fortran)
elseif(LANGUAGE STREQUAL f77_from_c)
  # A linker that does not know the compiler of the layer, as flang's.
  set(compile ${C_COMPILER} ${SOURCES}/program_f77.c)
else()
  set(compile ${C_COMPILER} ${SOURCES}/program.c)
  set(module_library)
endif()
set(rpath -Wl,-rpath,${libraries})
if(WAY STREQUAL pkg-config)
  ask_pkg_config(flags --cflags --libs)
  list(APPEND compile ${flags})
  if(UNPACKED) # packages for the folders of the system
    list(APPEND compile ${rpath})
  endif()
elseif(WAY STREQUAL compiler)
  list(TRANSFORM module_library PREPEND -l)
  list(APPEND compile -I${MODULES} -I${PREFIX}/include -L${libraries} ${module_library} -lwrcontact
    ${rpath})
elseif(WAY STREQUAL static)
  # The archive, everything else shared.
  ask_pkg_config(flags --static --cflags --libs)
  list(TRANSFORM flags REPLACE "^-lwrcontact$" ${libraries}/libwrcontact.a)
  list(APPEND compile ${flags})
elseif(WAY STREQUAL all_static)
  ask_pkg_config(flags --static --cflags --libs)
  list(APPEND compile -static ${flags})
else()
  set(static OFF)
  if(WAY STREQUAL find_package_static)
    set(static ON)
  endif()
  if(LANGUAGE STREQUAL fortran)
    set(compiler -DCMAKE_Fortran_COMPILER=${FORTRAN_COMPILER})
  else()
    set(compiler -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
  endif()
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${SOURCES} -B ${FOLDER} -G ${GENERATOR} -DLANGUAGE=${LANGUAGE} -DSTATIC=${static}
      -DCMAKE_PREFIX_PATH=${PREFIX} -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_C_COMPILER=${C_COMPILER} ${compiler}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(compile ${CMAKE_COMMAND} --build ${FOLDER})
endif()
execute_process(COMMAND ${compile} WORKING_DIRECTORY ${FOLDER} OUTPUT_QUIET
  COMMAND_ERROR_IS_FATAL ANY)
if(WAY MATCHES "find_package")
  file(COPY_FILE ${FOLDER}/program ${FOLDER}/a.out)
endif()
execute_process(COMMAND ./a.out WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE printed
  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(WAY MATCHES "static")
  execute_process(COMMAND ldd ${FOLDER}/a.out OUTPUT_VARIABLE linked ERROR_VARIABLE linked)
  if(linked MATCHES "libwrcontact" OR NOT linked MATCHES "libc\\.so|not a dynamic executable")
    message(FATAL_ERROR "linked against the shared library: ${linked}")
  endif()
endif()

execute_process(COMMAND ${CASE} --set pose.lateral=3 --json OUTPUT_VARIABLE answer
  COMMAND_ERROR_IS_FATAL ANY)
string(JSON expected GET "${answer}" left pmax)
execute_process(COMMAND awk "BEGIN { exit !(${printed} == ${expected}) }" RESULT_VARIABLE differs)
if(differs OR NOT printed MATCHES "^ *[0-9]+\\.[0-9]+")
  message(FATAL_ERROR "printed was ${printed}, wrc_case says ${expected}")
endif()
