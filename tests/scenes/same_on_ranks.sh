#!/usr/bin/env bash
# Runs a scene on several numbers of ranks, with both ways to divide the cells,
# and twice on the first; fails unless all results are the same to the last bit:
# the hash of the state, the histories, the fragments.
#
# usage: same_on_ranks.sh RIFT FOLDER "RANKS..." SCENE.prm [options of rift]
set -euo pipefail
rift=$1
folder=$2
ranks=$3
shift 3

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1

rm -rf "$folder"
mkdir -p "$folder"
reference=
run() { # NAME RANKS [options]
  local results=$folder/$1 n=$2
  shift 2
  mpirun -np "$n" "$rift" "$@" --output "$results" > "$results.log" 2>&1 || {
    cat "$results.log"
    exit 1
  }
  grep -o '"state_hash": "[0-9a-f]*"' "$results/summary.json" \
    > "$results/hash.txt"
  reference=${reference:-$results}
  for file in hash.txt energy.csv fragments.csv \
    $(cd "$reference" && ls probes.csv 2> /dev/null || true); do
    cmp "$reference/$file" "$results/$file"
  done
  echo "$results: $(cat "$results/hash.txt")," \
    "$(grep -o '"faces_inserted": [0-9]*' "$results/summary.json")"
}

for n in $ranks; do
  run "curve-$n" "$n" "$@"
  [ "$n" = 1 ] || run "metis-$n" "$n" "$@" --set Mesh/Partition=metis
done
run again "${ranks%% *}" "$@"
