"""Pages of motions, opened in Chromium from a file."""
import math
import subprocess
import sys

from look import DESK, PHONE, Look, away, lines, run_looks, town
from browser import console_faults

SLIDE = "const part = document.getElementById('part'); part.value = arguments[0]; part.dispatchEvent(new Event('input'));"


def rotated(turn, v):
    """A vector turned by a quaternion x, y, z, w of any length."""
    x, y, z, w = (part / math.hypot(*turn) for part in turn)
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2],
            v[2] + w * t[2] + x * t[1] - y * t[0]]


def middle_at(motion, t):
    """Where the law has the middle of the body."""
    turn, way = ([a + t * (b - a) for a, b in zip(*motion[key])] for key in ("turns", "way"))
    return [a + b for a, b in zip(way, rotated(turn, motion["arm"]))]


def made(soms, folder):
    """A knot and a ball."""
    for name, shape, triangles in (("knot.ply", "knot", "2000"), ("ball.ply", "sphere", "800")):
        subprocess.run([soms, "generate", shape, "--triangles", triangles, "-o", folder / name, "--quiet"],
                       check=True, capture_output=True)
    return [soms, "motion", folder / "knot.ply", folder / "ball.ply"]


def slide_faults(browser, soms, folder):
    """The slider moves the body by the law of the motion, and the button shows the contact."""
    file = folder / "turn.html"
    subprocess.run([*made(soms, folder), "--from", "5 0.5 0", "--to", "-4 0 0 0 0 0.6 0.8", "--pivot", "0,0,1", "-o", file],
                   check=True, capture_output=True)
    page = Look(browser, file, DESK)
    motion = page.soms("motion(0)")
    size = math.dist(*motion["way"])
    moment = motion["moment"]
    if page.soms("part()") != moment or not 0 < moment < 1:
        yield f"the page opens at {page.soms('part()')}, not at the contact"
    if page.picture()["contact"] < 30:
        yield "no contact is seen"
    for t in (0, 0.1, 0.25, 0.5, 0.9, 1):
        page.run(SLIDE, t)
        found = page.soms("place()")
        if not away(found, middle_at(motion, t)) < 1e-6 * size:
            yield f"at t = {t} the body is at {found}, not at {middle_at(motion, t)}"
        if not abs(page.soms("partDrawn()") - t) < 1e-12:
            yield f"at t = {t} the picture has t = {page.soms('partDrawn()')}"
        state = "no contact" if t < moment else "after the first contact"
        if page.element("moment").text != f"t = {t}: {state}":
            yield f"at t = {t} the page says '{page.element('moment').text}'"
    page.run(SLIDE, round(moment, 3))
    if page.soms("part()") != moment or "the first contact" not in page.element("moment").text:
        yield "the slider does not stop at the contact"
    before, after = (page.run(f"return document.getElementById('{name}').offsetWidth") for name in ("before", "after"))
    if not abs(before / (before + after) - moment) < 0.01:
        yield f"the track has {before} pixels before and {after} after the contact at {moment}"
    page.run(SLIDE, 0)
    camera = page.soms("camera()")
    page.element("contact").click()
    page.canvas()
    if page.soms("part()") != moment or not away(page.soms("target()"), motion["place"]) < 1e-2 * size:
        yield "the button does not lead to the contact"
    if not away(camera, page.soms("camera()")) > 1e-3 * size:
        yield "the camera stays where it was"
    page.run("for (const moment of ['beforeprint', 'afterprint']) { window.dispatchEvent(new Event(moment)); }")
    if page.soms("part()") != page.soms("partDrawn()") or page.soms("partDrawn()") != moment:
        yield "printing moves the body"
    page.run("document.getElementById('play').click()")
    if not page.wait(f"return soms.part() > {moment}"):
        yield "playing does not go on"
    yield from console_faults(browser)


def list_faults(browser, soms, folder):
    """Motions of a path: the first that is not free is opened, and each can be chosen."""
    path, file = folder / "path.csv", folder / "path.html"
    path.write_text("x,y,z\n9,9,0\n9,0,0\n-9,0,0\n-9,9,0\n0,9,0\n0,0,0\n", encoding="ascii")
    subprocess.run([*made(soms, folder), "--path", path, "-o", file], check=True, capture_output=True)
    page = Look(browser, file, PHONE, "dark")
    if page.is_wide():
        yield "on a phone the page is too wide"
    page = Look(browser, file, DESK)
    order = [page.soms(f"motion({k})")["number"] for k in range(page.soms("motions"))]
    if order != [1, 4, 0, 2, 3] or page.soms("chosen()") != 0:
        yield f"motions come as {order}, and {page.soms('chosen()')} is open"
    if page.element("count").text != "5 motions, 2 of them not free":
        yield f"the list says '{page.element('count').text}'"
    lines(page, "motion")[2].click()
    if page.soms("chosen()") != 2 or not page.element("picked").text.startswith("Motion 0: free all the way"):
        yield f"a click on a line shows '{page.element('picked').text}'"
    if page.soms("part()") != 1 or page.run("return location.hash") != "#motion=0":
        yield "a free motion is not shown at its end"
    if page.element("contact").is_displayed():
        yield "a free motion has a contact to go to"
    page.element("blocked").click()
    if page.soms("shown()") != 2:
        yield f"the filter leaves {page.soms('shown()')} motions"
    linked = Look(browser, file, DESK, mark="#motion=4")
    if linked.soms("chosen()") != 1:
        yield "an address does not show its motion"
    linked.run("document.querySelector('a[href=\"#motion=1\"]').click()")
    if linked.soms("chosen()") != 0:
        yield "a link of the table does not show its motion"
    linked.element("next").click()
    if linked.soms("chosen()") != 1:
        yield "Next does not show the next motion"
    yield from console_faults(browser)


def house_faults(browser, soms, folder):
    """A car that hits a wall from inside a house is seen, and of the town only that house is sand."""
    file = folder / "house.html"
    subprocess.run([soms, "generate", "car", "-o", folder / "car.ply", "--quiet"], check=True, capture_output=True)
    subprocess.run([soms, "motion", folder / "car.ply", town(folder), "--from", "45 40 2", "--to", "75 40 2", "-o", file],
                   check=True, capture_output=True)
    page = Look(browser, file, DESK)
    page.wait("return soms.isWhole")
    found = page.colors()
    if found["blue"] < 300 or found["contact"] < 30 or not 1000 < found["sand"] < 0.8 * found["all"]:
        yield f"of a car in a house there is {found}"
    page.run("soms.view.seeThrough(-1); soms.view.draw()")
    opaque = page.colors()
    if opaque["blue"] > found["blue"] / 2:
        yield f"the house does not hide the car, so that this test says nothing: {opaque}"
    if page.run("return getComputedStyle(document.querySelector('#legend .rest')).display") == "none":
        yield "nothing says what is gray"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(slide_faults, list_faults, house_faults))
