#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Quality gates: Testing/Quality/check.sh [GATE...], all if none is named. ./run check installs what
# they need first. Stops at the first gate that fails.
#
#   format  clang-format has nothing to change
#   tidy    clang-tidy has nothing to say about the module
#   gcc     GCC, warnings as errors; the tests of the pass, and which share of its lines they run
#   clang   Clang, warnings as errors; the tests of the pass under AddressSanitizer and
#           UndefinedBehaviorSanitizer
#
# Build folders are SSAO_CHECK_DIR (build-check) -gcc and -clang. The tests of the pass are those of
# Testing/Cxx without ray tracing, report and package; SSAO_CHECK_TESTS is another pattern for ctest.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
build=${SSAO_CHECK_DIR:-$root/build-check}
tests=${SSAO_CHECK_TESTS:-'Cxx-(Test|UnitTestSSAO|UnitTestEstimator)'}
cd "$root"

# configure FOLDER COMPILER COMPILER++ FLAGS
configure()
{
  cmake -S "$root" -B "$1" -G Ninja -Wno-dev -D "CMAKE_C_COMPILER=$2" -D "CMAKE_CXX_COMPILER=$3" \
    -D CMAKE_BUILD_TYPE=Debug -D CMAKE_CXX_FLAGS_DEBUG='-O1 -g1' -D "CMAKE_CXX_FLAGS=$4" \
    -D CMAKE_EXPORT_COMPILE_COMMANDS=ON -D SSAO_WARNINGS_AS_ERRORS=ON -D SSAO_BUILD_EXAMPLES=OFF \
    -D SSAO_BUILD_PYTHON=OFF
}

run_tests()
{
  cmake --build "$1" --parallel 2 --target vtkSSAOPassCxxTests vtkSSAOPassCxxUnitTests
  (cd "$1" && ctest --parallel 2 --timeout 900 --output-on-failure --no-tests=error -R "$tests" \
    -E 'TestReportPictures')
}

check_format()
{
  git ls-files -z '*.cxx' '*.h' | xargs -0 clang-format --dry-run -Werror
}

check_tidy()
{
  configure "$build-gcc" gcc g++ --coverage
  cmake --build "$build-gcc" --parallel 2 --target vtkSSAOPass # writes the headers of the shaders
  run-clang-tidy -p "$build-gcc" -quiet -j 2 "$root/vtkSSAOPass/vtk[A-Za-z]*[.]cxx"
}

check_gcc()
{
  configure "$build-gcc" gcc g++ --coverage
  find "$build-gcc" -name '*.gcda' -delete # counts of an earlier run
  run_tests "$build-gcc"
  gcovr --root "$root" --filter vtkSSAOPass/ --exclude vtkSSAOPass/OSMesa/ --print-summary \
    "$build-gcc/vtkSSAOPass"
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
