#!/usr/bin/env bash
# Pulls a prism apart with bonds. Fails unless the largest pull is the tensile
# strength times the section, and the fracture energy that of one section.
#
#   slow_tension.sh RIFT SCENE FOLDER ELEMENT_SIZE
set -euo pipefail
rm -rf "$3"
"$1" "$2" --output "$3" --set "Mesh/Element size=$4" > /dev/null
awk -F, '
  # Of the grip, which has its speed after 40 us.
  function displacement(t) {
    return .1 * (t < 40e-6 ? t * t / 80e-6 : t - 20e-6)
  }
  NR == 1 {
    for (i = 1; i <= NF; ++i)
      column[$i] = i
  }
  NR > 2 {
    pull = ($column["loads [J]"] - work) / (displacement($1) - last)
    if (pull > peak)
      peak = pull
  }
  NR > 1 {
    work = $column["loads [J]"]
    last = displacement($1)
    fracture = $column["fracture [J]"]
  }
  END {
    section = 64e-6
    peak /= section * 15e6
    fracture /= section * 400
    print "peak / strength", peak, "fracture / (G A)", fracture
    exit !(peak > .97 && peak < 1.06 && fracture > 1 && fracture < 1.15)
  }' "$3/energy.csv"
