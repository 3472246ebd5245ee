# Kills all ranks at random moments, as often as asked for. A run that has been
# killed is gone on with; one that is done is looked at, and another begins.
#
#   bash kill.sh RIFT RANKS KILLS
. "$(dirname "$0")/common.sh"
arguments=("$here/bar.prm" --output run
  --set "Checkpoint/Interval in steps=20")

launch_time=$(date +%s%N)
expect 0 "$ranks" "${arguments[@]}"
milliseconds=$((($(date +%s%N) - launch_time) / 1000000))
rm -rf whole
mv run whole
n_kills=0
n_runs=0
n_unfinished=0

# Starts the run, or goes on with it when there is a checkpoint. It is killed
# before long, but for the last time.
attempt() {
  local mode=--set=Output/Overwrite=true delay
  if compgen -G "run/checkpoint/*[0-9]" >/dev/null; then
    mode=--restart
  fi
  start "$ranks" "${arguments[@]}" $mode
  # mpirun may end this script as well when a rank is killed that has not left
  # its process group yet: all are there, and a moment is over.
  local i
  for ((i = 0; i < 3000; ++i)); do
    [ "$(processes_of_job "$ranks" | wc -w)" != "$ranks" ] &&
      kill -0 "$job" 2>/dev/null || break
    sleep .01
  done
  local is_killed=false
  if [ $n_kills -lt "$repetitions" ]; then
    is_killed=true
    delay=$((RANDOM * milliseconds / 32768 + 50))
    sleep $((delay / 1000)).$(printf %03d $((delay % 1000)))
    # shellcheck disable=SC2046
    kill -KILL $(processes_of_job "$ranks") 2>/dev/null
  fi
  await_job $((30 + 10 * milliseconds / 1000))
  if [ -n "$is_hanging" ]; then
    # It may also hang while it clears up. Not so rift.
    [ $is_killed = true ] && [ -z "$(living_processes)" ] ||
      fail "after $n_kills kills rift hangs: $(cat said)"
    kill -KILL "$job"
  fi
  wait "$job" 2>/dev/null
  code=$?
}

# The processes of rift that have not ended; mpirun may not have reaped those
# that have.
living_processes() {
  if [ "$ranks" = 1 ]; then
    ps -o stat= -p "$job" | grep -v '^Z'
  else
    ps -o stat= --ppid "$job" | grep -v '^Z'
  fi
}

# Waits for the job to end, but no longer than so many seconds.
await_job() {
  local i
  is_hanging=
  for ((i = 0; i < 10 * $1; ++i)); do
    kill -0 "$job" 2>/dev/null || return 0
    sleep .1
  done
  is_hanging=true
}

# Whether the last attempt has been killed. mpirun may end with another code: it
# has crashed while it cleared up after a killed rank.
was_killed() {
  [ $code = 137 ] || grep -q "exited on signal 9 (Killed)" said
}

code=137
while [ $n_kills -lt "$repetitions" ] || was_killed; do
  attempt
  if was_killed; then
    n_kills=$((n_kills + 1))
    ls run/checkpoint/*.tmp >/dev/null 2>&1 && n_unfinished=$((n_unfinished + 1))
    continue
  fi
  [ $code = 0 ] ||
    fail "after $n_kills kills rift ended with $code: $(cat said)"
  same_results whole run
  ! grep "WARNING.*checkpoint" run/log.txt ||
    fail "a killed run has left a damaged checkpoint"
  n_runs=$((n_runs + 1))
  rm -r run
done
echo "$n_runs runs on $ranks ranks, killed $n_kills times, $n_unfinished of" \
  "them while a checkpoint was written"
