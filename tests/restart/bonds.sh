# Goes on with bonds between the parts of nodes, with strengths that vary in space
# and with contact, which takes over faces that have failed.
#
#   bash bonds.sh RIFT RANKS [ELEMENT_SIZE]
. "$(dirname "$0")/common.sh"
goes_on 400 450 50 "$here/spalling.prm" \
  --set "Fracture/Cohesive law=bonds" --set "Time/Time step=2e-7" \
  --set "Material granite/Weibull modulus=24" \
  --set "Material granite/Correlation length=15e-3" \
  --set "Mesh/Element size=${3:-7e-3}" --set "Contact/Contact=true"
# Where cracks slide under pressure, at steps in which nodes are chosen (odd), and
# between two in which normals are turned (multiples of 16).
rm -r whole run
goes_on 101 109 1 "$here/sliding.prm"
