# Runs the quick report on two scenes and checks that files, columns and plots are there, and that
# the truth is right where it is known in closed form.
#   REPORT  the program
#   OUTPUT  a folder for its files, emptied first
cmake_minimum_required(VERSION 3.19)
file(REMOVE_RECURSE "${OUTPUT}")

function (run)
  execute_process(
    COMMAND "${REPORT}" quick --scenes long_wall,sphere_on_plane --methods Balanced --size 160x120
      --rounds 1 --rays 256 --output "${OUTPUT}" --commit test
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE error)
  if (NOT result EQUAL 0 OR NOT error STREQUAL "")
    message(FATAL_ERROR "the report failed (${result}): ${error}\n${output}")
  endif ()
  set(output "${output}" PARENT_SCOPE)
endfunction ()

# expect(<text> <condition>...)
function (expect text)
  if (NOT (${ARGN}))
    message(SEND_ERROR "${text}")
  endif ()
endfunction ()

run()
foreach (name IN ITEMS report.csv report.json error_cost.png error_samples.png
    error_cost_long_wall.png error_cost_sphere_on_plane.png sheet_long_wall_0.png
    sheet_sphere_on_plane_0.png)
  set(size 0)
  if (EXISTS "${OUTPUT}/${name}")
    file(SIZE "${OUTPUT}/${name}" size)
  endif ()
  expect("${name} is missing or empty" ${size} GREATER 500)
endforeach ()

# Four methods (VTK's three and ours) on two scenes, and every column has a value.
file(STRINGS "${OUTPUT}/report.csv" lines)
list(LENGTH lines count)
expect("report.csv has ${count} lines, not 9" ${count} EQUAL 9)
list(GET lines 0 header)
string(REPLACE "," ";" columns "${header}")
foreach (column IN ITEMS scene view method samples rmse bias p99 max ssim truth_mean
    truth_standard_error plain_seconds cost_seconds cost_to_vtk_32 cost_to_vtk_64 cost_to_vtk_256
    capture_seconds layers_seconds occlusion_seconds denoise_seconds modulate_seconds texture_bytes
    arithmetic_error twin_error)
  expect("report.csv has no column ${column}" "${column}" IN_LIST columns)
endforeach ()

# Mean of the closed form over the picture, four fifths floor: 1 - 0.8 * 2 / (3 pi) = 0.8302. At 256 rays per pixel the mean
# of 19,200 pixels is sure to a few parts in 10,000; the closed forms are tested to 0.003 elsewhere.
list(FIND columns truth_mean truth)
list(FIND columns rmse rmse)
foreach (line IN LISTS lines)
  string(REPLACE "," ";" values "${line}")
  if (line MATCHES "^long_wall")
    list(GET values ${truth} mean)
    expect("the truth of long_wall is ${mean}" ${mean} GREATER 0.8272 AND ${mean} LESS 0.8332)
  endif ()
  if (NOT line STREQUAL header)
    list(GET values ${rmse} error)
    expect("an RMSE is ${error}: ${line}" ${error} GREATER 0 AND ${error} LESS 0.5)
  endif ()
endforeach ()

file(READ "${OUTPUT}/report.json" json)
string(JSON rows LENGTH "${json}" rows)
string(JSON means LENGTH "${json}" means)
expect("report.json has ${rows} rows, not 8" ${rows} EQUAL 8)
expect("report.json has ${means} means, not 4" ${means} EQUAL 4)

# A second run finds everything measured.
run()
string(REGEX MATCHALL "measured before" before "${output}")
list(LENGTH before count)
expect("a finished report was measured again:\n${output}" ${count} EQUAL 2)
