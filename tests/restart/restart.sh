# Goes on in the midst of cracking. The checkpoints of one rank are gone on with
# on RANKS ranks, those on one more, those again on one.
#
#   bash restart.sh RIFT RANKS [ELEMENT_SIZE]
. "$(dirname "$0")/common.sh"
body=("$here/spalling.prm")
scene=("${body[@]}")
if [ $# -gt 2 ]; then
  # The number of steps is to stay what it is.
  body+=(--set "Mesh/Element size=$3")
  scene=("${body[@]}" --set "Time/Time step=2.174e-7")
fi
every=(--set "Checkpoint/Interval in steps=20"
  --set "Checkpoint/Number of sets=100")

expect 0 1 "${scene[@]}" --output whole

# Checkpoints change nothing
expect 0 1 "${scene[@]}" --output run "${every[@]}"
same_results whole run
[ -e run/checkpoint/20 ] && [ -e run/checkpoint/440 ] ||
  fail "not every 20 steps: $(ls run/checkpoint)"
! grep "divided anew" run/log.txt || fail "a single rank has unequal work"

# One restart after the other
step=380
for n in "$ranks" $((ranks + 1)) 1; do
  keep_sets_until $step run
  expect 0 "$n" "${scene[@]}" --output run "${every[@]}" --restart
  says "Going on from run/checkpoint/$step" run/log.txt
  same_results whole run
  step=$((step + 20))
done
! grep WARNING.*checkpoint run/log.txt || fail "a checkpoint was damaged"

# From the last moment: only the results of the end are written again
cp -r run at_end
rm at_end/summary.json at_end/fragments.csv
expect 0 1 "${scene[@]}" --output at_end "${every[@]}" --restart
says "Going on from at_end/checkpoint/460" at_end/log.txt
same_results whole at_end

# Cells divided anew at the first checkpoint and, where that does not cure the
# imbalance, not at the second, but at the third
if [ "$ranks" -gt 1 ]; then
  expect 0 "$ranks" "${scene[@]}" --output divided \
    --set "Checkpoint/Interval in steps=115" \
    --set "Checkpoint/Largest imbalance=1e-9"
  same_results whole divided
  [ "$(grep -c "divided anew" divided/log.txt)" = 2 ] ||
    fail "the cells were not divided anew twice"
fi

# A later end
fixed=(--set "Time/Time step=2e-7" --set "Checkpoint/Interval in steps=30")
expect 0 1 "${body[@]}" --output long "${fixed[@]}"
expect 0 1 "${body[@]}" --output short "${fixed[@]}" --set "Time/End time=91e-6"
expect 0 "$ranks" "${body[@]}" --output short "${fixed[@]}" --restart
same_results long short
