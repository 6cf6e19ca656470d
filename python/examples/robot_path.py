"""A path of a robot of six links in a cell: what is between its states, and what that costs.

    robot_path.py [STATES [TRIANGLES [STEP]]]

The path goes from free state to free state; each joint by STEP radians or less. The last line is the
processor time of the path beside that of its states alone, in one run.
"""
import sys
import time

import numpy as np

import soms

LINK = """<link name="{k}"><collision><origin xyz="0 0 0.2"/>
<geometry><cylinder radius="0.05" length="0.34"/></geometry></collision></link>"""
JOINT = """<joint name="{k}" type="revolute"><parent link="{parent}"/><child link="{k}"/>
<origin xyz="0 0 {up}"/><axis xyz="0 {y} {z}"/><limit lower="-2.5" upper="2.5" effort="1" velocity="1"/></joint>"""
BODIES = 100


def six_links():
    text = '<robot name="six"><link name="base"/>'
    for k in range(6):
        text += LINK.format(k=k)
        text += JOINT.format(k=k, parent=k - 1 if k else "base", up=0.4 if k else 0, y=k % 2, z=1 - k % 2)
    return soms.read_robot((text + "</robot>").encode(), name="six.urdf")


def knots(triangles, rng):
    """Knots around the robot, most of them within its reach."""
    knot = soms.generate("knot", triangles // BODIES)
    vertices = np.asarray(knot.vertices) * 0.07
    places = rng.uniform(-2, 2, (10 * BODIES, 3))
    places = places[np.linalg.norm(places, axis=1) > 0.6][:BODIES]
    return [soms.Mesh(vertices + place, knot.triangles) for place in places]


def free_path(model, count, step, rng):
    """States that are free, by steps that go on in one direction as long as they can."""
    state, drift, states = np.full(6, 0.3), np.zeros(6), []
    while len(states) < count:
        ahead = state + drift * np.arange(1, 51)[:, None]
        answer = soms.robot_contacts(model, ahead)
        good = answer.free & answer.within_limits
        run = ahead[:len(good) if good.all() else np.argmin(good)]
        states.extend(run)
        state = run[-1] if len(run) else state
        drift = rng.uniform(-step, step, 6)
    return np.array(states[:count])


def seconds(function):
    times = []
    for _ in range(7):
        begin = time.process_time()
        function()
        times.append(time.process_time() - begin)
    return sorted(times)[len(times) // 2]


def main():
    given = sys.argv[1:] + [None] * 3
    count, triangles, step = int(given[0] or 1000), int(given[1] or 300_000), float(given[2] or 0.02)
    rng = np.random.default_rng(1)
    model = soms.RobotModel(six_links(), knots(triangles, rng))
    states = free_path(model, count, step, rng)
    path = soms.robot_path(model, states)
    print(f"{np.count_nonzero(path.free)} of {len(path)} segments are free; all {count} states are")
    if path.blocked is not None:
        hit = path.at(path.blocked)
        print(f"segment {path.blocked} is blocked at {hit.upper:.3f} of its way")
    alone = seconds(lambda: soms.robot_contacts(model, states))
    print(f"{seconds(lambda: soms.robot_path(model, states)) / alone:.1f} times the states alone")


if __name__ == "__main__":
    main()
