"""Draws how a blade first touches a post, and the chord that stands for its way: the drawing of docs/motion.md.

MOTION says what soms must answer: a test moves the same triangles.
"""
from drawing import arrow, dot, drawing, line, polygon, words

# From above. The rotation goes from (w, z) = (1, 0) to (0.6, 0.8), straight, made of length one.
BLADE = [(0.3, -0.12), (2.2, -0.12), (2.2, 0.12), (0.3, 0.12)]
POST = [(0.7, 1.5), (0.9, 1.5), (0.9, 1.7), (0.7, 1.7)]
END = (0.6, 0.8)
MOTION = {"end": "0 0 0 0.6 0 0 0.8", "t": 0.517, "digits": 0.0005}


def turned(p, t):
    w, z = 1 + t * (END[0] - 1), t * END[1]
    n = w * w + z * z
    c, s = (w * w - z * z) / n, 2 * w * z / n
    return (c * p[0] - s * p[1], s * p[0] + c * p[1])


def prism(outline, height):
    """Triangles of the walls over a convex outline."""
    made = []
    for k, p in enumerate(outline):
        q = outline[(k + 1) % len(outline)]
        a, b, c, d = (*p, -height), (*q, -height), (*q, height), (*p, height)
        made += [(a, b, c), (a, c, d)]
    return made


def scene():
    """Triangles of the blade and of the post."""
    return prism(BLADE, 0.1), prism(POST, 1.0)


def turn(place):
    """The blade at the start, at the contact and at the end."""
    made = [line([place(turned((2.2, 0.12), k / 40)) for k in range(41)], "dashed faint-line")]
    for t, kind in ((1, "a pale faint-line dashed"), (0, "a pale a-line"), (MOTION["t"], "a solid a-line")):
        made.append(polygon([place(turned(p, t)) for p in BLADE], kind))
    made.append(polygon([place(p) for p in POST], "b solid b-line"))
    ends = [place(turned((2.4, 0), t)) for t in (0, MOTION["t"], 1)]
    return [*made, dot(place(POST[1]), "both", 5), dot(place((0, 0)), "ink", 4), words(ends[0][0] + 6, ends[0][1] + 5, "t = 0", "a", "start"),
            words(ends[1][0] + 4, ends[1][1] - 2, f"t = {MOTION['t']:g}: contact", "both strong", "start"),
            words(ends[2][0] - 4, ends[2][1] + 2, "t = 1", "faint", "end"),
            words(place((1.06, 1.6))[0], place((1.06, 1.6))[1] + 18, "post", "b strong", "start")]


def chord(place):
    """A stretch of the way of one corner, and its chord."""
    way = [turned((2.2, 0), 0.1 + 0.8 * k / 40) for k in range(41)]
    begin, end = way[0], way[-1]
    middle = ((begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2)
    return [line([place(p) for p in way], "thick a-line"), line([place(begin), place(end)], "ink-line"),
            line([place(middle), place(way[20])], "dashed both-line"),
            *(dot(place(p), "ink", 4) for p in (begin, end)),
            arrow(place((0, 0)), place(turned((1.45, 0), 0.3)), "faint"), dot(place((0, 0)), "ink", 4),
            words(place((0.5, 0.16))[0], place((0.5, 0.16))[1] + 4, "r", "faint", "start"),
            words(place(begin)[0] + 10, place(begin)[1] + 4, "its begin", "ink", "start"),
            words(place(end)[0] - 4, place(end)[1] - 12, "its end", "ink"),
            words(place(middle)[0] - 12, place(middle)[1] + 16, "chord", "ink strong", "end"),
            words(place(way[14])[0] + 12, place(way[14])[1] - 6, "the way", "a strong", "start"),
            words(place(way[20])[0] + 10, place(way[20])[1] - 4, "bow", "both strong", "start")]


def motion():
    made = turn(lambda p: (110 + 74 * p[0], 232 - 74 * p[1]))
    made += chord(lambda p: (385 + 74 * p[0], 232 - 74 * p[1]))
    made += [words(130, 266, "the first contact on the way", "ink"),
             words(480, 266, "what proves a stretch free", "ink")]
    return drawing("Motion: a blade turns against a post; the way of a corner bows from its chord", 284, made)
