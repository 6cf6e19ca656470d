soms generate knot --triangles 2000 -o knot.ply
printf 'x,y,z\n0,0,0\n2,0,0\n2.5,0.25,-1\n' > points.csv
soms closest knot.ply --points points.csv
soms closest knot.ply --points points.csv --json
soms closest knot.ply --points points.csv --nearest 3
soms closest knot.ply --points points.csv --radius 0.75 --csv near.csv
soms closest knot.ply --points points.csv --at-most 0.5
printf 'x,y,z\n0.9,0,0\n2,0,0\n' | soms closest knot.ply --points - --signed
printf 'x,y,z\n9,0,0\n' | soms closest knot.ply --points - --pose "8 0 0"
