"$RIFT" good.prm --output results --set "Time/Time step=1e-7"
