mkdir results
echo "subsection Mesh" > results/parameters.prm
