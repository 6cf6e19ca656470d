soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms overlap knot.ply ball.off --pose "0.5 0 0"
printf 'x,y,z\n0.5,0,0\n0,0.5,0\n9,0,0\n' > poses.csv
soms overlap knot.ply ball.off --pose poses.csv --json --no-pairs --verify
printf 'o shelf\nv 0 0 1\nv 4 0 1\nv 4 4 1\nv 0 4 1\nf 1 2 3 4\no post\nv 9 0 0\nv 9 1 0\nv 9 0 3\nf 5 6 7\n' > rack.obj
printf 'o pipe\nv 1 1 0\nv 1 2 0\nv 1 1 3\nf 1 2 3\no cable\nv 8 0 2\nv 12 0 2\nv 12 1 2\nf 4 5 6\n' > services.obj
soms overlap rack.obj services.obj --by part
soms overlap rack.obj services.obj --by part --csv clashes.csv --report clashes.html
coproc query {
  soms overlap knot.ply ball.off --pose - --json --any
}
echo 'x,y,z' >&"${query[1]}"
for x in 0.5 1 9; do
  echo "$x,0,0" >&"${query[1]}"
  read -r answer <&"${query[0]}"
  echo "$answer"
done
