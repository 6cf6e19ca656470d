# Names that no page of the earlier release shows.
printf 'o a\nv 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 4\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\no b\nv 1 1 1\nv 5 1 1\nv 1 5 1\nv 1 1 5\nf 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n' > two.obj
soms clash two.obj --ignore touching --ignore=crossing --json
cat > arm.urdf <<'END'
<robot name="arm">
  <link name="base"><collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <link name="fore"><collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <joint name="turn" type="revolute">
    <parent link="base"/><child link="fore"/><origin xyz="0.5 0 0"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
END
printf 'turn\n0\n0.5\n' > states.csv
soms robot arm.urdf --states states.csv
soms robot arm.urdf --states states.csv --ignore base,fore
soms generate knot --triangles 60 -o knot.ply
soms bench knot.ply knot.ply --random 2 --rounds 1 --out results
