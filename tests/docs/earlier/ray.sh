soms generate knot --triangles 2000 -o knot.ply
printf 'ox,oy,oz,dx,dy,dz\n-3,0,0,1,0,0\n3,0.25,0.125,-1,0,0\n9,9,9,1,0,0\n' > rays.csv
soms ray knot.ply --rays rays.csv
soms ray knot.ply --rays rays.csv --json
soms ray knot.ply --rays rays.csv --all
soms ray knot.ply --rays rays.csv --csv hits.csv --verify
printf 'ox,oy,oz,dx,dy,dz,length\n-3,0,3,1,0,0,5\n' | soms ray knot.ply --rays - --pose "0 0 3"
soms generate city --triangles 3000 -o city.ply
printf 'x0,y0,z0,x1,y1,z1\n0,0,200,10,0,200\n0,0,200,10,0,-5\n' > sights.csv
soms ray city.ply --segments sights.csv --any
