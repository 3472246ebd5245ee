#!/usr/bin/env bash
# Runs a scene on several numbers of ranks; fails unless all results are the same
# to the last bit: the hash of the state, the histories, the fragments.
#
# usage: same_on_ranks.sh [--cracks] [--contact] RIFT FOLDER "RUN..." SCENE.prm
#          [options of rift]
#
# A RUN is a number of ranks, as in 3, or as in 3:metis where METIS divides the
# cells. One that is named twice is made twice. Where nothing happens, nothing is
# shown: --cracks fails unless faces are cut, --contact unless cells touch.
set -euo pipefail
cracks=
contact=
while [[ ${1:-} == --* ]]; do
  case $1 in
    --cracks) cracks=yes ;;
    --contact) contact=yes ;;
    *)
      echo "same_on_ranks.sh: there is no option $1" >&2
      exit 1
      ;;
  esac
  shift
done
rift=$1
folder=$2
runs=$3
shift 3

export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1

# run NAME RANKS [options of rift]
run() {
  local results=$folder/$1 n=$2
  shift 2
  if [ "$n" = 1 ]; then
    "$rift" "$@" --output "$results"
  else
    mpirun -np "$n" "$rift" "$@" --output "$results"
  fi > "$results.log" 2>&1 || {
    cat "$results.log"
    exit 1
  }
  grep -o '"state_hash": "[0-9a-f]*"' "$results/summary.json" \
    > "$results/hash.txt"
}

# fail TEXT
fail() {
  echo "FAILED: $1" >&2
  exit 1
}

# Something happens: faces_inserted of the summary, column contact of energy.csv.
check_events() {
  local results=$1
  if [ -n "$cracks" ]; then
    grep -q '"faces_inserted": [1-9]' "$results/summary.json" ||
      fail "no face has been cut"
  fi
  if [ -n "$contact" ]; then
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "contact [J]") column = i }
      NR > 1 && column && $column + 0 != 0 { found = 1 }
      END { exit !found }' "$results/energy.csv" || fail "no cells have touched"
  fi
}

rm -rf "$folder"
mkdir -p "$folder"
reference=
n_runs=0
for name in $runs; do
  n_runs=$((n_runs + 1))
  results=$folder/$n_runs-${name/:/-}
  options=()
  [[ $name != *:metis ]] || options=(--set Mesh/Partition=metis)
  run "${results##*/}" "${name%%:*}" "$@" ${options[@]+"${options[@]}"}
  if [ -z "$reference" ]; then
    reference=$results
    check_events "$reference"
  fi
  for file in hash.txt energy.csv fragments.csv \
    $(cd "$reference" && ls probes.csv 2> /dev/null || true); do
    cmp "$reference/$file" "$results/$file"
  done
  echo "$name: $(cat "$results/hash.txt")," \
    "$(grep -o '"faces_inserted": [0-9]*' "$results/summary.json")"
done
