# Nobody reads what rift prints: a pipe that is closed, a terminal that hangs up.
#
#   bash closed_output.sh RIFT
. "$(dirname "$0")/common.sh"
# What rift prints is not for the file said here.
alone=(env PMIX_MCA_gds=hash OMPI_MCA_btl=self "$rift" "$here/bar.prm")
expect 0 1 "$here/bar.prm" --output whole

# A pipe whose reader leaves after the first line.
"${alone[@]}" --output piped 2>errors | head -n 1 >first_line
codes=("${PIPESTATUS[@]}")
[ "${codes[0]}" = 0 ] || fail "rift ended with ${codes[0]}: $(cat errors)"
says "A bar that breaks" first_line
[ ! -s errors ] || fail "rift complains: $(cat errors)"
[ "$(sed 's/ in [0-9]* s;/;/' piped/log.txt | tail -n 1)" = \
  "$(sed 's/ in [0-9]* s;/;/' whole/log.txt | tail -n 1)" ] ||
  fail "the log has not come to its end: $(tail -n 1 piped/log.txt)"
same_results whole piped

# A full disk behind the standard output.
"${alone[@]}" --output full >/dev/full || fail "rift ended with $?"
same_results whole full

# A terminal: `script` makes one, and closes it when it is killed. The shell gets
# SIGHUP then and passes it on, as an interactive one does.
cat >in_terminal.sh <<END
trap 'kill -HUP \$job' HUP
${alone[*]} --output hung --set "Time/End time=1" &
job=\$!
echo \$job >job
wait \$job
wait \$job
echo \$? >code
END
script -q -c "exec sh in_terminal.sh" /dev/null </dev/null >/dev/null 2>&1 &
terminal=$!
until [ -s hung/log.txt ]; do
  sleep .01
  kill -0 "$terminal" 2>/dev/null || fail "the terminal has gone"
done
grep -q "A bar that breaks" hung/log.txt || fail "rift has not begun"
kill -KILL "$terminal"
for ((i = 0; i < 1000; ++i)); do
  [ -s code ] && break
  sleep .01
done
[ -s code ] || { kill -KILL "$(cat job)"; fail "rift has not ended"; }
[ "$(cat code)" = 4 ] || fail "rift ended with $(cat code) when its terminal hung up"
[ -e hung/checkpoint/*/manifest ] || fail "there is no checkpoint"
