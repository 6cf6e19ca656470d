soms generate city --triangles 5672 -o city.ply && soms generate car -o car.ply
soms overlap car.ply city.ply --pose "10 0 -3"
soms distance car.ply city.ply --pose "10 0 50"
soms clash walls.obj --against pipes.glb -o c.html -o c.bcfzip            # which parts clash: a list, a page, BCF
soms overlap walls.obj pipes.glb --up-b y --by part --report clash.html   # which of their triangles overlap
soms overlap tool.stl cell.ply --pose poses.csv --any --json              # touching or not, pose by pose
soms distance tool.stl cell.ply --pose poses.csv --csv gaps.csv           # how far apart, and where they are nearest
soms within walls.obj pipes.glb --up-b y --clearance 0.05                 # is a clearance kept?
soms info model.3ds                                                       # counts, defects, a tree by each rule
