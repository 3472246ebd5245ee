# Goes on with the intrinsic model, where all faces have cohesive elements and
# only some of them a memory: in the midst of cracking, on other ranks.
#
#   bash intrinsic.sh RIFT RANKS [ELEMENT_SIZE]
. "$(dirname "$0")/common.sh"
scene=("$here/spalling.prm" --set "Fracture/Cohesive model=intrinsic"
  --set "Fracture/Cohesive penalty=10 E" --set "Time/Time step=9e-8"
  --set "Mesh/Element size=${3:-7e-3}")
every=(--set "Checkpoint/Interval in steps=100"
  --set "Checkpoint/Number of sets=100")

expect 0 1 "${scene[@]}" --output whole
expect 0 1 "${scene[@]}" --output run "${every[@]}"
same_results whole run
keep_sets_until 900 run
for n in "$ranks" 1; do
  keep_sets_until 1000 run
  expect 0 "$n" "${scene[@]}" --output run "${every[@]}" --restart
  same_results whole run
done
! grep -q '"fracture": 0,' whole/summary.json || fail "nothing has softened"
