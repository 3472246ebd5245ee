# Goes on where a pressure has ended on faces that have left their place, between
# two looks at the pieces. Warnings are not repeated.
#
#   bash in_place.sh RIFT RANKS
. "$(dirname "$0")/common.sh"
scene=("$here/../scenes/blasted_slice.prm"
  --set "Output/Solution interval=3e-5")
short=("${scene[@]}" --set "Time/End time=60e-6")
goes_on 150 250 50 "${short[@]}"

expect 0 1 "${short[@]}" --output everywhere \
  --set "Boundary hole/Acts while in place=false"
[ "$(hash_of everywhere)" != "$(hash_of whole)" ] ||
  fail "the load has ended nowhere"

# A checkpoint behind a look at the pieces that has led to warnings.
longer=("${scene[@]}" --output longer
  --set "Checkpoint/Interval in steps=510")
expect 0 1 "${longer[@]}"
grep WARNING longer/log.txt | sort > first
[ -s first ] || fail "there is nothing to warn of"
expect 0 1 "${longer[@]}" --restart
grep WARNING longer/log.txt | sort | cmp - first || fail "warned again"
sed -n 's/^WARNING: //p' longer/log.txt | sort > logged
python3 -c '
import json
print(*sorted(json.load(open("longer/summary.json"))["warnings"]), sep="\n")' |
  LC_ALL=C sort > summarized
LC_ALL=C sort logged | cmp - summarized || fail "summary.json has other warnings"
