"""What a type checker must accept of soms: checked by stubs_test.py, and run by it."""
import numpy as np
from numpy.typing import NDArray

import soms


def touching(mover: soms.Shape, fixed: soms.Body, poses: NDArray[np.float64]) -> int:
    batch = soms.overlap(mover, fixed, poses, mode="any", threads=0)
    flags: NDArray[np.bool_] = batch.any
    row: NDArray[np.uint32] = batch.of(0)
    return int(np.count_nonzero(flags)) + len(row)


def main() -> None:
    car = soms.Shape(soms.generate("car"), rule=soms.Rule.quality)
    city = soms.Body(soms.generate("city", 3000), soms.Pose.translation(0, 0, 1), "city")
    print(touching(car, city, np.zeros((2, 4, 4)) + np.eye(4)))
    single: soms.Overlap = soms.overlap(soms.Body(car), city)
    gap: float = soms.distance(soms.Body(car), city, at_most=10).lower
    side: soms.Side = soms.contains(soms.Body(car), (0.0, 0.0, 0.5)).side
    sides: NDArray[np.uint8] = soms.contains(soms.ClosedBody(car), np.zeros((2, 3))).side
    hit: int | None = soms.closest_hit(city, [0.0, 0.0, 99.0], [0.0, 0.0, -1.0]).triangle
    scene = soms.Scene()
    number: int = scene.add_mover(car)
    scene.set_pose(number, [1.0, 2.0, 3.0])
    clashes: soms.ClashList = soms.clash([city, soms.Body(car)], within=0.5)
    depths: NDArray[np.float64] = clashes.depth[clashes.kind == soms.ClashKind.crossing]
    robot = soms.read_robot(b"<robot name='r'><link name='a'/></robot>", name="r.urdf")
    names: list[str] = soms.RobotModel(robot, city).link_names
    start = soms.Pose.translation(0, 0, 9)
    met: soms.FirstContact = soms.first_contact(car, start, None, city, by=[0.0, 0.0, -9.0], within=0.1)
    edges: NDArray[np.bool_] = soms.free(car, [start, start], soms.Pose(), city, threads=2)
    verdicts: NDArray[np.uint8] = soms.first_contact(car, start, [start, soms.Pose()], city).verdict
    way = soms.RigidMotion.along(start, [0.0, 0.0, -9.0])
    half: soms.Pose = way.pose_at(0.5)
    poses: NDArray[np.float64] = way.pose_at([0.0, 1.0])
    blocked: int | None = soms.first_contact(car, [way, way], city).first_blocked
    print(half, poses.shape, blocked, soms.free(car, way, city))
    print(met.verdict is soms.ContactVerdict.contact, met.normal, edges, verdicts)
    print(len(depths), [clash.gap for clash in clashes], names)
    print(single.any, gap, side, sides, hit, scene.step(clearance=1.0).queries)
    try:
        soms.read_mesh("nowhere.ply")
    except soms.Error as error:
        print(error.kind, error.place, error.remedy)


if __name__ == "__main__":
    main()
