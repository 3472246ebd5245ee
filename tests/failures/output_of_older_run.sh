mkdir results
echo > results/energy.csv
echo > results/summary.json
