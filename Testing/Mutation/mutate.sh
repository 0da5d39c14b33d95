#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Breaks the pass in one place after the other and tells which tests notice. See --help.
set -eu

usage()
{
  cat <<END
Usage: mutate.sh [OPTION...] [MUTATION...]

Copies the source tree to a temporary folder, applies each mutation alone, builds, runs the tests and
prints a table: mutation, tests that failed. Without names all mutations are tried.

  --list          print the mutations and stop
  --keep          do not remove the temporary folder
  --source DIR    the tree to test (default: the one this script is in)
  --exclude REGEX tests to leave out (default: those of the window, the package, the ray-traced
                  reference and the examples, which do not test the shaders)

Exit status: 0 if every mutation was noticed, 1 if one survived or could not be applied, 2 for
anything else. Variables: JOBS (2), CMAKE_ARGS (more arguments to configure with).
END
}

# ----- the mutations: name, file, sed expression, what it does -------------------------------------
# Files are in vtkSSAOPass/.
pass=vtkScreenSpaceAmbientOcclusionPass.cxx
stage=vtkSSAOOcclusionStage.cxx
mutations()
{
  # the five of the acceptance list
  m blur-dropped "$pass" 's/if (this->Denoiser == None ||/if (true ||/' \
    'no denoising'
  m radius-doubled "$stage" 's/SetUniformf("radius", /&2.0F * /' \
    'twice the radius'
  m samples-8-for-64 "$stage" \
    's/SetUniformi("samplesInKernel", settings\.KernelSize)/SetUniformi("samplesInKernel", (settings.KernelSize + 7) \/ 8)/' \
    'an eighth of the samples of a kernel'
  m half-the-steps "$stage" 's/SetUniformi("allSteps", settings\.Steps)/SetUniformi("allSteps", (settings.Steps + 1) \/ 2)/' \
    'half of the samples of a slice'
  m bias-times-10 "$stage" 's/SetUniformf("bias", /&10.0F * /' \
    'ten times the bias'
  m normals-flipped glsl/vtkSSAOPass1CaptureOutputFS.glsl \
    's/ssaoPackNormal(ssaoNormal)/ssaoPackNormal(-ssaoNormal)/' \
    'captured normals point away'

  # the estimator
  m range-check-removed glsl/vtkSSAOPass0Functions.glsl \
    's/return t \* t \* (float(3\.0) - float(2\.0) \* t);/return float(1.0);/' \
    'far occluders count in full'
  m range-check-hard glsl/vtkSSAOPass0Functions.glsl \
    's/return t \* t \* (float(3\.0) - float(2\.0) \* t);/return floor(t);/' \
    'occluders beyond the radius do not count at all'
  m background-counted glsl/vtkSSAOPass2Hemisphere.glsl \
    's/depth > float(0\.0) && depth <=/depth <=/' \
    'the background hides'
  m off-screen-counted glsl/vtkSSAOPass2Hemisphere.glsl \
    's/counted += known ? float(1\.0) : float(0\.0)/counted += float(1.0)/' \
    'samples outside the picture count as open'
  m off-screen-clamped glsl/vtkSSAOPass2Hemisphere.glsl \
    's/bool known = /bool known = true || /' \
    'samples outside the picture take what the border shows'
  m slope-dropped glsl/vtkSSAOPass2Hemisphere.glsl 's/float(1\.5) \* slope/float(0.0) * slope/' \
    'the bias does not follow the slope'
  m bias-dropped glsl/vtkSSAOPass2Hemisphere.glsl 's/float inFront = bias + /float inFront = /' \
    'no bias but the slope'
  m sphere-for-hemisphere glsl/vtkSSAOPass2Hemisphere.glsl \
    's/+ normal \* point\.z)/+ normal * point.z * ((i \& 1) == 0 ? float(1.0) : float(-1.0)))/' \
    'every second sample lies below the surface'
  m basis-not-orthogonal glsl/vtkSSAOPass0Functions.glsl \
    's/vec3 tangent = random - normal \* dot(random, normal);/vec3 tangent = random;/' \
    'no Gram-Schmidt step'
  m rotation-removed glsl/vtkSSAOPass2OcclusionFS.glsl \
    's/(pixel - viewport\.xy) \/ (noiseSize/vec2(0.0) \/ (noiseSize/' \
    'one rotation for all pixels'
  m rotation-by-window glsl/vtkSSAOPass2OcclusionFS.glsl \
    's/(pixel - viewport\.xy) \/ (noiseSize/pixel \/ (noiseSize/' \
    'the tile starts at the corner of the window'
  m kernel-not-accelerating vtkSSAOKernel.cxx 's/0\.9 \* share \* share/0.9 * share/' \
    'lengths grow linearly'
  m rotations-uneven vtkSSAOKernel.cxx 's/angle = glm::two_pi<double>()/angle = 0.5 * glm::two_pi<double>()/' \
    'rotations over half of the circle'
  m automatic-radius-doubled "$pass" 's/: 0\.1 \* DiagonalOfOpaqueProps/: 0.2 * DiagonalOfOpaqueProps/' \
    'a fifth of the diagonal'
  m presets-exchanged "$pass" 's/SetQuality(ExactHorizon, 1, 8, 2, 2)/SetQuality(LayeredBitmask, 1, 14, 1, 2)/' \
    'Fast is Accurate'

  # projection
  m projection-without-depth glsl/vtkSSAOPass0Functions.glsl \
    's/ssaoTransform2(rayToPixel, shifted \/ scale/ssaoTransform2(rayToPixel, shifted/' \
    'samples are projected as in parallel projection'
  m parallel-as-perspective vtkSSAOProjection.cxx \
    's/clipOfView\[2\]\[3\] != 0\.0 ? 1\.0 : 0\.0/1.0/' \
    'parallel projection taken for perspective'
  m off-axis-ignored vtkSSAOProjection.cxx \
    's/projection\.DepthSlope = .*/projection.DepthSlope = glm::dvec2(0.0);/' \
    'off-axis projections taken for symmetric ones'
  m half-a-pixel-off glsl/vtkSSAOPassViewFS.glsl \
    's/textureLod(geometry, pixel \* texelSize, 0\.0)/textureLod(geometry, (pixel + 0.5) * texelSize, 0.0)/' \
    'samples look up the next pixel'

  # denoisers
  m edges-ignored glsl/vtkSSAOPass3EdgeAwareFS.glsl \
    's/ssaoPlaneWeight(plane, neighbour\.y, (at - gl_FragCoord\.xy) \* downsampling)/1.0/' \
    'the edge-aware denoiser leaks over steps'
  m tile-not-balanced glsl/vtkSSAOPass3EdgeAwareFS.glsl \
    's/noiseSize % 2 == 0 ? 0\.5 : 1\.0/1.0/' \
    'some rotations of the tile weigh more'
  m box-displaced glsl/vtkSSAOPass3BoxFS.glsl 's/ivec2(i, j) - noiseSize \/ 2/ivec2(i, j)/' \
    'the box lies to the right of and above its pixel'
  m background-blurred glsl/vtkSSAOPass3BoxFS.glsl \
    's/ssaoGeometryAt(gl_FragCoord\.xy)\.x > 0\.0 ? mean : 1\.0/mean/' \
    'the box darkens the background'

  # modulation
  m modulation-exchanged "$pass" \
    's/this->Modulation == Ambient ? 0\.0F : 1\.0F/this->Modulation == Ambient ? 1.0F : 0.0F/' \
    'Ambient takes diffuse light away, AmbientAndDiffuse does not'
  m intensity-ignored glsl/vtkSSAOPass0Functions.glsl \
    's/float(1\.0) - intensity \* occlusion/float(1.0) - occlusion/' \
    'always intensity 1'
  m power-ignored glsl/vtkSSAOPass0Functions.glsl \
    's/float powered = pow(\(.*\), power);/float powered = \1;/' \
    'always power 1'
  m blending-left-over vtkSSAOModulateStage.cxx \
    's/const vtkSSAOScopedBlendEquation blendEquationSaver(state);//' \
    'OpenGL goes on subtracting'

  # buffers
  m normals-packed-coarsely glsl/vtkSSAOPass0Functions.glsl 's/4094\.0/254.0/g' \
    'seven bits for each half of a normal'
  m samples-not-resolved glsl/vtkSSAOPass1ResolveFS.glsl 's/found = value\.x > 0\.0 ? value : found/found = value/' \
    'pixels of silhouettes lose their surface'
  m viewport-ignored vtkSSAOFullScreenStage.cxx \
    's/vtkglViewport(view\.Viewport\.x, view\.Viewport\.y,/vtkglViewport(0, 0,/' \
    'stages draw at the corner of the window'
  m texture-leaked vtkSSAOFullScreenStage.cxx \
    '/ReleaseGraphicsResources(vtkWindow/,/^}/s/this->Output = nullptr;/this->Output->Register(nullptr);/;/ReleaseGraphicsResources(vtkWindow/,/^}/s/this->Output->ReleaseGraphicsResources(window);//' \
    'a texture stays behind'
  m texture-not-resized vtkSSAOFullScreenStage.cxx '/(\*texture)->Resize(size\.x, size\.y);/d' \
    'a larger window finds the old texture'
  m loss-unnoticed vtkSSAOCapturePass.cxx \
    's/return this->Geometry \&\& !this->Geometry->GetHandle();/return false;/' \
    'nobody looks whether the context is another one'
  m dead-textures-read vtkSSAOFullScreenStage.cxx 's/if (!texture || !texture->GetHandle())/if (!texture)/' \
    'textures of a window that is gone are read'
  m memory-kept vtkSSAOCapturePass.cxx \
    's/^  this->NumberOfRenderedProps = 0;$/& static std::vector<double*> kept; kept.push_back(new double[8]);/' \
    'a frame leaves 64 bytes behind'
  m offsets-forgotten vtkSSAOCapturePass.cxx \
    's/double(vtkMapper::GetResolveCoincidentTopology()), factor, units,/0.0, 0.0, 0.0,/' \
    'other offsets of coincident surfaces make no new frame'
  m output-mode-unsaid "$pass" 's/this->Fail("A shader of the output mode");//' \
    'an output mode that cannot be drawn is not an error'

  # parameters
  m nan-accepted "$pass" 's/!std::isfinite(value) || //' \
    'NaN and infinity are let in'
  m negative-accepted "$pass" 's/value < low || //' \
    'values below the range are let in'
  m parameter-not-printed "$pass" '/indent << "NoiseSize: "/d' \
    'PrintSelf leaves one out'
  m unmodified "$pass" '/template <typename Value>/,/^}/s/this->Modified();//' \
    'setters do not mark the pass as modified'

  # stability
  m absolute-length glsl/vtkSSAOPass0SliceFunctions.glsl 's/float(1\.0e-30)));/float(1.0e-9)));/' \
    'distances below 3e-5 world units are not told apart'
  m clip-depth vtkSSAOView.cxx 's/  if (narrow)/  if (true)/' \
    'depths are always those of the clip coordinates'
  m view-depth vtkSSAOView.cxx 's/  if (narrow)/  if (false)/' \
    'depths are always those of the view coordinates'
  m depths-from-near-plane vtkSSAOCapturePass.cxx 's/if (known \&\& origin > /if (false \&\& origin > /' \
    'depths begin at the near plane, not at the scene'
  m depths-from-camera vtkSSAOView.cxx 's/range\[0\] > thickness/range[0] > 1e30 * thickness/' \
    'depths are always counted from the camera'
  m impostors-shifted vtkSSAOCapturePass.cxx 's/    if (geometryShader\.empty())/    if (true)/' \
    'layers of impostors are moved in view coordinates'
  m vtk-flat-normals vtkSSAOCapturePass.cxx 's/#define SSAO_FLAT/#define SSAO_NOT_FLAT/' \
    'flat normals are those that VTK takes from positions'
  m facet-without-margin glsl/vtkSSAOPass0SliceFunctions.glsl \
    's/inverse > float(0\.01)/inverse > float(0.0)/' \
    'all that rounding lifts above the facet hides'
  m below-facet glsl/vtkSSAOPass0SliceFunctions.glsl 's/inverse > float(0\.01)/inverse > float(-1.0)/' \
    'what lies below the facet hides'
  m parallel-reach-halved glsl/vtkSSAOPass0SliceFunctions.glsl \
    's/return ssaoTransform2(rayToPixel, moved \/ depth);/return ssaoTransform2(rayToPixel, moved \/ depth) * (float(0.5) + float(0.5) * perspective);/' \
    'half of the radius in parallel projection'
  m nearest-sample-far glsl/vtkSSAOPass0SliceFunctions.glsl \
    's/min(float(1\.3) \/ reachInPixels/min(float(20.0) \/ reachInPixels/' \
    'no sample is nearer than 20 pixels'
  m background-captured vtkSSAOCapturePass.cxx \
    's/vtkglClearColor(0\.0F,/vtkglClearColor(5.0F * view.Renderer->GetBackground()[0],/' \
    'the background is a surface as far away as it is red'
  m gaps-unseen glsl/vtkSSAOPass1GapsFS.glsl 's/offOther) > 3\.0/offOther) > 1.0e9/' \
    'layers are drawn only where a surface shows both sides'
  m tiny-radius-sampled vtkSSAOOcclusionSettings.h 's/? 1\.3 : 0\.0/? 0.0 : 0.0/' \
    'samples are taken within a pixel'
  m plane-never-proven vtkSSAOLayerStage.cxx 's/this->EvenFacet = facet;//' \
    'samples are taken where there is one plane only'
  m plane-proven-at-edges glsl/vtkSSAOPass2OcclusionFS.glsl 's/ > reach + 2\.0/ > 2.0/' \
    'no samples are taken next to what rises from a plane'
  m silhouettes-are-sheets glsl/vtkSSAOPass0SliceFunctions.glsl 's/ \&\& !paper;/;/' \
    'front and back that meet at a silhouette are a sheet'
  m sides-wound-twice glsl/vtkSSAOPass1SolidsFS.glsl 's/if (back < none \&\&/if (false \&\&/' \
    'a face wound both ways is not one sheet'
  m samples-beyond-border glsl/vtkSSAOPass2LayeredBitmask.glsl \
    's/float inside = ssaoShareInside(.*/float inside = float(1.0);/' \
    'samples are taken outside the picture'
  m shader-not-as-twin glsl/vtkSSAOPass2OcclusionFS.glsl \
    's/ssaoVisibility(pixel, center) :/0.99 * ssaoVisibility(pixel, center) :/' \
    'V differs from the twin by a hundredth'
}

# ----- arguments ----------------------------------------------------------------------------------
jobs=${JOBS:-2}
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
source=$(CDPATH='' cd -- "$here/../.." && pwd)
keep=no
exclude='Window|Truth|InstalledPackage|ReadmeProgram|^Example|^example|RenderMesh'
chosen=''
while [ $# -gt 0 ]; do
  case $1 in
    --help | -h) usage; exit 0 ;;
    --list)
      m() { printf '%-26s %s\n' "$1" "$4"; }
      mutations
      exit 0
      ;;
    --keep) keep=yes ;;
    --source) shift; source=$(CDPATH='' cd -- "$1" && pwd) ;;
    --exclude) shift; exclude=$1 ;;
    -*) usage >&2; exit 2 ;;
    *) chosen="$chosen $1 " ;;
  esac
  shift
done

# ----- a copy, and the tests of what is not mutated -------------------------------------------------
work=$(mktemp -d "${TMPDIR:-/tmp}/ssao-mutate.XXXXXX")
clean()
{
  if [ "$keep" = yes ]; then
    echo "kept: $work"
  else
    rm -rf "$work"
  fi
}
trap clean EXIT
trap 'exit 2' HUP INT TERM

mkdir "$work/source"
for item in CMakeLists.txt CMake LICENSE data vtkSSAOPass Testing; do
  if [ -e "$source/$item" ]; then
    cp -RL "$source/$item" "$work/source/"
  fi
done

say() { printf '%s\n' "$*" >&2; }

build()
{
  cmake --build "$work/build" --parallel "$jobs" \
    --target vtkSSAOPassCxxTests --target vtkSSAOPassCxxUnitTests >"$work/build.log" 2>&1
}

# Prints the names of the tests that failed.
failed_tests()
{
  rm -f "$work/build/Testing/Temporary/LastTestsFailed.log"
  (cd "$work/build" && ctest -L SSAO -E "$exclude" -j "$jobs" --timeout 120) \
    >"$work/ctest.log" 2>&1 || true
  if ! grep -q 'tests passed' "$work/ctest.log"; then
    echo 'no-tests-were-run'
  fi
  sed -n 's/^[	 ]*[0-9]* - \([^ ]*\) .*/\1/p' "$work/ctest.log" | sed 's/.*Cxx-//' | sort
}

say "configuring and building in $work"
# shellcheck disable=SC2086 # CMAKE_ARGS is a list of words
if ! cmake -S "$work/source" -B "$work/build" -D CMAKE_BUILD_TYPE=Release \
  -D SSAO_BUILD_EXAMPLES=OFF -Wno-dev ${CMAKE_ARGS:-} >"$work/configure.log" 2>&1; then
  cat "$work/configure.log" >&2
  exit 2
fi
if ! build; then
  tail -n 40 "$work/build.log" >&2
  exit 2
fi
failures=$(failed_tests)
if [ -n "$failures" ]; then
  say "these tests fail without any mutation:"
  say "$failures"
  exit 2
fi

# ----- one after the other --------------------------------------------------------------------------
survived=0
printf '| mutation | what it does | noticed by |\n|---|---|---|\n'
m()
{
  case $chosen in
    '' | *" $1 "*) ;;
    *) return 0 ;;
  esac
  file=$work/source/vtkSSAOPass/$2
  if [ ! -f "$file" ]; then
    printf '| %s | %s | **NOT APPLIED**: no file %s |\n' "$1" "$4" "$2"
    survived=$((survived + 1))
    return 0
  fi
  cp -p "$file" "$work/original"
  sed "$3" "$work/original" >"$file"
  if cmp -s "$file" "$work/original"; then
    result="**NOT APPLIED**: the text to change is not in $2"
    survived=$((survived + 1))
  elif ! build; then
    # The compiler has noticed; of no use as a mutation.
    result='**NOT BUILT**'
    survived=$((survived + 1))
    cp "$work/build.log" "$work/build-$1.log"
  else
    result=$(failed_tests | tr '\n' ' ')
    if [ -z "$result" ]; then
      result='**SURVIVED**'
      survived=$((survived + 1))
    fi
  fi
  printf '| %s | %s | %s |\n' "$1" "$4" "$result"
  cp "$work/original" "$file" # newer than what was built, so it is built again
}
mutations

if [ "$survived" -gt 0 ]; then
  say "$survived mutations survived or were not applied"
  exit 1
fi
say 'every mutation was noticed'
