"$RIFT" good.prm --output results --set "Time/Time step=1e-7" \
  --set "Checkpoint/Interval in steps=300"
