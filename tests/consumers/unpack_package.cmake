# Makes the Debian package and unpacks it into FOLDER.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${CPACK} -G DEB -B ${FOLDER} WORKING_DIRECTORY ${BUILD}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB package ${FOLDER}/*.deb)
execute_process(COMMAND ${DPKG} -x ${package} ${FOLDER} COMMAND_ERROR_IS_FATAL ANY)
