# Runs that make no sense any more say so, in the log and in summary.json: a hole
# is blown up without contact, with a pressure that goes on acting on what it has
# torn off, and with one that ends there.
#
#   bash ghosts.sh RIFT SCENES
set -euo pipefail
rift=$1
scene=$2/blasted_slice.prm

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# warns FOLDER PATTERN: once in the log, and in the summary, where quotation
# marks stand behind backslashes.
warns() {
  [ "$(grep -c "^WARNING: .*$2" "$1/log.txt")" = 1 ] ||
    fail "$1/log.txt does not warn once of: $2"
  grep -q "^    \".*$2" "$1/summary.json" ||
    fail "$1/summary.json does not warn of: $2"
}

# work FOLDER: of the loads, J, without decimals.
work() {
  sed -n 's/^    "loads": \([0-9]*\)\.[0-9]*,$/\1/p' "$1/summary.json"
}

"$rift" "$scene" --output everywhere \
  --set "Boundary hole/Acts while attached=false" > everywhere.txt
warns everywhere 'goes on acting on [1-9][0-9]* of its 64 faces that have left'
warns everywhere 'the fastest fragment moves with [0-9]* m/s at '
warns everywhere 'pieces pass through each other, .* [1-9][0-9]* pairs of cells'

"$rift" "$scene" --output attached > attached.txt
! grep 'the load on boundary' attached/log.txt || fail "the load ends there"

# The work that no rock can take is ten times as large.
[ "$(work everywhere)" -gt $((5 * $(work attached))) ] ||
  fail "the load does $(work everywhere) J and $(work attached) J"

# What touches from the start, and is not kept apart.
"$rift" "$2/three_blocks.prm" --output apart --set "Contact/Contact=false" \
  --set "Time/End time=1e-6" > apart.txt
warns apart 'the mesh has [23] separate bodies, and nothing keeps them apart'

# Contact keeps the pieces apart, and nothing is fast where nothing is torn off.
"$rift" "$2/three_blocks.prm" --output touching \
  --set "Output/Solution interval=1e-6" \
  --set "Time/End time=1e-6" > touching.txt
grep -q '"warnings": \[\],' touching/summary.json ||
  fail "there is nothing to warn of"
