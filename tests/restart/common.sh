# What the scripts of this folder share. Arguments: the program, the number of
# ranks, and how often.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rift=$1
ranks=${2:-1}
repetitions=${3:-1}
RANDOM=${SEED:-1}

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_mpi_yield_when_idle=1
# A killed rank cannot remove its shared memory: it stays in this folder.
export OMPI_MCA_btl_vader_backing_directory=$PWD

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# launch RANKS ARGUMENTS...: becomes rift; what it says goes to the file said.
# With a limit in KiB, files cannot become larger, as on a full disk.
limit=
launch() {
  local n=$1
  shift
  if [ -n "$limit" ]; then
    # MPI is told to make no files of its own for shared memory.
    export PMIX_MCA_gds=hash OMPI_MCA_btl=self,tcp
    ulimit -f "$limit"
  fi
  if [ "$n" = 1 ]; then
    PMIX_MCA_gds=hash OMPI_MCA_btl=self exec "$rift" "$@"
  else
    exec mpirun -np "$n" --oversubscribe "$rift" "$@"
  fi >said 2>&1
}

# expect CODE RANKS ARGUMENTS...: runs rift, which is to end with this code.
expect() {
  local expected=$1 code
  shift
  (launch "$@")
  code=$?
  [ $code = "$expected" ] ||
    fail "rift on $* ranks ended with $code, not $expected: $(cat said)"
}

# start RANKS ARGUMENTS...: runs rift in the background; $job is its process.
start() {
  launch "$@" &
  job=$!
}

# The processes of rift that start() has started on so many ranks.
processes_of_job() {
  if [ "$1" = 1 ]; then echo "$job"; else pgrep -P "$job"; fi
}

hash_of() {
  grep state_hash "$1/summary.json"
}

# same_results A B: fails unless both runs have ended in the same way. What
# cannot break has no fracture.pvd, a scene without probes no probes.csv.
same_results() {
  local file
  [ "$(hash_of "$1")" = "$(hash_of "$2")" ] ||
    fail "$1 and $2 end differently: $(hash_of "$1") $(hash_of "$2")"
  for file in probes.csv energy.csv fragments.csv solid.pvd fracture.pvd; do
    [[ $file = @(fracture.pvd|probes.csv) ]] && [ ! -e "$1/$file" ] && [ ! -e "$2/$file" ] ||
      cmp "$1/$file" "$2/$file" || fail "$file of $1 and $2 differ"
  done
}

# says TEXT FILE
says() {
  grep -q -e "$1" "$2" || fail "\"$1\" is not in $2: $(cat "$2")"
}

# keep_sets_until STEP DIRECTORY: removes the checkpoints of later steps.
keep_sets_until() {
  local set
  for set in "$2"/checkpoint/[0-9]*; do
    [ "${set##*/}" -le "$1" ] || rm -r "$set"
  done
}

# goes_on FIRST SECOND EVERY ARGUMENTS...: a run with a checkpoint every so many
# steps goes on from that of the first step on $ranks ranks, and from that of the
# second on one; it must have cracks.
goes_on() {
  local first=$1 second=$2 n
  local every=(--set "Checkpoint/Interval in steps=$3"
    --set "Checkpoint/Number of sets=200")
  shift 3
  expect 0 1 "$@" --output whole
  expect 0 1 "$@" --output run "${every[@]}"
  same_results whole run
  keep_sets_until "$first" run
  for n in "$ranks" 1; do
    keep_sets_until "$second" run
    expect 0 "$n" "$@" --output run "${every[@]}" --restart
    same_results whole run
  done
  ! grep -q '"fracture": 0,' whole/summary.json || fail "nothing has softened"
}
