"""Layout of each kind of page, by the rectangles of its elements: the first screen of a desk and of a phone, and paper."""
import base64
import json
import pathlib
import re
import subprocess
import sys
import zlib

from look import DESK, PHONE, Look, run_looks, town
from browser import console_faults

MODELS = pathlib.Path(__file__).resolve().parents[1] / "data/clash"
SCREEN = (1440, 900)
PAPER = (688, 1017)  # A4 less 14 mm on each side, at 96 dots an inch

# Where elements are on the page, from its upper left corner; null for what is not shown.
PLACES = """
  const place = (name) => {
    const box = document.querySelector(name)?.getBoundingClientRect();
    return box && box.width > 0 && document.querySelector(name).checkVisibility({contentVisibilityAuto: true}) ? {left: box.left, right: box.right, top: box.top + scrollY, bottom: box.bottom + scrollY} : null;
  };
  return Object.fromEntries(arguments[0].map((name) => [name, place(name)]));"""

# Tables that are wider than the page, and cells whose words do not fit them.
CUT = """
  const wide = document.documentElement.clientWidth + 1, cut = [];
  for (const table of document.querySelectorAll('table, #table')) {
    const box = table.getBoundingClientRect();
    if (box.width > 0 && (box.left < -1 || box.right > wide || table.scrollWidth > table.clientWidth + 1)) {
      cut.push(`a table from ${box.left} to ${box.right} of ${wide}, ${table.scrollWidth} in ${table.clientWidth}`);
    }
  }
  for (const cell of document.querySelectorAll('td, th, .number, #head button')) {
    if (cell.clientWidth > 0 && cell.scrollWidth > cell.clientWidth + 1) {
      cut.push(`'${cell.textContent}' in ${cell.clientWidth} pixels`);
    }
  }
  return cut;"""


def made(soms, folder):
    """A page of each kind: its name, its file, and whether it has a list and a slider."""
    for name, words in (("knot.ply", ("knot", "--triangles", "600")), ("ball.ply", ("sphere", "--triangles", "300")),
                        ("street.ply", ("city", "--triangles", "3000")), ("car.ply", ("car",))):
        subprocess.run([soms, "generate", *words, "-o", folder / name, "--quiet"], check=True, capture_output=True)
    (folder / "poses.csv").write_text("x,y,z\n0.5,0,0\n1,0,0\n9,0,0\n", encoding="ascii")
    (folder / "way.csv").write_text("x,y,z\n5,0.5,0\n-4,0,0\n5,3,0\n", encoding="ascii")
    (folder / "walls.csv").write_text("x,y,z\n-5,1.5,0.1\n13,1.5,0.1\n", encoding="ascii")
    (folder / "path.csv").write_text("x,y,z\n-60,-2,0.5\n60,-2,0.5\n", encoding="ascii")
    pair = (folder / "knot.ply", folder / "ball.ply")
    kinds = (
        ("simulate", True, True, (town(folder), "--count", "60", "--frames", "60")),
        ("overlap", True, True, (*pair, "--pose", folder / "poses.csv")),
        ("distance", False, False, (*pair, "--pose", "4 0 0")),
        ("motion", True, True, (*pair, "--path", folder / "way.csv")),
        ("clearance", False, True, (folder / "street.ply", "--profile", folder / "car.ply", "--path", folder / "path.csv", "--clearance", "0.5")),
        ("clearance contact", True, True, (MODELS / "structure.obj", "--profile", folder / "car.ply", "--path", folder / "walls.csv", "--every", "1")),
        ("clash", True, False, (MODELS / "structure.obj", "--against", MODELS / "services.gltf", "--clearance", "0.05")))
    for name, has_list, has_slider, words in kinds:
        subprocess.run([soms, name.split()[0], *words, "-o", folder / f"{name}.html", "--quiet"], check=True, capture_output=True)
        yield name, folder / f"{name}.html", has_list, has_slider


def screen_faults(browser, verb, file, has_list, has_slider):
    """The scene is in the first screen, whole, with what belongs to it; figures are below, folded."""
    page = Look(browser, file, SCREEN)
    box = page.run(PLACES, ["h1", ".lead", "#stage", "#list", "#table", "#time", "#answer figure", ".facts"])
    scene = box["#stage"]
    if scene is None or scene["top"] < 0 or scene["bottom"] > SCREEN[1] or scene["bottom"] - scene["top"] < 300:
        yield f"{verb}: the scene is at {scene}"
    if not box["h1"]["bottom"] <= box[".lead"]["top"] < box[".lead"]["bottom"] <= scene["top"]:
        yield f"{verb}: title and sentence are not above the scene"
    found = box["#table"] or box["#list"]
    if (found is not None) != has_list:
        yield f"{verb}: the list is at {found}"
    elif has_list and not (found["left"] >= scene["right"] and found["bottom"] <= SCREEN[1]):
        yield f"{verb}: the list at {found} is not beside the scene at {scene}"
    if (box["#time"] is not None) != has_slider or (has_slider and box["#time"]["bottom"] > SCREEN[1]):
        yield f"{verb}: the slider is at {box['#time']}"
    if verb.startswith("clearance"):
        if box["#answer figure"] is None or box["#answer figure"]["bottom"] > SCREEN[1]:
            yield f"{verb}: the plot is at {box['#answer figure']}"
    elif box[".facts"] is not None:
        yield f"{verb}: figures are not folded"
    if has_list and page.run("return document.querySelectorAll('[aria-selected=true]').length") != 1:
        yield f"{verb}: no line of the list is chosen"
    if page.run("return location.hash"):
        yield f"{verb}: the page changes its address when it opens"
    if page.is_wide():
        yield f"{verb}: the page scrolls sideways"
    yield from (f"{verb}: {fault}" for fault in page.run(CUT))


def phone_faults(browser, verb, file):
    page = Look(browser, file, PHONE, "dark")
    box = page.run(PLACES, ["#stage", ".lead"])
    if not box[".lead"]["bottom"] <= box["#stage"]["top"] < box["#stage"]["bottom"] <= 900:
        yield f"{verb}, 390 pixels: the scene is at {box['#stage']}"
    page.run("document.querySelectorAll('details').forEach((part) => { part.open = true; })")
    if page.is_wide():
        yield f"{verb}, 390 pixels: the page scrolls sideways"
    yield from (f"{verb}, 390 pixels: {fault}" for fault in page.run(CUT))


def sheets_of(pdf):
    """For each sheet of a PDF by Chromium, whether anything is written or drawn on it."""
    objects = dict(re.findall(rb"\n(\d+) 0 obj\n(.*?)\nendobj", pdf, re.DOTALL))
    for body in objects.values():
        if re.search(rb"/Type\s*/Page\b", body):
            number = re.search(rb"/Contents (\d+) 0 R", body).group(1)
            data = re.search(rb"stream\r?\n(.*)\r?\nendstream", objects[number], re.DOTALL).group(1)
            drawn = zlib.decompress(data) if b"/FlateDecode" in objects[number] else data
            yield b"Tj" in drawn or b"TJ" in drawn or b" Do" in drawn


def paper_faults(browser, verb, file):
    """On A4 nothing is cut, everything is unfolded, and no sheet is empty."""
    page = Look(browser, file, DESK)
    sheets = list(sheets_of(base64.b64decode(browser.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})["data"])))
    if not sheets or not all(sheets):
        yield f"{verb}: of the sheets {sheets} some are empty"
    if page.run("return document.querySelectorAll('details.fold[open]').length") and verb == "clash":
        yield f"{verb}: printing leaves the figures unfolded"
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": "print"})
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": PAPER[0], "height": PAPER[1], "deviceScaleFactor": 1, "mobile": False})
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    if page.run(PLACES, ["#look"])["#look"] is not None:
        yield f"{verb}: the scene is on paper twice"
    if page.is_wide():
        yield f"{verb}: paper is too narrow"
    if verb.startswith("clearance") and page.run(PLACES, ["#answer figure"])["#answer figure"] is None:
        yield f"{verb}: paper lacks the plot"
    yield from (f"{verb}, on paper: {fault}" for fault in page.run(CUT))
    if verb == "clash":
        broken = page.run("""return [...document.querySelectorAll('#printed th, #printed td.number')]
            .filter((cell) => {
              const range = document.createRange();
              range.selectNodeContents(cell);
              return range.getClientRects().length > 1;
            }).map((cell) => cell.textContent);""")
        if broken:
            yield f"on paper these break: {broken[:5]}"
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"media": ""})


def count_faults(soms, folder, browser):
    """The sentence of a page counts what JSON counts."""
    run = subprocess.run([soms, "simulate", town(folder), "--count", "60", "--frames", "60", "--json"],
                         check=True, capture_output=True, text=True)
    answer = json.loads(run.stdout)
    lead = Look(browser, folder / "simulate.html", SCREEN).run("return document.querySelector('.lead').textContent")
    if f"In all {answer['events']:,} event" not in lead or f"of {answer['movers']} movers" not in lead:
        yield f"simulate: {answer['events']} events by {answer['movers']} movers are '{lead}'"
    subprocess.run([soms, "clash", MODELS / "structure.obj", "--against", MODELS / "services.gltf", "--clearance", "0.05",
                    "-o", folder / "rows.json", "--quiet"], check=True, capture_output=True)
    rows = json.loads((folder / "rows.json").read_text(encoding="utf-8"))["rows"]
    deepest = max((row for row in rows if row["class"] == "crossing"), key=lambda row: row.get("depth", 0))
    page = Look(browser, folder / "clash.html", SCREEN)
    lead = page.run("return document.querySelector('.lead').textContent")
    if f"{len(rows)} clashes" not in lead or f"{deepest['depth']:.4g} deep" not in lead:
        yield f"clash: {len(rows)} rows, the deepest {deepest['depth']}, are '{lead}'"
    if rows[page.soms("chosenRow()")].get("depth") != deepest["depth"]:
        yield "clash: the page does not open on the deepest clash"


def layout_faults(browser, soms, folder):
    for verb, file, has_list, has_slider in made(soms, folder):
        yield from screen_faults(browser, verb, file, has_list, has_slider)
        yield from phone_faults(browser, verb, file)
        yield from paper_faults(browser, verb, file)
    yield from count_faults(soms, folder, browser)
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(layout_faults))
