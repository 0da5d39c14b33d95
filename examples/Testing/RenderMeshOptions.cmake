# SPDX-License-Identifier: BSD-3-Clause
# Every option of RenderMesh that shapes a picture does so, and the ones that must not, do not.
#   cmake -D PROGRAM=<RenderMesh> -D FOLDER=<folder> -P RenderMeshOptions.cmake
cmake_minimum_required(VERSION 3.18)
include("${CMAKE_CURRENT_LIST_DIR}/MakeMeshes.cmake")

file(REMOVE_RECURSE "${FOLDER}")
ssao_make_meshes("${FOLDER}")

# render(<result> <argument>...): the checksum of the picture.
function (render result)
  file(REMOVE "${FOLDER}/p_composite.png" "${FOLDER}/p_occlusion.png")
  execute_process(
    COMMAND "${PROGRAM}" --prefix p --output composite --size 160x120 ${ARGN}
    WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE exit_code
    OUTPUT_QUIET
    ERROR_VARIABLE error)
  file(GLOB picture "${FOLDER}/p_*.png")
  if (NOT exit_code EQUAL 0 OR NOT error STREQUAL "" OR NOT picture)
    message(FATAL_ERROR "${ARGN}: exit code ${exit_code}: ${error}")
  endif ()
  file(SHA256 "${picture}" sum)
  file(REMOVE "${picture}")
  set(${result} "${sum}" PARENT_SCOPE)
endfunction ()

function (expect comparison a b what)
  if ("${comparison}" STREQUAL same AND NOT "${a}" STREQUAL "${b}")
    message(SEND_ERROR "${what}: another picture, but it should be the same")
  elseif ("${comparison}" STREQUAL other AND "${a}" STREQUAL "${b}")
    message(SEND_ERROR "${what}: the same picture, but it should be another")
  else ()
    message(STATUS "${what}: ${comparison}, as it should")
  endif ()
endfunction ()

render(plain mesh.obj)
render(again mesh.obj)
expect(same ${plain} ${again} "twice the same command")

foreach (arguments
    "--radius;0.2" "--quality;fast" "--quality;accurate" "--kernel-size;5" "--noise-size;2"
    "--denoiser;none" "--denoiser;box" "--denoiser;box-centered"
    "--denoiser;separable-gaussian" "--modulation;ambient" "--estimator;crytek-sphere"
    "--estimator;position-sphere" "--estimator;hemisphere-linear-depth"
    "--estimator;reflected-hemisphere" "--estimator;horizon-angle" "--estimator;hemisphere"
    "--intensity;0.5" "--power;2" "--intensity-scale;2" "--intensity-shift;0.2" "--look;0,1,-1"
    "--up;1,0,0" "--position;-1,-4,3" "--zoom;2" "--view-angle;60" "--parallel"
    "--background;0,0,0" "--color;1,0,0" "--feature-angle;180" "--ambient;0.6" "--diffuse;0.2"
    "--specular;1" "--supersample;2" "--output;unoccluded" "--output;normal" "--output;depth"
    "--output;occlusion")
  render(changed ${arguments} mesh.obj)
  expect(other ${plain} ${changed} "${arguments}")
endforeach ()
foreach (arguments
    "--radius;0" "--quality;balanced" "--estimator;layered-bitmask" "--bias;auto" "--zoom;1"
    "--intensity;1" "--look=-1,1.6,-1" "--frames;1" "--quiet")
  render(same ${arguments} mesh.obj)
  expect(same ${plain} ${same} "${arguments}")
endforeach ()

# Options of one estimator, against that estimator alone.
function (expect_change estimator)
  render(alone --estimator ${estimator} mesh.obj)
  foreach (arguments IN LISTS ARGN)
    string(REPLACE "=" ";" words "${arguments}")
    render(changed --estimator ${estimator} ${words} mesh.obj)
    expect(other ${alone} ${changed} "${estimator} ${arguments}")
  endforeach ()
endfunction ()
expect_change(crytek-sphere --half-rule=off)
expect_change(hemisphere --bias=0.5 --range-check=off)
expect_change(reflected-hemisphere --minimum-difference=0.3 --attenuation=4 --falloff=null-square
  --falloff=inverse-square)
expect_change(horizon-angle --directions=3 --steps=12 --angle-bias=10)
expect_change(layered-bitmask --downsampling=1 --layers=1 --layer-downsampling=1)

render(off --intensity 0 mesh.obj)
render(unoccluded --output unoccluded mesh.obj)
expect(same ${off} ${unoccluded} "intensity 0 and no occlusion")
render(shiny --specular 0.8 mesh.obj)
render(all --specular 0.8 --modulation all mesh.obj)
expect(other ${shiny} ${all} "--modulation all with specular light")
render(first --quality fast --kernel-size 48 mesh.obj)
render(last --kernel-size 48 --quality fast mesh.obj)
expect(same ${first} ${last} "the preset before or after what it sets")
render(small --contour 1 volume.vti)
render(large --contour 4 volume.vti)
expect(other ${small} ${large} "--contour")
render(flat --warp-scale 0.1 volume.vti)
render(surface mesh.vtu)
render(contour --contour 2.5 mesh.vtu)
expect(other ${surface} ${contour} "--contour of a grid")
render(colored --color-by height mesh.vtu)
expect(other ${surface} ${colored} "--color-by")
