# Starts a second run in the directory of one that is at work, and in that of
# one that was killed.
#
#   bash two_runs.sh RIFT RANKS
. "$(dirname "$0")/common.sh"
arguments=("$here/bar.prm" --output out --set Output/Overwrite=true
  --set "Checkpoint/Interval in steps=50")

job=
trap '[ -z "$job" ] || kill "$job" 2>/dev/null' EXIT
start "$ranks" "${arguments[@]}" --set "Time/End time=1"
until [ -e out/checkpoint/50 ]; do
  sleep .01
  kill -0 "$job" 2>/dev/null || fail "the run has ended: $(cat said)"
done
mv said said_by_first
processes=$(processes_of_job "$ranks")
holder=$(sed -n 's/^process \([0-9]*\) on host .*/\1/p' out/rift.lock)
grep -qw "$holder" <<<"$processes" ||
  fail "the lock is of $holder, which is not one of $processes"

# Neither another run nor a restart touches anything.
for option in "" --restart; do
  # shellcheck disable=SC2086
  expect 1 "$ranks" "${arguments[@]}" $option
  says "rift: error: The output directory out is in use by another run of rift, \
process $holder on host $(uname -n). Wait for its end, stop it, or choose another \
directory with --output." said
done
[ -e out/checkpoint/mesh ] || fail "the checkpoints are gone"

# The lock vanishes with the process.
# shellcheck disable=SC2086
kill -KILL $processes
wait "$job"
job=
[ -e out/rift.lock ] || fail "there is no lock that was left behind"
expect 0 "$ranks" "${arguments[@]}"
[ ! -e out/rift.lock ] || fail "the lock is still there at the end"
expect 0 1 "$here/bar.prm" --output whole
same_results whole out
