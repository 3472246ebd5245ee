# Goes on with another cohesive law, which remembers other things.
#
#   bash linear.sh RIFT RANKS [ELEMENT_SIZE]
. "$(dirname "$0")/common.sh"
goes_on 400 450 50 "$here/spalling.prm" \
  --set "Fracture/Cohesive law=linear" --set "Time/Time step=2e-7" \
  --set "Mesh/Element size=${3:-7e-3}"
