soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms distance knot.ply ball.off --pose "2.2 0 0"
soms within knot.ply ball.off --pose "2.2 0 0" --clearance 0.5
printf 'x,y,z\n2,0,0\n2.2,0,0\n9,0,0\n' > poses.csv
soms distance knot.ply ball.off --pose poses.csv
soms distance knot.ply ball.off --pose poses.csv --json --at-most 1
soms distance knot.ply ball.off --pose poses.csv --report distance.html
soms within knot.ply ball.off --pose poses.csv --clearance 0.5 --report within.html
printf 'o shelf\nv 0 0 1\nv 4 0 1\nv 4 4 1\nv 0 4 1\nf 1 2 3 4\n' > rack.obj
printf 'o pipe\nv 1 1 1.25\nv 1 2 1.5\nv 1 1 3\nf 1 2 3\n' > services.obj
soms distance rack.obj services.obj
soms within rack.obj services.obj --clearance 0.25 --fail-if within || echo "too near: status $?"
soms overlap rack.obj services.obj --within 0.125 --fail-if within
