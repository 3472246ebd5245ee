# Stops runs by signals to the ranks and goes on.
#
#   bash signals.sh RIFT RANKS [END_TIME]
. "$(dirname "$0")/common.sh"
# Or bash has jobs in the background ignore SIGINT.
set -m
arguments=("$here/bar.prm" --set "Time/End time=${3:-200e-6}")

expect 0 1 "${arguments[@]}" --output whole
for signal in TERM USR1 USR2 XCPU HUP INT; do
  start "$ranks" "${arguments[@]}" --output $signal
  until [ -s $signal/log.txt ]; do
    sleep .01
    kill -0 "$job" 2>/dev/null || fail "the run has ended: $(cat said)"
  done
  # shellcheck disable=SC2046
  kill -$signal $(processes_of_job "$ranks")
  wait "$job"
  code=$?
  [ $code = 4 ] || fail "after SIG$signal the code is $code: $(cat said)"
  says "rift: error: stopped by a signal at step [0-9]*, t = [0-9.e-]* s. Go on \
with --restart." said
  step=$(sed -n "s/.*stopped by a signal at step \([0-9]*\),.*/\1/p" said)
  [ "$(ls $signal/checkpoint)" = "$step"$'\n'mesh ] ||
    fail "no checkpoint of step $step: $(ls $signal/checkpoint)"
  # All stop a run in the same way, so that few show that it can go on.
  [[ $signal = @(TERM|USR1|INT) ]] || continue
  expect 0 "$ranks" "${arguments[@]}" --output $signal --restart
  says "Going on from $signal/checkpoint/$step" $signal/log.txt
  same_results whole $signal
done

# A run that goes on to a later end: the summary and the fragments of the older
# one are gone.
older=("$here/bar.prm" --output older --set "Checkpoint/Interval in steps=100")
expect 0 1 "${older[@]}"
start 1 "${older[@]}" --set "Time/End time=1" --restart
while [ -e older/summary.json ]; do
  sleep .01
  kill -0 "$job" 2>/dev/null || fail "the run has ended: $(cat said)"
done
kill -INT "$job"
wait "$job"
code=$?
[ $code = 4 ] || fail "after SIGINT the code is $code: $(cat said)"
[ ! -e older/fragments.csv ] || fail "fragments of the older end are still there"
