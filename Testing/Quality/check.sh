#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Quality gates: Testing/Quality/check.sh [GATE...], all if none is named. ./run check installs what
# they need first. Stops at the first gate that fails.
#
#   format  clang-format has nothing to change
#   tidy    clang-tidy has nothing to say about the module
#   gcc     GCC, warnings as errors; which share of the module's lines the tests below run
#   clang   Clang, warnings as errors; the tests below under AddressSanitizer and
#           UndefinedBehaviorSanitizer
#
# Build folders are SSAO_CHECK_DIR (build-check) -gcc and -clang. Instrumented tests are slow, so only
# those run that reach other code: a picture of every stage, estimator, denoiser, mode and
# delegate, all parameters, and what is hard on memory (bad scenes, sizes, lifetime, failing drivers,
# scenes by chance). Those left out check values, with the same code and other numbers.
# SSAO_CHECK_TESTS is another pattern for ctest: 'Cxx-(Test|UnitTestSSAO|UnitTestEstimator)' for all.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=${SSAO_CHECK_DIR:-$root/build-check}
pictures='Stages|Presets|Modulations|ParallelProjection|MultiSamples|EstimatorImages|DenoiserImages'
reach='OutputModes|Delegates|EstimatorSwitching|OnlyWhatIsNeeded|AutomaticRadius|StableControls'
reach="$reach|StableParallelDistance|StableArithmetic|HarmlessRendererFlags"
memory='BadScenes|StableBadGeometry|Lifetime|Churn|DriverFailures|RandomScenes|HarmlessScreenshots'
memory="$memory|HarmlessViewports|HarmlessWindows|HarmlessTranslucent|HarmlessPicking|HarmlessProps"
tests=${SSAO_CHECK_TESTS:-"Cxx-(Test($pictures|$reach|$memory)\$|UnitTest(SSAO|Estimator))"}
cd "$root"

# Other versions format otherwise, and complain of other things.
has_version_14()
{
  "$1" --version | grep -q 'version 14[.]' && return 0
  echo "skipped: this $1 is not version 14"
  return 1
}

# configure FOLDER COMPILER COMPILER++ FLAGS
configure()
{
  cmake -S "$root" -B "$1" -G Ninja -Wno-dev -D "CMAKE_C_COMPILER=$2" -D "CMAKE_CXX_COMPILER=$3" \
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG='-O1 -g1' -D "CMAKE_CXX_FLAGS=$4" \
    -D CMAKE_EXPORT_COMPILE_COMMANDS=ON -D SSAO_WARNINGS_AS_ERRORS=ON -D SSAO_BUILD_PYTHON=OFF
}

run_tests()
{
  cmake --build "$1" --parallel 2 -- -k 0 # all, to tell all warnings
  (cd "$1" && ctest --parallel 2 --timeout 900 --output-on-failure --no-tests=error -R "$tests" \
    -E 'TestReportPictures')
}

check_format()
{
  has_version_14 clang-format || return 0
  git ls-files -z '*.cxx' '*.h' | xargs -0 clang-format --dry-run -Werror
}

check_tidy()
{
  has_version_14 clang-tidy || return 0
  configure "$build-gcc" gcc g++ --coverage
  cmake --build "$build-gcc" --parallel 2 --target vtkSSAOPass # writes the headers of the shaders
  run-clang-tidy -p "$build-gcc" -quiet -j 2 "$root/vtkSSAOPass/vtk[A-Za-z]*[.]cxx"
}

check_gcc()
{
  configure "$build-gcc" gcc g++ --coverage
  find "$build-gcc" -name '*.gcda' -delete # counts of an earlier run
  run_tests "$build-gcc"
  # All of the build, as the tests have some of the module's sources compiled in and run those.
  gcovr --root "$root" --filter vtkSSAOPass/ --exclude vtkSSAOPass/OSMesa/ \
    --exclude vtkSSAOPass/glsl/ --print-summary "$build-gcc"
}

check_clang()
{
  # Without vptr: the classes of VTK that it asks for are not built that way.
  configure "$build-clang" clang clang++ '-fsanitize=address,undefined -fno-sanitize=vptr '\
'-fno-sanitize-recover=undefined -fno-omit-frame-pointer'
  run_tests "$build-clang"
}

[ $# -gt 0 ] || set -- format tidy gcc clang
for gate in "$@"; do
  echo "== $gate"
  "check_$gate"
done
echo "passed: $*"
