# The disk is full while a checkpoint is written, and while the log is.
#
#   bash disk_full.sh RIFT RANKS
. "$(dirname "$0")/common.sh"
# A new division of the cells would change the sizes of the files.
arguments=("$here/bar.prm" --set "Checkpoint/Interval in steps=50"
  --set "Checkpoint/Number of sets=100" --set "Checkpoint/Largest imbalance=0")

# The sets of later steps are larger, as more faces are open.
expect 0 "$ranks" "${arguments[@]}" --output whole
largest=$(stat -c %s whole/checkpoint/300/rank-* | sort -n | tail -1)

limit=$((largest / 1024 + 1))
expect 3 "$ranks" "${arguments[@]}" --output run
limit=
says "rift: error: Cannot write run/checkpoint/350.tmp/rank-0000[0-9]: File too \
large. Raise the limit on the size of a file (ulimit -f), or write to another \
disk." said
[ "$(ls -v run/checkpoint | tail -2 | xargs)" = "300 mesh" ] ||
  fail "not only good sets are left: $(ls run/checkpoint)"
expect 0 "$ranks" "${arguments[@]}" --output run --restart
says "Going on from run/checkpoint/300" run/log.txt
same_results whole run

# Only the rank that writes the log sees that it cannot be written.
keep_sets_until 200 run
mv run/log.txt log.txt
limit=8192
truncate -s $((1024 * limit - 500)) run/log.txt
expect 3 "$ranks" "${arguments[@]}" --output run --restart
limit=
says "rift: error: Cannot write run/log.txt: File too large" said
mv log.txt run/log.txt
expect 0 "$ranks" "${arguments[@]}" --output run --restart
same_results whole run

# One of the files of the end cannot be written: the others are.
for name in fragments.csv summary.json; do
  mkdir -p "without_$name/$name"
  expect 3 "$ranks" "$here/bar.prm" --output "without_$name"
  says "rift: error: Cannot [a-z]* without_$name/$name: Is a directory. " said
  for other in fragments.csv summary.json energy.csv probes.csv; do
    [ $other = $name ] || [ -s "without_$name/$other" ] ||
      fail "without $name there is no $other"
  done
  cmp whole/energy.csv "without_$name/energy.csv" || fail "energy.csv differs"
done
