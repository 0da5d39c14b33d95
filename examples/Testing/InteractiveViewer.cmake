# SPDX-License-Identifier: BSD-3-Clause
# The keys and sliders of InteractiveViewer do what they should, and its picture follows.
#   cmake -D PROGRAM=<InteractiveViewer> -D FOLDER=<folder> [-D RENDER_MESH=<RenderMesh>]
#     -P InteractiveViewer.cmake [-- <program and options to start it with>...]
# RENDER_MESH draws into memory as PROGRAM does: then their pictures must be the same, bit by bit.
cmake_minimum_required(VERSION 3.18)
include("${CMAKE_CURRENT_LIST_DIR}/MakeMeshes.cmake")

set(launcher)
foreach (i RANGE ${CMAKE_ARGC})
  if (DEFINED separator_seen)
    list(APPEND launcher "${CMAKE_ARGV${i}}")
  elseif ("${CMAKE_ARGV${i}}" STREQUAL "--")
    set(separator_seen TRUE)
  endif ()
endforeach ()
file(REMOVE_RECURSE "${FOLDER}")
ssao_make_meshes("${FOLDER}")

# play(<result> <event>...): <result>_state is what the program printed, <result>_sum the checksum
# of its picture. An event is a key, such as e or shift-e, or drag:<x0>,<y0>,<x1>,<y1>.
function (play result)
  set(script "# StreamVersion 1.1\n")
  foreach (event IN LISTS ARGN)
    if (event MATCHES "^drag:(.*),(.*),(.*),(.*)$")
      math(EXPR x "(${CMAKE_MATCH_1} + ${CMAKE_MATCH_3}) / 2")
      math(EXPR y "(${CMAKE_MATCH_2} + ${CMAKE_MATCH_4}) / 2")
      string(APPEND script
        "MouseMoveEvent ${CMAKE_MATCH_1} ${CMAKE_MATCH_2} 0 0 0 0\n"
        "LeftButtonPressEvent ${CMAKE_MATCH_1} ${CMAKE_MATCH_2} 0 0 0 0\n"
        "MouseMoveEvent ${x} ${y} 0 0 0 0\n"
        "MouseMoveEvent ${CMAKE_MATCH_3} ${CMAKE_MATCH_4} 0 0 0 0\n"
        "LeftButtonReleaseEvent ${CMAKE_MATCH_3} ${CMAKE_MATCH_4} 0 0 0 0\n")
    elseif (event MATCHES "^(shift-)?(.)$")
      set(key "${CMAKE_MATCH_2}")
      set(modifiers 0)
      if (event MATCHES "^shift-")
        string(TOUPPER "${key}" key)
        set(modifiers 1)
      endif ()
      string(HEX "${key}" code)
      math(EXPR code "0x${code}")
      foreach (name KeyPressEvent CharEvent KeyReleaseEvent)
        string(APPEND script "${name} 160 120 ${modifiers} ${code} 0 ${key}\n")
      endforeach ()
    else ()
      message(FATAL_ERROR "${event} is no event")
    endif ()
  endforeach ()
  file(WRITE "${FOLDER}/script.txt" "${script}")
  file(REMOVE "${FOLDER}/picture.png")
  execute_process(
    COMMAND ${launcher} "${PROGRAM}" --size 320x240 --script script.txt --picture picture.png
      mesh.obj
    WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE exit_code
    OUTPUT_VARIABLE state
    ERROR_VARIABLE error)
  if (NOT exit_code EQUAL 0 OR NOT error STREQUAL "" OR NOT EXISTS "${FOLDER}/picture.png")
    message(FATAL_ERROR "${ARGN}: exit code ${exit_code}: ${error}")
  endif ()
  file(SHA256 "${FOLDER}/picture.png" sum)
  set(${result}_state "${state}" PARENT_SCOPE)
  set(${result}_sum "${sum}" PARENT_SCOPE)
endfunction ()

# expect(<line> <event>...): after the events the program prints the line.
function (expect line)
  play(played ${ARGN})
  if (NOT "\n${played_state}" MATCHES "\n${line}\n")
    message(SEND_ERROR "${ARGN}: not '${line}' but\n${played_state}")
  else ()
    message(STATUS "${ARGN}: ${line}")
  endif ()
  set(played_state "${played_state}" PARENT_SCOPE)
  set(played_sum "${played_sum}" PARENT_SCOPE)
endfunction ()

# expect_picture(same|other <sum> <what>): of the last expect().
function (expect_picture comparison sum what)
  if (comparison STREQUAL same AND NOT played_sum STREQUAL sum)
    message(SEND_ERROR "${what}: another picture, but it should be the same")
  elseif (comparison STREQUAL other AND played_sum STREQUAL sum)
    message(SEND_ERROR "${what}: the same picture, but it should be another")
  else ()
    message(STATUS "${what}: ${comparison} picture, as it should")
  endif ()
endfunction ()

# expect_render_mesh(<option>...): the last picture, taken with the panel hidden, is RenderMesh's.
function (expect_render_mesh)
  if (NOT RENDER_MESH)
    return ()
  endif ()
  execute_process(
    COMMAND "${RENDER_MESH}" --size 320x240 --prefix reference ${ARGN} mesh.obj
    WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE exit_code
    OUTPUT_QUIET)
  file(GLOB picture "${FOLDER}/reference_*.png")
  file(SHA256 "${picture}" sum)
  file(REMOVE "${picture}")
  expect_picture(same "${sum}" "RenderMesh ${ARGN}")
endfunction ()

# The keys of the modes: each has its picture.
set(sums)
foreach (mode "o=unoccluded" "a=composite" "v=occlusion" "n=normal" "d=depth")
  string(REPLACE "=" ";" mode "${mode}")
  list(GET mode 0 key)
  list(GET mode 1 name)
  expect("output: ${name}" n h ${key})
  if (played_sum IN_LIST sums)
    message(SEND_ERROR "key ${key}: the same picture as another key's")
  endif ()
  list(APPEND sums "${played_sum}")
  set(${name} "${played_sum}")
  expect_render_mesh(--output ${name})
endforeach ()
expect("output: occlusion" shift-v)
expect("output: composite")
expect("output: occlusion" c)
expect("output: unoccluded" c c)
expect("output: composite" c c c h)
expect_picture(same "${composite}" "key c thrice")

# The panel is in the picture, and h hides it and brings it back.
expect("output: composite" h h)
expect_picture(other "${composite}" "the panel")

# The estimators, forwards and backwards, round the circle.
expect("estimator: CrytekSphere" e)
expect("estimator: ExactHorizon" shift-e)
expect("estimator: LayeredBitmask" e e e shift-e shift-e shift-e h)
expect_picture(same "${composite}" "there and back")
set(presses)
set(estimators)
foreach (press RANGE 1 20)
  list(APPEND presses e)
  play(played ${presses} v h)
  string(REGEX MATCH "estimator: ([^\n]*)" line "${played_state}")
  list(APPEND estimators "${CMAKE_MATCH_1}")
  if (CMAKE_MATCH_1 STREQUAL "LayeredBitmask")
    break ()
  endif ()
  expect_picture(other "${occlusion}" "${CMAKE_MATCH_1}")
endforeach ()
list(LENGTH estimators count)
list(REMOVE_DUPLICATES estimators)
list(LENGTH estimators distinct)
if (count LESS 9 OR count EQUAL 20 OR NOT count EQUAL distinct)
  message(SEND_ERROR "key e goes through ${estimators}")
endif ()
expect_picture(same "${occlusion}" "key e, all the way round")
set(to_horizon_angle e e e e e e e)
set(to_hemisphere e e e e)
expect("samples: 6 directions x 4 steps" ${to_horizon_angle} v h)
expect_render_mesh(--output occlusion --estimator horizon-angle)

# The sliders, which are at these places of a window of 320 x 240. A drag that begins on one leaves
# the camera alone, as RenderMesh shows.
set(radius_to_right drag:34,18,70,18)
set(intensity_to_right drag:141,18,165,18)
set(samples_to_left drag:248,18,240,18)
expect("radius: [0-9.]+" ${radius_to_right} h)
string(REGEX MATCH "radius: ([0-9.]+)" line "${played_state}")
set(radius "${CMAKE_MATCH_1}")
expect_picture(other "${composite}" "another radius")
expect_render_mesh(--output composite --radius ${radius})
expect("radius: [0-9.]+ .automatic." ${radius_to_right} 0 h)
expect_picture(same "${composite}" "the automatic radius again")
expect("intensity: [2-3][0-9.]*" ${intensity_to_right} h)
string(REGEX MATCH "intensity: ([0-9.]+)" line "${played_state}")
expect_render_mesh(--output composite --intensity ${CMAKE_MATCH_1})
expect("samples: [1-2][0-9] points" ${to_hemisphere} ${samples_to_left} h)
string(REGEX MATCH "samples: ([0-9]+)" line "${played_state}")
expect_render_mesh(--output composite --estimator hemisphere --kernel-size ${CMAKE_MATCH_1})
expect("samples: 32 points" ${to_hemisphere} h ${samples_to_left}) # hidden, it takes no events
expect("samples: [0-9]+ directions x [0-9]+ steps" ${to_horizon_angle} drag:243,18,280,18 h)
if (played_state MATCHES "samples: 6 directions x 4 steps")
  message(SEND_ERROR "dragging the slider leaves directions and steps alone")
endif ()

# A drag elsewhere turns the scene and changes nothing else, and the keys of VTK still work.
play(plain h)
play(turned h drag:150,150,200,125)
if (plain_sum STREQUAL turned_sum OR NOT plain_state STREQUAL turned_state)
  message(SEND_ERROR "a drag in the scene does not turn it, or more than that\n${turned_state}")
endif ()
expect("output: composite" h w)
expect_picture(other "${composite}" "key w of VTK's, wireframe")
expect("output: composite" h w s)
expect_picture(same "${composite}" "key s of VTK's, surfaces")

# What cannot be played.
execute_process(
  COMMAND ${launcher} "${PROGRAM}" --script missing.txt
  WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE exit_code
  OUTPUT_VARIABLE output
  ERROR_VARIABLE error)
# xvfb-run joins both streams.
if (NOT exit_code EQUAL 1 OR
    NOT "${output}${error}" STREQUAL "InteractiveViewer: error: cannot read 'missing.txt'\n")
  message(SEND_ERROR "a missing script: exit code ${exit_code}: ${output}${error}")
endif ()
