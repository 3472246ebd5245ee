# Runs in which much breaks, slides and is crushed come to their end, with their
# energy in balance: a hole with 1 GPa on its wall, and a cylinder between platens
# far beyond its strength.
#
#   bash to_the_end.sh RIFT PROJECT
set -euo pipefail
rift=$1
project=$2

fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# ends NAME SCENE...
ends() {
  local name=$1
  shift
  "$rift" "$@" --output "$name" --set "Output/Solution interval=0" \
    > "$name.txt" || fail "$name stops"
  grep -q '"completed": true' "$name/summary.json" || fail "$name does not end"
  ! grep 'contact is too soft' "$name/log.txt" || fail "$name is too soft"
  ! grep -q '"contact_pairs": 0,' "$name/summary.json" || fail "nothing touches"
  local residual
  residual=$(sed -n 's/^  "energy_residual_relative": \(.*\),$/\1/p' \
    "$name/summary.json")
  awk -v r="$residual" 'BEGIN { exit !(r != "" && r < 0.01) }' ||
    fail "the energy of $name is wrong by $residual"
}

ends hole "$project/tests/scenes/blasted_slice.prm" \
  --set "Mesh/Element size=12e-3" --set "Time/End time=200e-6" \
  --set "Boundary hole/Pressure=1e9*min(1,t/10e-6)*exp(-max(0,t-10e-6)/50e-6)"

ends cylinder "$project/prm/brazilian/ucs.prm" --set "Mesh/Element size=6e-3" \
  --set "Mesh/Parameters=diameter = 0.025, height = 0.05" \
  --set "Material upper platen/Velocity z=-min(1, t/100e-6)" \
  --set "Material lower platen/Velocity z=min(1, t/100e-6)"
