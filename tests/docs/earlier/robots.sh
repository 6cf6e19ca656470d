cat > crane.urdf <<'END'
<robot name="crane">
  <link name="base">
    <collision><origin xyz="0 0 -0.1"/><geometry><box size="1 1 0.2"/></geometry></collision>
  </link>
  <link name="column">
    <collision><origin xyz="0 0 0.5"/><geometry><cylinder radius="0.1" length="1"/></geometry></collision>
  </link>
  <link name="boom">
    <collision><origin xyz="0.6 0 0"/><geometry><box size="1.1 0.1 0.1"/></geometry></collision>
  </link>
  <joint name="turn" type="continuous">
    <parent link="base"/><child link="column"/><axis xyz="0 0 1"/>
  </joint>
  <joint name="lift" type="prismatic">
    <parent link="column"/><child link="boom"/><axis xyz="0 0 1"/>
    <limit lower="0.02" upper="0.9" effort="1" velocity="1"/>
  </joint>
</robot>
END
cat > wall.obj <<'END'
o wall
v 0.8 -3 -3
v 0.8 3 -3
v 0.8 3 3
v 0.8 -3 3
f 1 2 3
f 1 3 4
END
cat > q.csv <<'END'
turn,lift
3,0.5
2,0.5
1,0.5
0,0.5
3,0.03
3,0.95
END
soms robot crane.urdf --states q.csv --cell wall.obj --distance --verify
soms robot crane.urdf --random 1000 --path -o states.csv -o states.json
soms robot crane.urdf --states q.csv --cell wall.obj --fail-if contact || echo "status $?"
cat > arm.py <<'END'
import math

def row(angle, x, y):
    """A rotation about z, w first, and a shift in meters."""
    return f"{x!r},{y!r},0,{math.cos(angle / 2)!r},0,0,{math.sin(angle / 2)!r}\n"

with open("upper.csv", "w") as upper, open("fore.csv", "w") as fore:
    for file in (upper, fore):
        file.write("x,y,z,qw,qx,qy,qz\n")
    for degrees in range(90, 44, -1):
        angle = math.radians(degrees)
        upper.write(row(angle, 0, 0))
        fore.write(row(0, math.cos(angle), math.sin(angle)))
END
cat > beam.off <<'END'
OFF
8 6 0
-0.1 -0.1 -0.1
1.1 -0.1 -0.1
1.1 0.1 -0.1
-0.1 0.1 -0.1
-0.1 -0.1 0.1
1.1 -0.1 0.1
1.1 0.1 0.1
-0.1 0.1 0.1
4 0 3 2 1
4 4 5 6 7
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
END
cat > cell.obj <<'END'
o wall
v 1.7 -3 -3
v 1.7 3 -3
v 1.7 3 3
v 1.7 -3 3
f 1 2 3
f 1 3 4
END
cp beam.off upper.off
cp beam.off fore.off
soms simulate cell.obj --mover upper.off --route upper.csv --mover fore.off --route fore.csv --ignore upper,fore --verify --events events.csv
soms simulate cell.obj --mover upper.off --route upper.csv --mover fore.off --route fore.csv --ignore 0,1 --events events.csv
head -n 2 events.csv
soms simulate cell.obj --mover upper.off --route upper.csv --mover fore.off --route fore.csv --ignore 0,1 --clearance 0.05 --fail-if near || echo "status $?"
