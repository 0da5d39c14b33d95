#!/bin/sh
# Draws VTK's test programs plain and with the pass, and compares. See CMakeLists.txt.
#   run.sh <build folder> [jobs]
# Prints a line for each program, "name: result", and the counts.
set -u
build=$(cd "$1" && pwd)

# One program: run.sh <build folder> one <module> <function>
if [ "${2-}" = one ]; then
  module=$3
  out=$build/pictures/$module
  rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
  draw() { # mode, folder
    mkdir -p "$2"
    timeout 300 "$build/vtkTestDriver" "$build/$module.so" "$function" "$1" -T "$out/$2" \
      -V "$out/none/picture.png" >"$2.log" 2>&1
    echo $? >"$2.status"
    [ -s "$2/picture.png" ]
  }
  difference() { "$build/vtkTestDriver" compare "$1/picture.png" "$2/picture.png"; }
  function=$4
  result=
  if [ ! -e "$build/$module.so" ]; then
    result="not compiled"
  elif ! draw plain plain; then
    result="no picture without the pass (status $(cat plain.status))"
  else
    for mode in zero open; do
      if ! draw $mode $mode; then
        result="$result$mode: BROKEN, no picture (status $(cat $mode.status)); "
        continue
      fi
      found=$(difference plain $mode)
      if [ "${found%% *}" != sizes ] && [ "${found%% *}" -le 1 ]; then
        result="$result$mode: equal; "
      elif draw plain again && again=$(difference plain again) && [ "${again%% *}" != 0 ]; then
        result="$result$mode: plain is not repeatable ($again); "
      else
        result="$result$mode: DIFFERS ($found); "
      fi
      grep -qE "ERR\||ERROR: In|Warning: In|WARN\|" $mode.log &&
        ! grep -qE "ERR\||ERROR: In|Warning: In|WARN\|" plain.log && result="${result}says something; "
    done
  fi
  echo "$module: $result" | tee result.txt
  exit 0
fi

sed "s|^|$build one |" "$build/programs.txt" | xargs -P "${2:-2}" -L 1 nice sh "$0"
results=$(cat "$build"/pictures/*/result.txt | sort)
echo "$results" >"$build/results.txt"
count() { echo "$results" | grep -c "$1"; }
echo "programs: $(count :)"
echo "not compiled: $(count 'not compiled')"
echo "no picture: $(count 'no picture without')"
echo "not repeatable: $(count 'not repeatable')"
for mode in zero open; do
  echo "$mode: equal $(count "$mode: equal"), differs $(count "$mode: DIFFERS"), broken $(count "$mode: BROKEN")"
done
