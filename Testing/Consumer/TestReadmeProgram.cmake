# SPDX-License-Identifier: BSD-3-Clause
# The README shows examples/MinimalSSAO.cxx word for word (but for the licence line), in under 40
# lines.
cmake_minimum_required(VERSION 3.18)

file(READ "${PACKAGE_SOURCE}/README.md" readme)
file(READ "${PACKAGE_SOURCE}/examples/MinimalSSAO.cxx" program)
string(REGEX REPLACE "^// SPDX[^\n]*\n" "" program "${program}")
string(FIND "${readme}" "```cpp\n${program}```" place)
if (place EQUAL -1)
  message(FATAL_ERROR "README.md does not contain examples/MinimalSSAO.cxx as it is")
endif ()

string(REGEX MATCHALL "\n" lines "${program}")
list(LENGTH lines count)
if (NOT count LESS 40)
  message(FATAL_ERROR "examples/MinimalSSAO.cxx has ${count} lines; fewer than 40 are promised")
endif ()
message(STATUS "README.md shows the program of ${count} lines")
