"""A URDF robot against its cell: which of many states are free, and how near do they come?

    robot_states.py [STATES]

The robot is a crane whose column turns and whose boom goes up and down; the cell is a wall.
"""
import sys

import numpy as np

import soms

CRANE = b"""<robot name="crane">
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
</robot>"""
WALL = soms.Mesh([[0.8, -3, -3], [0.8, 3, -3], [0.8, 3, 3], [0.8, -3, 3]], [[0, 1, 2], [0, 2, 3]])


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    robot = soms.read_robot(CRANE, name="crane.urdf")
    model = soms.RobotModel(robot, soms.Body(WALL, name="wall"))
    answer = soms.robot_contacts(model, robot.random_states(count), distance=True, threads=0)
    print(f"{np.count_nonzero(answer.free)} of {count} states are free")
    print(f"{np.count_nonzero(answer.gap[:, 0] > 0.02)} keep 0.02 m from everything")

    turn = np.linspace(np.pi, 0, 181)
    path = np.column_stack([turn, np.full_like(turn, 0.5)])
    last = soms.robot_contacts(model, path, first_contact=True).first_blocked
    print(f"the path is blocked at {np.degrees(turn[last]):.0f} degrees")


if __name__ == "__main__":
    main()
