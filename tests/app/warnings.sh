# Runs that make no sense any more say so, in the log and in summary.json: a hole
# is blown up without contact, with a pressure that goes on acting on what it has
# torn off, and with one that ends there; contact is too soft for an impact.
#
#   bash warnings.sh RIFT SCENES
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

"$rift" "$scene" --output everywhere --set Contact/Contact=false \
  --set "Boundary hole/Acts while in place=false" > everywhere.txt
warns everywhere 'still acts on all of its 64 faces although the pieces of [1-9]'
warns everywhere 'are faster than 516.4 m/s, a tenth of'
warns everywhere 'pieces overlap, .*: [1-9][0-9]* pairs of cells have more than'

"$rift" "$scene" --output in_place --set Contact/Contact=false > in_place.txt
! grep 'the load on boundary' in_place/log.txt || fail "the load ends there"

# It does ten times as much work on what has left its place.
[ "$(work everywhere)" -gt $((8 * $(work in_place))) ] ||
  fail "the load does $(work everywhere) J and $(work in_place) J"

# What touches from the start, and is not kept apart.
"$rift" "$2/three_blocks.prm" --output apart --set "Contact/Contact=false" \
  --set "Time/End time=1e-6" > apart.txt
warns apart 'the mesh has 3 separate bodies, and nothing keeps them apart'

# With the advice that it gives, contact is stiff enough.
"$rift" "$2/soft_impact.prm" --output soft > soft.txt
warns soft 'contact is too soft for this impact or load: 1 pair of cells has'
"$rift" "$2/soft_impact.prm" --output stiff \
  --set "Contact/Stiffness factor=1" > stiff.txt
! grep 'too soft' stiff/log.txt || fail "the advice does not help"

# A block is torn, its pieces touch, and a pressure stays where it was: nothing of
# this kind is wrong.
"$rift" "$2/torn_block.prm" --set Contact/Contact=true --output torn > torn.txt
! grep -E 'the load on boundary|the fastest fragment|overlap' torn/log.txt ||
  fail "there is nothing to warn of"
! grep -E '"(fragments|contact_pairs)": [01],' torn/summary.json ||
  fail "nothing is torn, or touches"
