soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms overlap knot.ply ball.off --pose "0.5 0 0"
printf 'x,y,z\n0.5,0,0\n0,0.5,0\n' > poses.csv
soms overlap knot.ply ball.off --pose poses.csv --json --no-pairs > answers.jsonl
soms generate knot --triangles 2000 -o knot.ply
printf 'x,y,z\n0,0,0\n2,0,0\n' > points.csv
soms closest knot.ply --points points.csv --binary near.npz
soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms distance knot.ply ball.off --pose "2.2 0 0"
soms distance knot.ply ball.off --pose "2.2 0 0" --json
soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms within knot.ply ball.off --clearance 0.5 --pose "2.2 0 0"
soms generate knot --triangles 2000 -o knot.ply
printf 'x,y,z\n0,0,0\n2,0,0\n' > points.csv
soms closest knot.ply --points points.csv
soms closest knot.ply --points points.csv --nearest 2 --json
soms closest knot.ply --points points.csv --signed
soms generate sphere --triangles 800 -o ball.off
printf 'x,y,z\n0,0,0\n2,0,0\n' > points.csv
soms contains ball.off --points points.csv
soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms solid knot.ply ball.off --pose "0.5 0 0"
printf 'o slab\nv 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' > slab.obj
printf 'o pipe\nv 1 1 0\nv 2 1 0\nv 1 2 0\nv 1 1 -3\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n' > pipe.obj
soms clash slab.obj --against pipe.obj -o clashes.csv
soms generate city --triangles 20000 -o town.ply
soms generate car -o car.ply
printf 'x,y,z\n-60,-2,0.5\n60,-2,0.5\n' > path.csv
soms clearance town.ply --profile car.ply --path path.csv --clearance 0.5
soms generate knot --triangles 2000 -o knot.ply
printf 'ox,oy,oz,dx,dy,dz\n-3,0,0,1,0,0\n3,0.25,0.125,-1,0,0\n' > rays.csv
soms ray knot.ply --rays rays.csv
soms ray knot.ply --rays rays.csv --all --json
soms generate knot --triangles 2000 -o knot.ply
soms info knot.ply
soms generate city --triangles 20000 --seed 7 -o city.ply
soms generate sphere --triangles 800 -o ball.ply
soms convert ball.ply ball.obj --scale 2
soms generate city --triangles 20000 -o town.ply
soms generate car -o car.ply
soms simulate town.ply --mover car.ply --count 50 --frames 60 --events events.csv
soms generate city --triangles 20000 -o town.ply
soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
mkdir -p ~/.local/share/bash-completion/completions ~/.config/fish/completions
soms completion bash > ~/.local/share/bash-completion/completions/soms
soms completion fish > ~/.config/fish/completions/soms.fish
soms completion zsh > ~/.soms.zsh    # and in ~/.zshrc, below compinit: source ~/.soms.zsh

soms version
