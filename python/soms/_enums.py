"""Enumerations. Arrays of answers hold their integers, which compare equal to members; functions take
a member or its name. Written by tools/fields.py from the words that C++ has."""

import enum as _enum


class ClashKind(_enum.IntEnum):
    """What kind of clash a pair of parts is; undecided where a part is open."""

    crossing = 0
    inside = 1
    same = 2
    touching = 3
    near = 4
    undecided = 5


class CommonCorners(_enum.IntEnum):
    """Which corners two triangles have in common: those of one vertex, or those in one
    place."""

    index = 0
    position = 1


class ContactChange(_enum.IntEnum):
    """What became of a contact of two bodies since the step before."""

    begin = 0
    stay = 1
    end = 2


class ContactVerdict(_enum.IntEnum):
    """What is proved of a motion: no contact at all, a contact on the way, neither of the two,
    or a contact at the start."""

    free = 0
    contact = 1
    grazing = 2
    started = 3


class Coverage(_enum.IntEnum):
    """How much of the question an answer covers: everything, up to the first hit as requested,
    or what a limit or a deadline left."""

    complete = 0
    first = 1
    cut = 2


class CrossingKind(_enum.IntEnum):
    """How a ray passes a place of the surface."""

    enter = 0
    leave = 1
    graze = 2


class JointType(_enum.IntEnum):
    """How a joint moves its link: not at all, by an angle within limits or without, by a
    length."""

    fixed = 0
    revolute = 1
    continuous = 2
    prismatic = 3


class Layout(_enum.IntEnum):
    """How a tree is kept: for speed, or for memory."""

    wide = 0
    compact = 1


class MeshFormat(_enum.IntEnum):
    """Formats that models are written in."""

    ply = 0
    ply_ascii = 1
    obj = 2
    stl = 3
    stl_ascii = 4
    off = 5
    three_ds = 6
    glb = 7


class OverlapMode(_enum.IntEnum):
    """Which pairs an overlap lists: all, some one, or the least."""

    all = 0
    any = 1
    first = 2


class Partition(_enum.IntEnum):
    """How triangles are divided: by the parts of the file, or by vertices in one place."""

    named = 0
    connected = 1


class RecordedOrigin(_enum.IntEnum):
    """What a recorded mesh is from: a file, or generate("city"), or generate of a mover."""

    file = 0
    city = 1
    mover = 2


class RecordingEnding(_enum.IntEnum):
    """How a recording came to its end."""

    complete = 0
    timed_out = 1
    interrupted = 2


class Relation(_enum.IntEnum):
    """How two closed bodies stand to each other."""

    clear = 0
    touching = 1
    crossing = 2
    a_in_b = 3
    b_in_a = 4
    same = 5
    undecided = 6


class RobotVerdict(_enum.IntEnum):
    """What a state of a robot is: free, with contact, or not decided."""

    free = 0
    contact = 1
    undecided = 2


class Rotation(_enum.IntEnum):
    """What a matrix is taken as: its entries as they are, or the nearest rotation."""

    as_given = 0
    nearest = 1


class Rule(_enum.IntEnum):
    """How nodes of a tree are divided."""

    object_median = 0
    object_mean = 1
    spatial_median = 2
    soms = 3
    sah = 4
    soms_sah = 5
    fast = 6
    quality = 7
    quick = 8


class SceneBodyKind(_enum.IntEnum):
    """Of which list of a scene a body is."""

    environment = 0
    mover = 1


class Side(_enum.IntEnum):
    """Where a point lies."""

    outside = 0
    inside = 1
    on = 2
    undecided = 3


class StepScope(_enum.IntEnum):
    """Which pairs of bodies a step compares: all, or those of a mover up to its first
    contact."""

    every_pair = 0
    first_contact = 1


class TreeCheck(_enum.IntEnum):
    """How closely a tree file is looked at before it is used."""

    trusted = 0
    safe = 1
    sound = 2
    full = 3


class TriangleFeature(_enum.IntEnum):
    """Where on a triangle a point lies."""

    vertex = 0
    edge = 1
    face = 2


class Undecided(_enum.IntEnum):
    """Why a relation is undecided."""

    none = 0
    deadline = 1
    open = 2


class UpAxis(_enum.IntEnum):
    """The up axis that a file states."""

    unknown = 0
    x = 1
    y = 2
    z = 3
