# SPDX-License-Identifier: BSD-3-Clause
# Runs an example and looks at the pictures it wrote:
#   cmake -D FOLDER=<folder> -D PICTURES=<a.png,b.png> -P RunExample.cmake -- <program> ...
# The program runs in FOLDER, which is emptied before. It must print nothing on stderr and write
# exactly PICTURES: PNGs, all different, and larger than ones of a single colour are.
cmake_minimum_required(VERSION 3.18)

set(command)
foreach (i RANGE ${CMAKE_ARGC})
  if (DEFINED separator_seen)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif ("${CMAKE_ARGV${i}}" STREQUAL "--")
    set(separator_seen TRUE)
  endif ()
endforeach ()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
execute_process(
  COMMAND ${command}
  WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE result
  OUTPUT_VARIABLE output
  ERROR_VARIABLE error)
message(STATUS "${output}")
if (NOT result EQUAL 0)
  message(FATAL_ERROR "exit code ${result}: ${error}")
elseif (NOT error STREQUAL "")
  message(FATAL_ERROR "text on stderr: ${error}")
endif ()

string(REPLACE "," ";" expected "${PICTURES}")
file(GLOB_RECURSE written RELATIVE "${FOLDER}" "${FOLDER}/*")
list(SORT expected)
list(SORT written)
if (NOT written STREQUAL expected)
  message(FATAL_ERROR "wrote '${written}', not '${expected}'")
endif ()
set(sums)
foreach (picture IN LISTS expected)
  file(READ "${FOLDER}/${picture}" signature LIMIT 8 HEX)
  file(SIZE "${FOLDER}/${picture}" size)
  file(READ "${FOLDER}/${picture}" size_fields OFFSET 16 LIMIT 8 HEX)
  string(SUBSTRING "${size_fields}" 0 8 width)
  string(SUBSTRING "${size_fields}" 8 8 height)
  math(EXPR least "1000 + 0x0${width} * 0x0${height} / 90")
  if (NOT signature STREQUAL "89504e470d0a1a0a" OR size LESS least)
    message(FATAL_ERROR "${picture} is not a PNG with something on it: ${size} bytes")
  endif ()
  file(SHA256 "${FOLDER}/${picture}" sum)
  if (sum IN_LIST sums)
    message(FATAL_ERROR "${picture} shows the same as another one")
  endif ()
  list(APPEND sums ${sum})
endforeach ()
