"""Pages of two models, of gaps and of many rows, opened in Chromium from a file."""
import csv
import json
import subprocess
import sys

from look import DESK, PHONE, Look, away, in_sight, lines, town, run_looks
from browser import console_faults


def gap_faults(browser, soms, folder):
    """A link of the table shows its gap: a line between the two, with its length."""
    file = folder / "near.html"
    subprocess.run([soms, "simulate", town(folder), "--count", "60", "--frames", "60",
                    "--clearance", "2", "-o", file, "--quiet"], check=True,
                   capture_output=True)
    page = Look(browser, file, DESK)
    links = page.browser.find_elements("css selector", 'a[href^="#gap="]')
    if not 2 < len(links) == page.soms("gaps"):
        yield f"{len(links)} links to {page.soms('gaps')} gaps"
    if not page.run("return document.getElementById('near').offsetWidth"):
        yield "nothing says what the lines of gaps are"
    row = page.run("return [...arguments[0].closest('tr').children].map(e => e.textContent)", links[1])
    page.run("arguments[0].click()", links[1])
    page.canvas()
    if page.soms("chosenGap()") != 1 or page.run("return location.hash") != "#gap=1":
        yield "a link does not choose its gap"
    if not away(page.soms("target()"), page.soms("middle(1)")) <= 1e-3:
        yield "the camera does not look at the gap"
    if str(page.soms("step()")) != row[3] or row[2] not in page.element("picked").text:
        yield f"the gap of {row} is reported as '{page.element('picked').text}'"
    shown = page.run("""const g = document.querySelector('#gaps .chosen');
        const line = g.querySelector('.ink'), box = document.getElementById('gaps').getBoundingClientRect();
        const at = (name) => Number(line.getAttribute(name));
        return [g.textContent, Math.hypot(at('x2') - at('x1'), at('y2') - at('y1')),
                (at('x1') + at('x2')) / 2 / box.width, (at('y1') + at('y2')) / 2 / box.height,
                g.querySelector('text').style.display, g.classList.contains('is')];""")
    if shown[0] != row[2] or shown[4] == "none" or not shown[5]:
        yield f"the length {row[2]} is drawn as {shown}"
    if shown[1] < 5 or not abs(shown[2] - 0.5) <= 0.05 or not abs(shown[3] - 0.5) <= 0.05:
        yield f"the line of the gap is not in the middle: {shown}"
    page.print_one()
    if page.soms("chosenGap()") != 1:
        yield "after printing no gap is chosen"
    linked = Look(browser, file, DESK, mark="#gap=2")
    if not linked.wait("return soms.chosenGap() === 2"):
        yield "an address that names a gap does not show it"
    in_sight(linked, lines(linked, "pair")[0]).click()
    linked.landed()
    if linked.soms("chosenGap()") != -1:
        yield "a gap stays chosen beside a contact"
    for name, shape in (("a.ply", "sphere"), ("b.ply", "knot")):
        subprocess.run([soms, "generate", shape, "--triangles", "800", "-o", folder / name],
                       check=True, capture_output=True)
    subprocess.run([soms, "distance", folder / "a.ply", folder / "b.ply", "--pose", "4 0 0",
                    "-o", file], check=True, capture_output=True)
    page = Look(browser, file, DESK, "dark")
    page.canvas()
    shown = page.run("""return [...document.querySelectorAll('#gaps g')].map(g => [g.style.display,
        g.textContent, getComputedStyle(g.querySelector('.ink')).stroke])""")
    if len(shown) != 1 or shown[0][0] == "none" or not 0 < float(shown[0][1]) < 4:
        yield f"the distance of a single pose is drawn as {shown}"
    elif shown[0][2] != page.run("return getComputedStyle(document.body).color"):
        yield f"in the dark the line is {shown[0][2]}"
    yield from console_faults(browser)


def overlap_faults(browser, soms, folder):
    """Two knots, at one pose and at a row of poses."""
    for name, triangles in (("knot", 2000), ("ball", 800)):
        subprocess.run([soms, "generate", "knot" if name == "knot" else "sphere", "--triangles",
                        str(triangles), "-o", folder / f"{name}.ply", "--quiet"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    poses = folder / "poses.csv"
    poses.write_text("x,y,z\n" + "".join(f"{k / 20},0,0\n" for k in range(60)), encoding="ascii")
    for pose in ("0.5 0 0", str(poses)):
        file = folder / "overlap.html"
        run = subprocess.run([soms, "overlap", folder / "knot.ply", folder / "ball.ply", "--pose",
                              pose, "-o", file, "--json", "--no-pairs"], check=True,
                             capture_output=True, text=True)
        pairs = sum(json.loads(line)["count"] for line in run.stdout.splitlines())
        page = Look(browser, file, DESK)
        held = page.soms("contacts")
        if not (held == pairs if pairs <= 10000 else 5000 <= held <= 10000) or pairs == 0:
            yield f"overlap: {held} contacts of {pairs}"
        if page.soms("rows") != 1 or page.soms("total(0)") != pairs:
            yield f"overlap: {page.soms('rows')} rows, the first of {page.soms('total(0)')}"
        if page.picture()["colors"] < 20:
            yield "overlap: the canvas is blank"
        before = page.soms("camera()")
        in_sight(page, lines(page, "contact")[0]).click()
        page.landed()
        if away(before, page.soms("camera()")) < 0.1:
            yield "overlap: the camera stayed where it was"
        if page.picture()["contact"] < 30:
            yield "overlap: no triangle of the contact is seen"
    yield from console_faults(browser)


def fins(path, name, parts, along_x):
    """One upright triangle a part; those along x cross all along y."""
    text = []
    for k in range(parts):
        text.append(f"o {name} {k}")
        for along, height in ((-1000, 0), (2000, 0), (500, 9000)):
            text.append(f"v {along} {k} {height}" if along_x else f"v {k} {along} {height}")
        text.append("f -3 -2 -1")
    path.write_text("\n".join(text) + "\n", encoding="ascii")
    return path


def many_rows_faults(browser, soms, folder):
    """R116: 100,489 rows, more than triangles find room for: all are there, few are drawn at a time."""
    parts, file = 317, folder / "many_rows.html"
    subprocess.run([soms, "overlap", fins(folder / "beams.obj", "beam", parts, True),
                    fins(folder / "ducts.obj", "duct", parts, False), "-o", file, "--quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    page = Look(browser, file, DESK)
    if page.soms("rows") != parts ** 2:
        yield f"many rows: {page.soms('rows')} rows of {parts ** 2}"
    if "100,489 pairs of parts" not in page.element("count").text:
        yield f"many rows: the list says '{page.element('count').text}'"
    if "10,000 of 100,489 pairs of triangles" not in page.element("missing").text:
        yield f"many rows: the picture says '{page.element('missing').text}'"
    page.run("const order = document.getElementById('order');"
             "order.value = 'begin'; order.dispatchEvent(new Event('change'))")
    page.run("const list = document.getElementById('list'); list.scrollTop = list.scrollHeight")
    if not page.wait("return [...document.querySelectorAll('.line.pair b')]"
                     ".some(e => e.textContent === 'beam 316 touches duct 316')"):
        yield "many rows: the last row is out of reach"
    if page.run("return document.querySelectorAll('.line').length") > 60:
        yield "many rows: rows are drawn that nobody sees"
    page.run("document.getElementById('find').value = 'beam 316 duct 31'")
    page.element("find").send_keys("5")  # each key is a search of all rows
    page.settle()  # the list is short now, and scrolls
    found = page.run("return [...document.querySelectorAll('.line.pair b')].map(e => e.textContent)")
    if "beam 316 touches duct 315" not in found or page.soms("shown()") > 9:
        yield f"many rows: a search finds {page.soms('shown()')}: {found[:3]}"
    row = in_sight(page, lines(page, "pair")[0])
    r = int(row.get_attribute("data-row"))
    row.click()
    page.landed()
    if not away(page.soms("target()"), page.soms(f"center({r})")) <= 1e-3:
        yield "many rows: the camera does not go to a row without triangles"
    left = [line.text for line in lines(page, "left")]
    if page.soms(f"held({r})") == 0 and not any("not on this page" in text for text in left):
        yield f"many rows: a row without triangles does not say so: {left}"
    yield from console_faults(browser)


# Of the matrix that is shown: where it is, its cells, and words that lie upon other words or cells, or stick out.
MATRIX = """
  const shown = [...document.querySelectorAll('svg.matrix')].filter((svg) => svg.getBoundingClientRect().width > 0);
  const page = shown[0].getBoundingClientRect();
  const parts = [...shown[0].querySelectorAll('text, rect')].filter((part) => part.tagName === 'rect' || !part.closest('.cell'));
  const boxes = parts.map((part) => part.getBoundingClientRect());
  const meet = (a, b) => Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 && Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3;
  const faults = parts.filter((part, k) => part.tagName === 'text'
    && (boxes[k].right > page.right + 1 || boxes.some((box, n) => n !== k && meet(boxes[k], box))));
  return {count: shown.length, bottom: page.bottom + scrollY, cells: parts.filter(({tagName}) => tagName === 'rect').length,
    faults: faults.map(({textContent}) => textContent)};"""


def matrix_faults(browser, folder):
    """The page begins with one picture of all claims, a cell for each line of a matrix, on any screen."""
    with open(folder / "out/tables/claim_more_single_leaves.csv", encoding="utf-8", newline="") as table:
        lines_of_matrix = {(row["metric"], row["reading"], row["above"], row["below"]) for row in csv.DictReader(table)}
    for width, height in ((1440, 900), PHONE):
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width == PHONE[0]})
        found = browser.execute_script(MATRIX)
        if found["count"] != 1 or found["bottom"] > 900 or found["cells"] != len(lines_of_matrix):
            yield f"reproduce, {width} pixels: of {len(lines_of_matrix)} lines the page shows {found}"
        if found["faults"]:
            yield f"reproduce, {width} pixels: the matrix has no room for {found['faults']}"
        if browser.execute_script("return document.documentElement.scrollWidth > document.documentElement.clientWidth"):
            yield f"reproduce, {width} pixels: the page scrolls sideways"


def reproduce_faults(browser, soms, folder):
    file = folder / "thesis.html"
    subprocess.run([soms, "reproduce", "--quick", "--quiet", "--item", "5.3,claim-single-leaves", "-o", folder / "out",
                    "--report", file], check=True, stdout=subprocess.DEVNULL)
    browser.get(file.as_uri())
    yield from matrix_faults(browser, folder)
    browser.execute_script("location.hash = '#claim-more_single_leaves'")
    if not browser.execute_script("return document.querySelector('#claim-more_single_leaves').closest('details').open"):
        yield "reproduce: a claim of the matrix does not unfold its words"
    links = browser.execute_script(
        "return [...document.querySelectorAll('a')].map(a => a.getAttribute('href'))")
    for link in links:
        if not link.startswith(("#", "data:")):
            yield f"reproduce: a link leads to {link}"
    if not any(link.startswith("data:text/csv") for link in links):
        yield "reproduce: no table can be taken along"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(gap_faults, overlap_faults, many_rows_faults, reproduce_faults))
