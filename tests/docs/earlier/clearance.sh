soms generate city --triangles 20000 -o town.ply
soms generate car -o car.ply
printf 'x,y,z\n-60,-2,0.5\n60,-2,0.5\n' > path.csv
soms clearance town.ply --profile car.ply --path path.csv --clearance 0.5 --map path.svg --report path.html -o path-gaps.csv
