# Takes the program in LANGUAGE from DOCUMENT, compiles it by the command that stands below it, with
# the staged installation PREFIX for $W, in an empty FOLDER, runs it, and compares all digits of what
# it prints with what WRC_CASE prints for the same scene. OPTIONS are added to the command.
# With BUILT_LAYER the F77 layer is linked as it was built, in place of its source.
# With REFUSED the program must fail instead, and print that. COMPILER replaces gfortran.
cmake_minimum_required(VERSION 3.25)
file(READ ${PROJECT}/${DOCUMENT} text)
if(MARK)
  string(REGEX REPLACE ".*<!-- program: ${MARK} -->" "" text "${text}")
endif()
string(REGEX MATCH "```${LANGUAGE}\n([^`]*)```\n\n```\n([^`]*)\n```" found "${text}")
if(NOT found)
  message(FATAL_ERROR "${DOCUMENT} has no program in ${LANGUAGE} with a command below it")
endif()
set(program "${CMAKE_MATCH_1}")
string(REPLACE "$W" "${PREFIX}" command "${CMAKE_MATCH_2}")
if(BUILT_LAYER)
  string(REGEX REPLACE "[^ ]*/wrcontact_f77.f90 (.*) -lwrcontact " "\\1 -lwrcontact_f77 -lwrcontact " command "${command}")
endif()
if(COMPILER)
  string(REGEX REPLACE "gfortran( -std=legacy)?" "${COMPILER}" command "${command}")
endif()
if(NOT command MATCHES "(program\\.[a-z0-9]+)")
  message(FATAL_ERROR "no program in the command: ${command}")
endif()
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
file(WRITE ${FOLDER}/${CMAKE_MATCH_1} "${program}")
set(run ./a.out)
if(LANGUAGE STREQUAL matlab) # nothing to compile
  set(run sh -c "${command}")
else()
  execute_process(COMMAND sh -c "${command} ${OPTIONS}" WORKING_DIRECTORY ${FOLDER}
    COMMAND_ERROR_IS_FATAL ANY)
endif()
if(REFUSED)
  execute_process(COMMAND ./a.out WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE printed
    RESULT_VARIABLE status)
  string(FIND "${printed}" "${REFUSED}" place)
  if(status EQUAL 0 OR place EQUAL -1 OR printed MATCHES "pmax")
    message(FATAL_ERROR "${DOCUMENT}: with ${OPTIONS} the program ends with ${status}: ${printed}")
  endif()
  return()
endif()
execute_process(COMMAND ${run} WORKING_DIRECTORY ${FOLDER} OUTPUT_VARIABLE printed
  COMMAND_ERROR_IS_FATAL ANY)

if(MARK)
  string(REGEX MATCH "prints\n\n```\n([^`]*)```" found "${text}")
  file(WRITE ${FOLDER}/shown "${CMAKE_MATCH_1}")
  file(WRITE ${FOLDER}/printed "${printed}")
  execute_process(WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE differs COMMAND awk [[
    NR == FNR { shown[FNR] = $0; lines = FNR; next }
    {
      n = split($0, word); m = split(shown[FNR], other)
      if (n != m) { exit bad = 1 }
      for (i = 1; i <= n; ++i) {
        unit = other[i] ~ /\./ ? 10 ^ -length(substr(other[i], index(other[i], ".") + 1)) : 0
        difference = word[i] - other[i]
        if (word[i] != other[i] && !(difference * difference < 2 * unit * unit)) { exit bad = 1 }
      }
    }
    END { exit bad || FNR != lines }]] shown printed)
  if(differs)
    message(FATAL_ERROR "${DOCUMENT}: the program prints\n${printed}")
  endif()
  return()
endif()

# The numbers have 17 significant digits, in other notations: awk compares them as numbers.
execute_process(COMMAND ${WRC_CASE} --set pose.lateral=3 --json OUTPUT_VARIABLE json
  COMMAND_ERROR_IS_FATAL ANY)
string(JSON expected GET "${json}" left pmax)
if(NOT printed MATCHES "pmax = +([0-9]\\.[0-9]+[Ee][+]03) MPa")
  message(FATAL_ERROR "no pmax of 17 digits in: ${printed}")
endif()
execute_process(COMMAND awk "BEGIN { exit !(${CMAKE_MATCH_1} == ${expected}) }" RESULT_VARIABLE differs)
if(differs)
  message(FATAL_ERROR "${DOCUMENT}: printed ${CMAKE_MATCH_1}, wrc_case says ${expected}")
endif()
