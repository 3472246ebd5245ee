# Goes on with the intrinsic model, where all faces have cohesive elements and
# only some of them a memory: in the midst of cracking, on other ranks.
#
#   bash intrinsic.sh RIFT RANKS [ELEMENT_SIZE]
. "$(dirname "$0")/common.sh"
goes_on 900 1000 100 "$here/spalling.prm" \
  --set "Fracture/Cohesive model=intrinsic" \
  --set "Fracture/Cohesive penalty=10 E" --set "Time/Time step=9e-8" \
  --set "Mesh/Element size=${3:-7e-3}"
