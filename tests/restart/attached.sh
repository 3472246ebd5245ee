# Goes on where a pressure has ended on faces that have come off, between two
# looks at the pieces.
#
#   bash attached.sh RIFT RANKS
. "$(dirname "$0")/common.sh"
goes_on 150 250 50 "$here/../scenes/blasted_slice.prm" \
  --set "Time/End time=60e-6" --set "Output/Solution interval=3e-5"
