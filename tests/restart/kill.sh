# Kills all ranks at random moments and goes on, until the run is done; as often
# as asked for.
#
#   bash kill.sh RIFT RANKS REPETITIONS
. "$(dirname "$0")/common.sh"
arguments=("$here/bar.prm" --output run
  --set "Checkpoint/Interval in steps=20")

launch_time=$(date +%s%N)
expect 0 "$ranks" "${arguments[@]}"
milliseconds=$((($(date +%s%N) - launch_time) / 1000000))
rm -rf whole
mv run whole
n_kills=0
n_unfinished=0

# Starts the run or goes on with it and kills it, perhaps; $code is how it ended.
attempt() {
  local mode
  if compgen -G "run/checkpoint/*[0-9]" >/dev/null; then
    mode=--restart
  else
    mode=--set=Output/Overwrite=true
  fi
  start "$ranks" "${arguments[@]}" $mode
  local delay=$((RANDOM * milliseconds / 32768 + 1))
  sleep $((delay / 1000)).$(printf %03d $((delay % 1000)))
  # shellcheck disable=SC2046
  kill -KILL $(processes_of_job "$ranks") 2>/dev/null
  wait "$job" 2>/dev/null
  code=$?
}

for i in $(seq "$repetitions"); do
  rm -rf run
  code=137
  for attempts in $(seq 200); do
    attempt
    [ $code = 0 ] && break
    [ $code = 137 ] || fail "in run $i, attempt $attempts, rift ended with
      $code: $(cat said)"
    n_kills=$((n_kills + 1))
    ls run/checkpoint/*.tmp >/dev/null 2>&1 && n_unfinished=$((n_unfinished + 1))
  done
  [ $code = 0 ] || fail "run $i was killed 200 times"
  same_results whole run
  ! grep "WARNING.*checkpoint" run/log.txt ||
    fail "run $i: a killed run has left a damaged checkpoint"
done
echo "$repetitions runs on $ranks ranks, killed $n_kills times, $n_unfinished" \
  "of them while a checkpoint was written"
