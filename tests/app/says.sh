# says.sh TEXT COMMAND...: fails unless the command ends with 0 and says TEXT, in
# which * stands for anything.
text=$1
shift
said=$("$@" 2>&1) && [[ $said == *$text* ]] || {
  echo "FAILED: $* said: $said" >&2
  exit 1
}
