# SPDX-License-Identifier: BSD-3-Clause
# Installs a build, moves the installation, and builds and runs the project in this folder with it.
# AddTest.cmake passes the variables. With PACKAGE_STATIC the module is built as a static library
# first, without debugging information, and one program is built and run with it.
cmake_minimum_required(VERSION 3.18)

set(prefix "${WORK}/moved to/here") # with a space, too
set(consumer "${CMAKE_CURRENT_LIST_DIR}")
set(configuration "${CONFIGURATION}")
if (NOT configuration)
  set(configuration Release)
endif ()

# Runs a command; stops with its output unless it succeeds.
function (run what)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "${what} failed (${result}):\n${output}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
  message(STATUS "${what}: done")
endfunction ()

# Sets <result> to the command that configures the folder <source> in <build>; more arguments are
# passed on.
function (configuration_command result build source)
  set(${result} "${CMAKE_COMMAND}" -S "${source}" -B "${WORK}/${build}"
    -G "${GENERATOR}" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}" "-DCMAKE_BUILD_TYPE=${configuration}" "-DVTK_DIR=${VTK_DIR}"
    "-DCMAKE_PREFIX_PATH=${prefix}" -Wno-dev ${ARGN} PARENT_SCOPE)
endfunction ()

function (expect_failure what pattern)
  execute_process(COMMAND ${ARGN}
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (result EQUAL 0)
    message(FATAL_ERROR "${what} succeeded, and should not:\n${output}")
  endif ()
  string(REGEX REPLACE "[ \n]+" " " flat "${output}")
  if (NOT flat MATCHES "${pattern}")
    message(FATAL_ERROR "${what} failed with another message than \"${pattern}\":\n${output}")
  endif ()
  message(STATUS "${what}: fails as it should")
endfunction ()

# ----- install, and move ---------------------------------------------------------------------------
file(REMOVE_RECURSE "${WORK}")
if (PACKAGE_STATIC)
  # Debug, because the checks that it compiles in must not need more libraries either.
  set(configuration Debug)
  configuration_command(configure package "${PACKAGE_SOURCE}" -DCMAKE_CXX_FLAGS_DEBUG=
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_LAUNCHER}" -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF
    -DSSAO_BUILD_EXAMPLES=OFF -DSSAO_BUILD_OSMESA=OFF)
  run("Configuration of the static library" ${configure})
  set(PACKAGE_BUILD "${WORK}/package")
  run("Build of the static library" "${CMAKE_COMMAND}" --build "${PACKAGE_BUILD}"
    --config "${configuration}" --parallel 2)
endif ()
run("Installation" "${CMAKE_COMMAND}" --install "${PACKAGE_BUILD}" --prefix "${WORK}/installed"
  --config "${configuration}")
file(MAKE_DIRECTORY "${WORK}/moved to")
file(RENAME "${WORK}/installed" "${prefix}")

# ----- no path of this machine, no OpenGL header ---------------------------------------------------
file(GLOB_RECURSE texts "${prefix}/*.cmake" "${prefix}/*.h" "${prefix}/*.txt")
file(GLOB_RECURSE libraries "${prefix}/*.so" "${prefix}/*.a")
set(checked ${texts})
if (configuration STREQUAL "Release" AND NOT CXX_FLAGS MATCHES "-g")
  list(APPEND checked ${libraries}) # debugging information names the sources' folder
endif ()
foreach (file IN LISTS checked)
  foreach (path IN ITEMS "${PACKAGE_SOURCE}/" "${PACKAGE_BUILD}/" "${WORK}/")
    file(STRINGS "${file}" found REGEX "${path}" LIMIT_COUNT 1)
    if (found)
      message(FATAL_ERROR "${file} contains ${path}: ${found}")
    endif ()
  endforeach ()
endforeach ()
file(GLOB_RECURSE headers RELATIVE "${prefix}" "${prefix}/*.h")
list(FILTER headers EXCLUDE REGEX "/vtk(ScreenSpaceAmbientOcclusionPass|SSAOPassModule)\\.h$")
if (headers)
  message(FATAL_ERROR "Headers are installed that are not public: ${headers}")
endif ()

# ----- a program that links the pass alone ---------------------------------------------------------
configuration_command(configure pass "${consumer}" "-DCONSUMER_VERSION=${PACKAGE_VERSION}")
run("Configuration without OSMesa" ${configure})
run("Build without OSMesa" "${CMAKE_COMMAND}" --build "${WORK}/pass" --config "${configuration}"
  --parallel 2)
find_program(uses_pass UsesPass PATHS "${WORK}/pass" "${WORK}/pass/${configuration}"
  NO_DEFAULT_PATH REQUIRED)
run("Program without OSMesa" "${uses_pass}")

find_program(READELF NAMES readelf)
if (READELF)
  run("Needed libraries" "${READELF}" -d "${uses_pass}")
  if (output MATCHES "OSMesa")
    message(FATAL_ERROR "A program that links the pass alone needs OSMesa:\n${output}")
  endif ()
  string(FIND "${output}" "libvtkSSAOPass.so" place)
  if (PACKAGE_SHARED AND place EQUAL -1)
    message(FATAL_ERROR "The program does not link the pass:\n${output}")
  endif ()
  foreach (library IN LISTS libraries)
    run("Needed libraries of ${library}" "${READELF}" -d "${library}")
    if (output MATCHES "(RPATH|RUNPATH)[^\n]*(${PACKAGE_BUILD}|${PACKAGE_SOURCE})")
      message(FATAL_ERROR "${library} looks for libraries in the build:\n${output}")
    elseif (output MATCHES "OSMesa" AND NOT library MATCHES "OSMesa")
      message(FATAL_ERROR "${library} needs OSMesa:\n${output}")
    endif ()
  endforeach ()
else ()
  message(STATUS "Needed libraries: not checked, there is no readelf")
endif ()

if (PACKAGE_STATIC)
  if (NOT EXISTS "${prefix}/lib/libvtkSSAOPass.a")
    message(FATAL_ERROR "The package has no static library")
  endif ()
  file(REMOVE_RECURSE "${WORK}")
  return ()
endif ()

# ----- a program that asks for the headless window -------------------------------------------------
if (PACKAGE_HAS_OSMESA)
  configuration_command(configure osmesa "${consumer}" -DCONSUMER_NEEDS_OSMESA=ON)
  run("Configuration with OSMesa" ${configure})
  run("Build with OSMesa" "${CMAKE_COMMAND}" --build "${WORK}/osmesa" --config "${configuration}"
    --parallel 2)
  find_program(renders RendersHeadless PATHS "${WORK}/osmesa" "${WORK}/osmesa/${configuration}"
    NO_DEFAULT_PATH REQUIRED)
  run("Program with OSMesa" "${CMAKE_COMMAND}" -E env --unset=DISPLAY "${renders}")
  string(STRIP "${output}" output)
  message(STATUS "${output}")
endif ()

# ----- the program of the README, with the CMakeLists.txt that stands beside it ---------------------
file(READ "${PACKAGE_SOURCE}/README.md" readme)
foreach (language_file IN ITEMS "cpp MinimalSSAO.cxx" "cmake CMakeLists.txt")
  separate_arguments(language_file)
  list(GET language_file 0 language)
  list(GET language_file 1 file)
  string(FIND "${readme}" "```${language}\n" begin)
  string(SUBSTRING "${readme}" ${begin} -1 block)
  string(REGEX REPLACE "^```[a-z]+\n" "" block "${block}")
  string(FIND "${block}" "```" end)
  string(SUBSTRING "${block}" 0 ${end} block)
  file(WRITE "${WORK}/readme source/${file}" "${block}")
endforeach ()
configuration_command(configure readme "${WORK}/readme source")
run("Configuration of the README's program" ${configure})
run("Build of the README's program" "${CMAKE_COMMAND}" --build "${WORK}/readme"
  --config "${configuration}" --parallel 2)
if (PACKAGE_HAS_OSMESA)
  find_program(minimal MinimalSSAO PATHS "${WORK}/readme" "${WORK}/readme/${configuration}"
    NO_DEFAULT_PATH REQUIRED)
  run("The README's program" "${CMAKE_COMMAND}" -E chdir "${WORK}"
    "${CMAKE_COMMAND}" -E env --unset=DISPLAY "${minimal}")
  if (NOT EXISTS "${WORK}/minimal.png")
    message(FATAL_ERROR "The README's program writes no picture")
  endif ()
endif ()

# ----- what is not there is said so ----------------------------------------------------------------
configuration_command(configure newer "${consumer}" -DCONSUMER_VERSION=99)
expect_failure("Configuration for a newer version" "requested version \"99\"" ${configure})

file(GLOB_RECURSE osmesa_files "${prefix}/*OSMesa*")
if (osmesa_files)
  file(REMOVE ${osmesa_files})
endif ()
configuration_command(configure bare "${consumer}")
run("Configuration of an installation that has no OSMesa" ${configure})
configuration_command(configure missing "${consumer}" -DCONSUMER_NEEDS_OSMESA=ON)
expect_failure("The component OSMesa of an installation that has none"
  "installed without vtkSSAOPass::OSMesa" ${configure})

file(REMOVE_RECURSE "${WORK}")
