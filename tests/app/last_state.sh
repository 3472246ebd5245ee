# Runs write their last row, their last state and their summary whether they come
# to their end or are stopped by a guard, whose message stays as it is.
#
#   bash last_state.sh RIFT FAILURES RANKS
#
# FAILURES is the folder of tests/failures, whose scenes these are.
set -u
rift=$1
ranks=$3
ln -sf "$2"/*.prm "$2"/*.geo .

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_mpi_yield_when_idle=1

# Of a state that is due at the start alone.
interval=1

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# run RANKS NAME [options]: a scene of tests/failures, into $results.
run() {
  local n=$1 name=$2
  shift 2
  local command=("$rift")
  [ "$n" = 1 ] || command=(mpirun -q -np "$n" --oversubscribe "$rift")
  "${command[@]}" "$name.prm" --output "$results" \
    --set "Output/Solution interval=1" --set "Output/History interval=$interval" \
    "$@" >said 2>error
  code=$?
}

last_time_of() { # energy.csv, or probes.csv
  tail -n 1 "$results/$1" | cut -d , -f 1
}

# is_complete: fails unless the results end with one and the same time.
is_complete() {
  local summary=$results/summary.json time last
  time=$(sed -n 's/.*"time": \(.*\),$/\1/p' "$summary")
  [ "$(awk -v t="$(last_time_of energy.csv)" -v s="$time" \
    'BEGIN { print t == s }')" = 1 ] ||
    fail "$results: energy.csv ends at $(last_time_of energy.csv), not $time"
  last=$(grep -o 'timestep="[^"]*" part="0" file="[^"]*"' "$results/solid.pvd" |
    tail -n 1)
  [[ $last == *'"'$(last_time_of energy.csv)'"'*solid-0000* ]] ||
    fail "$results: the last state is $last, not of $time"
  [ -s "$results/$(sed 's/.*file="//; s/"//' <<<"$last")" ] ||
    fail "$results: $last is missing"
  [ -s "$results/fragments.csv" ] || fail "$results: no fragments.csv"
}

# stops MESSAGE: fails unless the run has stopped with this error, a regular
# expression, and written what it came to.
stops() {
  local summary=$results/summary.json
  [ $code = 2 ] || fail "$results: exit code $code: $(cat said error)"
  grep -qE "^rift: error: $1" error || fail "$results: $(cat error)"
  grep -q '"completed": false,' "$summary" || fail "$(cat "$summary")"
  # As JSON has it.
  [ "$(sed -n 's/.*"stopped_by": "\(.*\)",$/\1/p' "$summary")" = \
    "$(sed 's/^rift: error: //; s/"/\\"/g' error)" ] ||
    fail "$results: another message: $(cat "$summary" error)"
  is_complete
}

for n in 1 "$ranks"; do
  # The balance is looked at in each step that has a row: 0 to 3.
  results=energy-$n interval=0
  run "$n" energy_runs_away
  stops "energy runs away: the balance is wrong by"
  [ "$(wc -l <$results/energy.csv)" = 5 ] || fail "$(cat $results/energy.csv)"
  interval=1

  results=inverted-$n
  run "$n" pressure_too_high --set "Time/Largest energy residual=1e30"
  stops "cell [0-9]* of rock at .* of its volume; below 0.5"

  results=turning-$n
  run "$n" rigid_pushed
  stops "step 0: a rigid body of steel turns by more than 60 degrees"
  [ "$(wc -l <$results/energy.csv)" = 2 ] || fail "$(cat $results/energy.csv)"

  # What contact finds out between two steps.
  results=racing-$n
  run "$n" blocks --set "Material steel/Velocity y=t < 2e-6 ? 0 : 1e5" \
    --set "Time/Time step=1e-6"
  stops "contact: at step 3 something moves with 1e\+05 m/s"
done

# The end of a run is no multiple of the interval.
results=end
run 1 good
[ $code = 0 ] || fail "$(cat said error)"
is_complete
grep -q '"completed": true,' end/summary.json || fail "$(cat end/summary.json)"
! grep -q stopped_by end/summary.json || fail "$(cat end/summary.json)"
[ "$(grep -c DataSet end/solid.pvd)" = 2 ] || fail "$(cat end/solid.pvd)"

# On one rank a cell that has left its range is reported in the same step: its
# state can still be looked at.
results=inverted-1
awk -F , 'END { exit !($1 < 3e-7) }' $results/energy.csv ||
  fail "a late state: $(last_time_of energy.csv)"

# A disk that is full only now does not hide the first cause.
results=full interval=0
ulimit -f $(($(stat -c %s energy-1/solid-00000.vtu) / 1024 + 1))
export PMIX_MCA_gds=hash OMPI_MCA_btl=self
run 1 energy_runs_away
[ $code = 2 ] && grep -q "^rift: error: energy runs away" error ||
  fail "full disk: $code $(cat error)"
grep -q "WARNING: not all of the state at which the run has failed could be \
written. Cannot write full/solid-00001.vtu.tmp: File too large" said ||
  fail "full disk: $(cat said)"
grep -q '"stopped_by": "energy runs away' full/summary.json ||
  fail "full disk: $(cat full/summary.json)"
