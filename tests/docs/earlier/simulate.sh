
soms generate city --triangles 20000 -o town.ply
soms generate car -o car.ply
soms simulate town.ply --mover car.ply --count 50 --frames 60 --map town.svg --events events.csv
soms simulate town.ply --mover car.ply --count 5 --frames 60 --verify --json
soms simulate town.ply --mover car.ply --count 2 --frames 5 --clearance 0.5 --events near.csv --verify
soms simulate town.ply --mover car.ply --count 9 --frames 60 --clearance 0.5 --map near.svg --report near.html
