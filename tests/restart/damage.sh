# Flips a random bit of a checkpoint or cuts off one of its files, as often as
# asked for, and goes on.
#
#   bash damage.sh RIFT RANKS REPETITIONS
. "$(dirname "$0")/common.sh"
arguments=("$here/bar.prm" --set "Checkpoint/Interval in steps=133")
newest=399
older=266

random_below() {
  echo $(((RANDOM * 32768 + RANDOM) % $1))
}

flip_bit() {
  local position byte
  position=$(random_below "$(stat -c %s "$1")")
  byte=$(od -An -tu1 -j "$position" -N 1 "$1")
  byte=$((byte ^ (1 << RANDOM % 8)))
  printf "\\x$(printf %02x $byte)" |
    dd of="$1" bs=1 seek="$position" conv=notrunc status=none
}

damage() {
  if [ $((RANDOM % 2)) = 0 ]; then
    flip_bit "$1"
  else
    truncate -s "$(random_below "$(stat -c %s "$1")")" "$1"
  fi
}

# any FILES...: one of them
any() {
  shift $((RANDOM % $#))
  echo "$1"
}

expect 0 "$ranks" "${arguments[@]}" --output whole
n_good=0
n_older=0
n_none=0
for i in $(seq "$repetitions"); do
  rm -rf run
  cp -r whole run
  rm run/summary.json
  case $((RANDOM % 4)) in
    0) # All is lost
      damage run/checkpoint/mesh
      going_on= ;;
    1)
      damage "$(any run/checkpoint/$newest/*)"
      damage "$(any run/checkpoint/$older/*)"
      going_on= ;;
    2)
      damage "$(any run/checkpoint/$older/*)"
      going_on=$newest ;;
    3)
      damage "$(any run/checkpoint/$newest/*)"
      going_on=$older ;;
  esac
  if [ -z "$going_on" ]; then
    expect 1 1 "${arguments[@]}" --output run --restart
    says "rift: error: There is no undamaged checkpoint in run/checkpoint" said
    n_none=$((n_none + 1))
    continue
  fi
  expect 0 1 "${arguments[@]}" --output run --restart
  same_results whole run
  says "Going on from run/checkpoint/$going_on" run/log.txt
  if [ $going_on = $older ]; then
    says "WARNING: .*run/checkpoint/$newest/" run/log.txt
    n_older=$((n_older + 1))
  else
    n_good=$((n_good + 1))
  fi
done
echo "$repetitions times damaged; gone on with the newest: $n_good, the older:" \
  "$n_older, not: $n_none"
