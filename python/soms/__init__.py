"""Exact collision queries on triangle meshes.

    import soms

    city = soms.Body(soms.read_mesh("city.ply"))
    car = soms.Shape(soms.read_mesh("car.ply"))
    answer = soms.overlap(car, city, poses)          # poses: (n, 4, 4)
    print(answer.any, answer.of(0))                  # who touches, and with which triangles

Queries: overlap, distance, within, solid of two bodies; contains, closest, nearest_triangles,
near_triangles, winding of points; closest_hit, any_hit, all_hits, sees of rays; clash of the parts of
models; robot_contacts of states of a robot. Bodies are Body, Shape, Mesh, or any object with vertices
and faces. Scene is for many movers. One pose, point or ray
gives a single answer, rows of them a batch; both carry coverage and cost. All take threads, seconds
and progress, and end by Ctrl-C; the interpreter's lock is free meanwhile. Errors are soms.Error.
"""

from soms._enums import (
    ClashKind as ClashKind,
    ContactChange as ContactChange,
    Coverage as Coverage,
    CrossingKind as CrossingKind,
    JointType as JointType,
    Layout as Layout,
    MeshFormat as MeshFormat,
    OverlapMode as OverlapMode,
    Partition as Partition,
    RecordedOrigin as RecordedOrigin,
    RecordingEnding as RecordingEnding,
    Relation as Relation,
    RobotVerdict as RobotVerdict,
    Rotation as Rotation,
    Rule as Rule,
    SceneBodyKind as SceneBodyKind,
    Side as Side,
    StepScope as StepScope,
    TriangleFeature as TriangleFeature,
    Undecided as Undecided,
    UpAxis as UpAxis,
)
from soms._error import Error as Error
from soms._page import Page as Page
from soms._soms import (
    AllHits as AllHits,
    AnyHit as AnyHit,
    AnyHitBatch as AnyHitBatch,
    Body as Body,
    BodyAllHits as BodyAllHits,
    BodyClosest as BodyClosest,
    BodyClosestBatch as BodyClosestBatch,
    BodyHit as BodyHit,
    BodyHitBatch as BodyHitBatch,
    BodyIndex as BodyIndex,
    Clash as Clash,
    ClashList as ClashList,
    ClosedBody as ClosedBody,
    Closedness as Closedness,
    Closest as Closest,
    ClosestBatch as ClosestBatch,
    ClosestHit as ClosestHit,
    ClosestHitBatch as ClosestHitBatch,
    ContactEvents as ContactEvents,
    ContactSpan as ContactSpan,
    ContactSpans as ContactSpans,
    ContactTracker as ContactTracker,
    Contains as Contains,
    ContainsBatch as ContainsBatch,
    ContainsParts as ContainsParts,
    ContainsPartsBatch as ContainsPartsBatch,
    Cost as Cost,
    Defects as Defects,
    Distance as Distance,
    DistanceBatch as DistanceBatch,
    DividedBody as DividedBody,
    DividedPart as DividedPart,
    Georeference as Georeference,
    Joint as Joint,
    Link as Link,
    MapConversion as MapConversion,
    Mesh as Mesh,
    NamedState as NamedState,
    NearTriangles as NearTriangles,
    Overlap as Overlap,
    OverlapBatch as OverlapBatch,
    Part as Part,
    PartBodies as PartBodies,
    PartClosedness as PartClosedness,
    Penetration as Penetration,
    Pose as Pose,
    RecordedBody as RecordedBody,
    RecordedFrame as RecordedFrame,
    RecordedMesh as RecordedMesh,
    RecordingEnd as RecordingEnd,
    RecordingWriter as RecordingWriter,
    Replay as Replay,
    Robot as Robot,
    RobotAnswer as RobotAnswer,
    RobotAnswerBatch as RobotAnswerBatch,
    RobotGap as RobotGap,
    RobotModel as RobotModel,
    Scene as Scene,
    SceneAllHits as SceneAllHits,
    SceneClosest as SceneClosest,
    SceneClosestBatch as SceneClosestBatch,
    SceneHit as SceneHit,
    SceneHitBatch as SceneHitBatch,
    Shape as Shape,
    SignedClosest as SignedClosest,
    SignedClosestBatch as SignedClosestBatch,
    Solid as Solid,
    SolidBatch as SolidBatch,
    StepReport as StepReport,
    Winding as Winding,
    WindingBatch as WindingBatch,
    WindingIndex as WindingIndex,
    Within as Within,
    WithinBatch as WithinBatch,
    __version__ as __version__,
    all_hits as all_hits,
    any_hit as any_hit,
    clash as clash,
    closest as closest,
    closest_hit as closest_hit,
    contains as contains,
    distance as distance,
    generate as generate,
    near_triangles as near_triangles,
    nearest_triangles as nearest_triangles,
    overlap as overlap,
    penetration as penetration,
    read_mesh as read_mesh,
    read_poses as read_poses,
    read_robot as read_robot,
    robot_contacts as robot_contacts,
    sees as sees,
    signed_distance as signed_distance,
    solid as solid,
    winding as winding,
    within as within,
    write_mesh as write_mesh,
)

__all__ = sorted(name for name in dir() if not name.startswith("_"))

# Where users find them, and so pickles and help(soms) do.
for _name in __all__:
    globals()[_name].__module__ = "soms"
del _name
