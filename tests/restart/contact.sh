# Goes on in the midst of contact, on other ranks: a block that slides over a
# table, a disc that breaks between platens, a rigid block that turns, a heap of
# fragments, a plate that is shattered.
#
#   bash contact.sh RIFT RANKS "SCENE..."
. "$(dirname "$0")/common.sh"
contact=$here/../../prm/contact
# Between two looks of contact at the cracks, which are every ten steps.
every=(--set "Checkpoint/Interval in steps=41"
  --set "Checkpoint/Number of sets=100")

# goes_on NAME WRITERS STEP SCENE...: the checkpoint is of so many ranks, with
# cells in any order. Only if NAME is one of those that are asked for.
wanted=$3
goes_on() {
  local name=$1 writers=$2 step=$3
  shift 3
  [[ " $wanted " == *" $name "* ]] || return 0
  expect 0 1 "$@" --output "$name-whole"
  expect 0 "$writers" "$@" --output "$name" "${every[@]}" \
    --set Mesh/Partition=metis
  same_results "$name-whole" "$name"
  for n in "$ranks" $((ranks + 1)) 1; do
    keep_sets_until $step "$name"
    expect 0 "$n" "$@" --output "$name" "${every[@]}" --restart
    same_results "$name-whole" "$name"
  done
  ! grep -q '"contact_pairs": 0,' "$name/summary.json" || fail "nothing touches"
}

goes_on block 1 82 "$contact/block.prm" --set "Time/End time=6e-5" \
  --set "Output/Solution interval=3e-5"

# While cracks grow, their sides are released, and these touch.
goes_on disc 2 1025 "$here/../../prm/brazilian/bd_ani.prm" \
  --set "Mesh/Element size=4e-3" --set "Time/End time=115e-6" \
  --set "Output/Solution interval=115e-6"

goes_on rigid 3 205 "$here/../scenes/rigid_collision.prm" \
  --set "Time/End time=2.5e-4"

goes_on pile 2 410 "$contact/pile.prm" \
  --set "Mesh/Parameters=n_x = 3, n_y = 3, n_z = 2" \
  --set "Material lower/Initial velocity=0.3, 0, -2" \
  --set "Material upper/Initial velocity=0, 0.2, -3" \
  --set "Time/End time=0.015" --set "Output/Solution interval=0.015"

goes_on plate 1 82 "$contact/plate.prm" \
  --set "Mesh/Element size=8e-3" --set "Mesh/Parameters=width = 0.06" \
  --set "Time/End time=4e-5" --set "Output/Solution interval=2e-5"
