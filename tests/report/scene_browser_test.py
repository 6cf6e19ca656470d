"""What the picture of a page shows at one look: all of the scene, two bodies apart, what walls hide, shadows, and the next event."""
import pathlib
import subprocess
import sys

from look import DESK, PHONE, Look, in_sight, lines, run_looks, town
from browser import console_faults

CLASH = pathlib.Path(__file__).resolve().parents[1] / "data/clash"
SEE = "document.getElementById('stage').scrollIntoView({block: 'center'});"
# Where the corners of the whole scene are in the picture, as shares of its sides.
CORNERS = """const {view} = soms, {clientWidth, clientHeight} = view.canvas;
  return view.corners().map((at) => view.onCanvas(at)).map(([x, y, depth]) => [x / clientWidth, y / clientHeight, depth]);"""


def made(soms, folder, *words):
    """The page that a command writes."""
    file = folder / f"{words[0]}.html"
    subprocess.run([soms, *words, "-o", file], check=True, capture_output=True)
    return file


def models(soms, folder):
    """A knot that a ball holds in part."""
    for name, shape, triangles in (("knot.ply", "knot", "2000"), ("ball.ply", "sphere", "800")):
        subprocess.run([soms, "generate", shape, "--triangles", triangles, "-o", folder / name], check=True, capture_output=True)
    return folder / "knot.ply", folder / "ball.ply"


def whole_faults(browser, soms, folder):
    """The button for the whole scene cuts nothing off, on any kind of page and on a phone."""
    pair = models(soms, folder)
    pages = [made(soms, folder, "simulate", town(folder), "--count", "20", "--frames", "30"),
             made(soms, folder, "overlap", *pair, "--pose", "0.5 0 0", "--no-pairs"),
             made(soms, folder, "distance", *pair, "--pose", "4 0 0"),
             made(soms, folder, "motion", *pair, "--from", "5 0.5 0", "--to", "-4 0 0"),
             made(soms, folder, "clash", CLASH / "structure.obj", "--against", CLASH / "services.gltf")]
    for file in pages:
        for size in (DESK, PHONE):
            page = Look(browser, file, size)
            page.run("document.getElementById('whole').click()")
            page.canvas()
            places = page.run(CORNERS)
            if not all(0 < x < 1 and 0 < y < 1 and abs(depth) <= 1 for x, y, depth in places):
                yield f"{file.name} at {size}: corners of the whole scene are at {places}"
            if max(max(x for x, _, _ in places) - min(x for x, _, _ in places),
                   max(y for _, y, _ in places) - min(y for _, y, _ in places)) < 0.6:
                yield f"{file.name} at {size}: the whole scene is small: {places}"
    yield from console_faults(browser)


def pair_faults(browser, soms, folder):
    """Two bodies, the ground and its shadow differ; what the ball hides of the curve is pale."""
    page = Look(browser, made(soms, folder, "overlap", *models(soms, folder), "--pose", "0.5 0 0", "--no-pairs"), DESK)
    page.run("soms.view.seeThrough(-1); soms.view.draw()")  # inside_faults looks at glass
    found = page.colors()
    for name, least in (("blue", 2000), ("sand", 5000), ("contact", 200), ("shadow", 2000), ("light", 100000)):
        if found[name] < least:
            yield f"of {name} there are {found[name]} pixels: {found}"
    if page.soms("chosenRow()") != 0:
        yield "the page does not open on its row"
    page.run("soms.view.curves.forEach(({curve: {parts}}) => { parts[0].material.visible = parts[1].material.visible = false; });"
             "soms.view.draw()")
    hidden = page.colors()
    page.run("soms.view.curves.forEach(({curve: {parts}}) => parts.forEach(({material}) => { material.visible = false; })); soms.view.draw()")
    none = page.colors()
    if hidden["contact"] > 20 or hidden["hidden"] < 20 + none["hidden"]:
        yield f"of what bodies hide of the curve there is {hidden}, without it {none}"
    yield from console_faults(browser)


def inside_faults(browser, soms, folder):
    """One sees through a ball that hides a knot, and all of where they cross; and what is seen is not so without that."""
    page = Look(browser, made(soms, folder, "overlap", *models(soms, folder)), DESK)
    found = page.colors()
    page.run("soms.view.seeThrough(-1); soms.view.draw()")
    opaque = page.colors()
    for name, least in (("blue", 2000), ("contact", opaque["contact"] + 20)):
        if found[name] < least:
            yield f"of {name} there are {found[name]} pixels where the knot is inside: {found}"
    if opaque["blue"] > found["blue"] / 4:
        yield f"the ball does not hide the knot, so that this test says nothing: {opaque}"
    yield from console_faults(browser)


def event_faults(browser, soms, folder):
    """A house that is touched is sand, all others are not; Next leads to the next event, points to contacts of one."""
    page = Look(browser, made(soms, folder, "simulate", town(folder), "--count", "60", "--frames", "60"), DESK)
    opened = page.soms("chosenRow()")
    if opened < 0 or page.soms(f"most({opened})") != page.run("return Math.max(...[...Array(soms.rows).keys()].map((r) => soms.most(r)))"):
        yield f"the page opens on row {opened}, which is not the richest"
    if page.run("return location.hash") != "":
        yield "opening a page names a row in its address"
    page.wait("return soms.isWhole")
    house = next(line for line in lines(page, "pair") if "house" in line.text)
    in_sight(page, house).click()
    chosen = page.colors()
    page.run("soms.view.clearChosen(); soms.view.setStep(soms.view.step)")
    none = page.colors()
    if not chosen["sand"] > 1000 + 3 * none["sand"]:
        yield f"the touched house looks as the ground and the others: {chosen}, {none}"
    many = page.run("return [...Array(soms.rows).keys()].find((r) => soms.held(r) > 1 && r + 1 < soms.rows)")
    order = page.element("order")
    order.send_keys("by begin")
    page.run(f"location.hash = ''; const list = soms; for (let r = 0; r <= {many}; ++r) {{ document.getElementById('next').click(); }}")
    first = page.soms("chosenRow()")
    held = page.soms(f"held({first})")
    canvas = page.element("canvas")
    canvas.send_keys(".")
    if page.soms("chosen()") < 0 or page.soms("chosenRow()") != first or (held > 1 and f"1 of {held}" not in page.element("which").text):
        yield f"a point does not lead to a contact of event {first}: '{page.element('which').text}'"
    page.element("next").click()
    if page.soms("chosen()") != -1 or page.soms("chosenRow()") == first:
        yield "Next goes into the contacts of an event"
    yield from console_faults(browser)


def building_faults(browser, soms, folder):
    """All parts: each set in its color, and a mark for each clash, in light and dark."""
    file = made(soms, folder, "clash", CLASH / "structure.obj", "--against", CLASH / "services.gltf", "--clearance", "0.05")
    page = Look(browser, file, DESK)
    if page.soms("chosenRow()") < 0:
        yield "the page of clashes opens on none"
    page.run(SEE + "document.getElementById('whole').click()")
    found = page.colors()
    if found["sand"] < 150 or found["contact"] < 2000:  # thin services in a scene beside the table
        yield f"of sets and marks there is {found}"
    marked, placed = (page.run(f"return {what}") for what in (
        "soms.spots().reduce((sum, {all}) => sum + all, 0)", "[...Array(soms.rows).keys()].filter((r) => soms.reach(r) > 0).length"))
    if not 0 < marked == placed:
        yield f"{marked} clashes are marked of {placed}"
    page = Look(browser, file, DESK, "dark")
    page.run(SEE + "document.getElementById('whole').click()")
    dark = page.picture()
    if dark["contact"] < 2000 or dark["colors"] < 500:
        yield f"in the dark there is {dark}"
    yield from console_faults(browser)


def near_faults(browser, soms, folder):
    """The page of the embedded city, too large to be taken along whole, answers near its events."""
    page = Look(browser, made(soms, folder, "simulate"), DESK)
    page.wait("return soms.isWhole")
    if page.run("return soms.view.all.scene.live.near.length") == 0:
        yield "the page of the embedded city has all of its exact triangles, or none"
    page.element("find").send_keys("parked van")
    in_sight(page, lines(page, "pair")[0]).click()
    page.element("move").click()
    page.wait("return Boolean(soms.live().answer)")
    r, answer = page.soms("chosenRow()"), page.soms("live().answer")
    pairs = sum(other["pairs"] for other in answer["touched"])
    if not 0 < answer["known"] or pairs < page.soms(f"most({r})"):
        yield f"where the report has it, {pairs} pairs touch of the {page.soms(f'most({r})')} of its event: {answer['known']}"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(whole_faults, pair_faults, inside_faults, event_faults, building_faults, near_faults))
