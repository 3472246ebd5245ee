# What the scripts say to wrong arguments.
#
#   bash messages.sh FOLDER_OF_SCRIPTS
scripts=$1

# says CODE TEXT COMMAND...: fails unless the command ends so and says that.
says() {
  local code=$1 text=$2 said
  shift 2
  said=$("$@" 2>&1)
  [ $? = "$code" ] && [[ $said == *"$text"* ]] || {
    echo "FAILED: $* said: $said" >&2
    exit 1
  }
}

says 0 "usage: scripts/run [-n RANKS] SCENE.prm" "$scripts/run" --help
says 0 "usage: scripts/run [-n RANKS] SCENE.prm" "$scripts/run" scene.prm -h
says 1 '-n wants a number of ranks, not "x"' "$scripts/run" scene.prm -n x
says 1 '-n wants a number of ranks, not ""' "$scripts/run" scene.prm -n
says 1 "scripts/documentation needs the package doxygen. Run scripts/install" \
  env PATH=/nowhere "$BASH" "$scripts/documentation"

python=/usr/bin/python3
[ -x $python ] || exit 0
for name in compare_spalling plot_spalling plot_shpb plot_scaling \
  plot_brazilian plot_static \
  render_spalling; do
  # -S: without installed packages
  says 1 "usage: " $python -S "$scripts/$name.py"
done
for name in plot_spalling plot_scaling; do
  says 1 "$name.py needs the package python3-numpy; try /usr/bin/python3" \
    $python -S "$scripts/$name.py" nowhere figure.png
done
says 1 "there is no solid.pvd in nowhere." \
  $python -S "$scripts/render_spalling.py" nowhere picture.png
$python -c "import matplotlib" 2>/dev/null || exit 0
says 1 "cannot read nowhere/probes.csv: No such file or directory" \
  $python "$scripts/plot_spalling.py" nowhere figure.png
says 1 "cannot read nowhere/probes.csv: No such file or directory" \
  $python "$scripts/compare_spalling.py" figure.png "ECZM=nowhere"
# Runs that have been stopped.
mkdir -p stopped
echo "time [s],a [m]" >stopped/probes.csv
says 1 "stopped/probes.csv has no rows: the run has been stopped before" \
  $python "$scripts/plot_spalling.py" stopped figure.png
echo "0" >>stopped/probes.csv
says 1 "stopped/probes.csv is damaged: not all of its rows are 2 numbers" \
  $python "$scripts/plot_spalling.py" stopped figure.png
gauges="incident gauge [Pa],incident gauge velocity [m/s],transmission gauge [Pa]"
echo "time [s],$gauges" >stopped/probes.csv
for ((i = 0; i < 200; ++i)); do
  echo "$i.0e-6,-$i,0,-$i" >>stopped/probes.csv
done
says 1 "P2 has not come to a peak" \
  $python "$scripts/plot_shpb.py" stopped figure.png
head -n 20 stopped/probes.csv >stopped/short && mv stopped/short stopped/probes.csv
says 1 "the run ends before any wave has passed the disc" \
  $python "$scripts/plot_shpb.py" stopped figure.png
says 1 "cannot read nowhere: No such file or directory" \
  $python "$scripts/plot_scaling.py" nowhere figure.png
