soms generate city --triangles 3000 -o city.ply
soms generate car -o car.ply
soms generate knot --triangles 2000 -o tool.stl
soms generate sphere --triangles 800 -o cell.ply
printf 'x,y,z\n0.5,0,0\n9,0,0\n' > poses.csv
soms overlap tool.stl cell.ply --pose poses.csv --report answer.html
soms distance tool.stl cell.ply --pose poses.csv --report distance.html
soms within tool.stl cell.ply --pose poses.csv --clearance 0.5 --report within.html
