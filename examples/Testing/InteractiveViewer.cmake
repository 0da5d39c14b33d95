# SPDX-License-Identifier: BSD-3-Clause
# The keys and sliders of InteractiveViewer do what they should, and its picture follows.
#   cmake -D PROGRAM=<InteractiveViewer> -D FOLDER=<folder> -D TRUTH=<whether it has ray tracing>
#     [-D RENDER_MESH=<RenderMesh>] -P InteractiveViewer.cmake
# RENDER_MESH draws into memory as PROGRAM does: then their pictures must be the same, bit by bit.
# Without it, what does not depend on the window is left out.
cmake_minimum_required(VERSION 3.18)
include("${CMAKE_CURRENT_LIST_DIR}/MakeMeshes.cmake")
file(REMOVE_RECURSE "${FOLDER}")
ssao_make_meshes("${FOLDER}")

# play(<result> <event>...): <result>_state is what the program printed, <result>_sum the checksum
# of its picture. An event is a key, such as e or shift-e, or drag:<x0>,<y0>,<x1>,<y1>, or hold:<n>,
# which presses the mouse button, moves by nothing n times, and does not let go. Options of the
# program are in the variable options.
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
    elseif (event MATCHES "^hold:(.*)$")
      string(APPEND script "LeftButtonPressEvent 150 150 0 0 0 0\n")
      foreach (move RANGE 1 ${CMAKE_MATCH_1})
        string(APPEND script "MouseMoveEvent 150 150 0 0 0 0\n")
      endforeach ()
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
    COMMAND "${PROGRAM}" --size 320x240 --script script.txt --picture picture.png ${options}
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
  if (NOT --quality IN_LIST ARGN)
    list(APPEND ARGN --quality accurate)
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
if (RENDER_MESH) # once is enough
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
endif ()
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
set(options --frame-rate 0.001)
play(plain h)
play(turned h drag:150,150,200,125)
set(options)
if (plain_sum STREQUAL turned_sum OR NOT plain_state STREQUAL turned_state)
  message(SEND_ERROR "a drag in the scene does not turn it, or more than that\n${turned_state}")
endif ()
expect("output: composite" h w)
expect_picture(other "${composite}" "key w of VTK's, wireframe")
expect("output: composite" h w s)
expect_picture(same "${composite}" "key s of VTK's, surfaces")

# Presets and modulations.
expect("preset: Accurate" h)
expect("preset: Fast" h 1)
set(fast "${played_sum}")
expect_render_mesh(--output composite --quality fast)
if (RENDER_MESH)
  expect("preset: Balanced" h 1 2)
  expect_render_mesh(--output composite --quality balanced)
  expect("preset: Accurate" h 1 3)
  expect_picture(same "${composite}" "key 3")
  expect("preset: no preset" e)
  expect("modulation: all" h m)
  expect_render_mesh(--output composite --modulation all)
  expect("modulation: ambient" h m m)
  expect("modulation: ambient and diffuse" h m m m)
  expect_picture(same "${composite}" "key m thrice")
endif ()
set(options --quality fast)
expect("preset: Fast" h)
expect_picture(same "${fast}" "option --quality")

# While the mouse button is held the picture is Fast's, afterwards the chosen preset's.
set(options --frame-rate 0.001)
expect("movements: Fast" h hold:6)
expect_picture(same "${fast}" "while the camera moves")
expect("movements: Fast" h drag:150,150,150,150)
expect_picture(same "${composite}" "after it moved")
# Where every frame takes too long there is less, from the second frame on: Play() draws the last.
set(options --frame-rate 1000000)
if (RENDER_MESH)
  expect("movements: Fast, one of 4 x 4 pixels" h hold:2)
  expect_render_mesh(--output composite --quality fast --downsampling 4)
endif ()
expect("movements: without occlusion" h hold:6)
expect_picture(same "${unoccluded}" "while the camera moves, without time")
expect("preset: Accurate" h drag:150,150,150,150)
expect_picture(same "${composite}" "after it moved, without time")
set(options)

# Pictures are grabbed into new files.
expect("output: occlusion" h g v g)
foreach (number 1 2)
  set(picture "${FOLDER}/InteractiveViewer-${number}.png")
  if (NOT EXISTS "${picture}")
    message(FATAL_ERROR "key g wrote no ${picture}")
  endif ()
  file(SHA256 "${picture}" sum_${number})
  file(REMOVE "${picture}")
endforeach ()
expect_picture(same "${sum_2}" "key g")
if (NOT sum_1 STREQUAL composite)
  message(SEND_ERROR "key g: not the picture that was shown")
endif ()

# The error against the truth: that of what is shown, until camera, radius or scene change.
# compare(<result> <event>...): <result> is the error times 10000.
function (compare result)
  expect("error: RMSE 0.[0-9]+, bias [+-]0.[0-9]+" ${ARGN})
  string(REGEX MATCH "RMSE 0.0*([0-9]+)" line "${played_state}")
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction ()
if (TRUTH)
  compare(error_accurate t)
  compare(error_fast 1 t)
  compare(error_first_truth t 1)
  compare(error_crytek t e)
  if (NOT error_accurate LESS error_fast OR error_crytek EQUAL error_accurate OR
      NOT error_first_truth EQUAL error_fast)
    message(SEND_ERROR "errors of Accurate ${error_accurate}, of Fast ${error_fast} and "
      "${error_first_truth}, of CrytekSphere ${error_crytek}")
  endif ()
  expect("error: there is no visibility here" t o)
  expect("error: not asked for" t drag:150,150,200,125)
  if (RENDER_MESH)
    foreach (events "t;t" "t;${radius_to_right}" "t;w")
      expect("error: not asked for" ${events})
    endforeach ()
  endif ()
else ()
  expect("error: not in this build" t)
endif ()

# What cannot be played.
execute_process(
  COMMAND "${PROGRAM}" --script missing.txt
  WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE exit_code
  OUTPUT_VARIABLE output
  ERROR_VARIABLE error)
if (NOT exit_code EQUAL 1 OR NOT output STREQUAL "" OR
    NOT error STREQUAL "InteractiveViewer: error: cannot read 'missing.txt'\n")
  message(SEND_ERROR "a missing script: exit code ${exit_code}: ${output}${error}")
endif ()
