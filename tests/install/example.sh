#!/usr/bin/env bash
# Installs rift into a folder, builds the example against that and runs a scene
# with it. Its energy must be that which the program itself writes.
#
# usage: example.sh BUILD SOURCE FOLDER
set -euo pipefail
build=$1 source=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
cmake --install "$build" --prefix "$folder/rift" > "$folder/install.log"
cmake -S "$source/examples/step_by_step" -B "$folder/build" -G Ninja \
  -D CMAKE_PREFIX_PATH="$folder/rift" -D CMAKE_BUILD_TYPE=Release \
  > "$folder/configure.log"
cmake --build "$folder/build" > "$folder/build.log" || {
  cat "$folder/build.log"
  exit 1
}
scene=$source/tests/scenes/falling_box.prm
cd "$folder"
found=$(build/step_by_step "$scene" | sed -n 's/^kinetic energy at the end: \(.*\) J$/\1/p')
"$folder/rift/bin/rift" "$scene" --output "$folder/results" > run.log
expected=$(tail -n 1 "$folder/results/energy.csv" | cut -d , -f 2)
echo "$found J, expected $expected J"
awk "BEGIN { exit !($found > 0 && ($found - $expected)^2 < (1e-5 * $expected)^2) }"
