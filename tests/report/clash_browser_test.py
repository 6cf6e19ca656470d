"""The page of a clash list, opened in Chromium from a file: sorted, filtered, searched, and a row chosen."""
import json
import pathlib
import shutil
import subprocess
import sys

from look import DESK, PHONE, Look, away, run_looks
from browser import console_faults

MODELS = pathlib.Path(__file__).resolve().parents[1] / "data/clash"


def written(soms, folder, name, *words):
    """The page, and the rows of the same list as JSON."""
    page, rows = folder / f"{name}.html", folder / f"{name}.json"
    subprocess.run([soms, "clash", *words, "-o", page, "-o", rows, "--quiet"], check=True, capture_output=True)
    return page, json.loads(rows.read_text(encoding="utf-8"))["rows"]


def same(page, rows):
    """What of the JSON list the page lacks."""
    if page.soms("rows") != len(rows):
        yield f"{page.soms('rows')} of {len(rows)} rows are on the page"
    for r, found in enumerate(page.run("return Array.from({length: soms.rows}, (_, r) => soms.row(r))")):
        wanted = {key: value for key, value in rows[r].items() if key != "schema"}
        if found != wanted:
            yield f"row {r} is {found}, not {wanted}"
            return


def cells(page, column):
    """Texts of a column of the rows that are drawn."""
    titles = page.run("return [...document.querySelectorAll('#head button')].map(e => e.textContent)")
    return page.run("return [...document.querySelectorAll('.clash')].map(e => e.children[arguments[0]].textContent)", titles.index(column))


def press(page, name):
    """A click on what may be drawn again while the driver scrolls to it."""
    page.run("document.querySelector(arguments[0]).click()", name)


def building_faults(browser, soms, folder):
    # A warning names the files by their paths, which have no place to break a line.
    far = pathlib.Path(shutil.copytree(MODELS, folder / ("a_folder_whose_name_is_long_" * 7)))
    page_file, rows = written(soms, folder, "building", far / "structure.obj", "--against", far / "services.gltf", "--clearance", "0.05")
    page = Look(browser, page_file, DESK)
    yield from same(page, rows)
    if f"All {len(rows)} rows" not in page.element("count").text:
        yield f"the page counts '{page.element('count').text}'"
    if sum(1 for row in rows if row["triangle_pairs"] > 0) != 260:
        yield "not 260 pairs meet"
    for column, key in (("Pairs", "triangle_pairs"), ("Gap", "gap"), ("Class", "class")):
        button = page.browser.find_element("css selector", f"#head button[data-sort={key}]")
        button.click()
        if button.find_element("xpath", "..").get_attribute("aria-sort") != "ascending":
            yield f"{column}: no heading says that the list is sorted"
        order = page.soms("shown()")
        values = [rows[r][key] for r in order]
        if key != "class" and values != sorted(values):
            yield f"{column}: not sorted"
        if len(order) != len(rows):
            yield f"{column}: sorting drops rows"
    page.browser.find_element("css selector", "#head button[data-sort=triangle_pairs]").click()
    page.browser.find_element("css selector", "#head button[data-sort=triangle_pairs]").click()
    page.run("document.getElementById('table').scrollTop = 0")  # the row that is chosen may be far below
    page.settle()
    if cells(page, "Pairs")[0] != f"{max(row['triangle_pairs'] for row in rows):,}":
        yield "falling order does not begin with the most"
    for box in page.browser.find_elements("css selector", "#classes input"):
        name = box.get_attribute("data-class")
        count = sum(row["class"] == name for row in rows)
        if str(count) not in box.find_element("xpath", "..").text:
            yield f"class {name} is not counted as {count}"
        box.click()
        if len(page.soms("shown()")) != len(rows) - count:
            yield f"class {name} cannot be filtered"
        box.click()
    part = rows[7]["b"]["part"]
    page.element("find").send_keys(part)
    wanted = [r for r, row in enumerate(rows) if all(word.lower() in json.dumps(row).lower() for word in part.split())]
    if not set(page.soms("shown()")) <= set(wanted) or 7 not in page.soms("shown()"):
        yield f"a search for {part} finds {page.soms('shown()')}"
    page.element("find").clear()
    page.run("document.getElementById('table').scrollTop = 4000")
    page.element("find").send_keys(part)
    if page.run("return document.getElementById('table').scrollTop"):
        yield "a search leaves the list where it was"
    page.element("clear").click()
    yield from chosen_faults(page, rows)
    button = page.browser.find_element("css selector", "#matrices button")
    if button.text != f"{len(rows):,}":
        yield f"the matrix counts {button.text}"
    button.click()
    if page.element("pair-filter").text != "Only clashes of structure.obj with services.gltf":
        yield f"the matrix filters by '{page.element('pair-filter').text}'"
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    if page.run("return document.querySelectorAll('#printed tbody tr').length") != len(rows):
        yield "rows are missing on paper"
    if page.run("return document.querySelectorAll('#prints canvas').length") != 6:
        yield "pictures are missing on paper"
    page.run("window.dispatchEvent(new Event('afterprint'))")
    if Look(browser, page_file, PHONE, "dark").is_wide():
        yield "a phone must scroll sideways"
    yield from console_faults(browser)


def chosen_faults(page, rows):
    """A row that is chosen is framed: both parts in their colors, and where they cross in red."""
    r = max(range(len(rows)), key=lambda k: (rows[k]["class"] == "crossing", -k))
    page.run("document.getElementById('table').scrollTop = 0")
    page.run("document.querySelector('#head button[data-sort=number]').click()")
    page.settle()
    press(page, f'.clash[data-row="{r}"]')
    page.landed()
    if page.soms("chosenRow()") != r or not away(page.soms("target()"), page.soms(f"focus({r})")) <= 1e-3:
        yield "the camera does not look at the row that is chosen"
    if page.soms(f"lines({r})") == 0:
        yield "a crossing has no curve"
    details = page.element("side").text
    for word in (rows[r]["class"], rows[r]["a"]["part"], rows[r]["b"]["part"], rows[r]["key"], rows[r]["a"]["file"]):
        if word not in details:
            yield f"the details do not say {word}"
    if page.run("return location.hash") != f"#clash={rows[r]['key']}":
        yield "no address names the row"
    page.run("document.getElementById('stage').scrollIntoView({block: 'center'})")
    colors = page.colors()
    if colors["blue"] < 300 or colors["sand"] < 300 or colors["contact"] < 30:
        yield f"of the parts and the crossing is drawn {colors}"
    page.element("table").send_keys("\ue015")  # arrow down
    if page.soms("chosenRow()") != r + 1:
        yield "the arrow keys do not choose"
    page.element("canvas").send_keys("p")
    page.landed()
    if page.soms("chosenRow()") != r:
        yield "the keys of the picture do not choose"


def words_faults(browser, soms, folder):
    """Names that try to break out are shown as they are; an older list adds its rows."""
    evil = "</script><script>document.title='broken'</script>"
    cube = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))

    def model(path, parts):
        lines, base = [], 1
        for name, low, high in parts:
            lines += [f"v {' '.join(str((high if k >> axis & 1 else low)[axis]) for axis in range(3))}" for k in range(8)]
            lines += [f"o {name}", *("f " + " ".join(str(base + c) for c in face) for face in cube)]
            base += 8
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return path

    a = model(folder / "a<i>.obj", [(evil, (0, 0, 0), (2, 2, 2)), ("<img src=x onerror=alert(1)>", (9, 0, 0), (10, 1, 1))])
    b = model(folder / "b&.obj", [("\u202educt", (1, 1, 1), (3, 3, 3)), ("post", (9.5, 0, 0), (11, 1, 1))])
    old, rows = written(soms, folder, "old", a, "--against", b)
    page = Look(browser, old, DESK)
    yield from same(page, rows)
    if page.run("return document.title") != "Clashes of a<i>.obj with b&.obj" or page.run("return document.images.length"):
        yield "a name breaks out"
    if not any(evil in text for text in cells(page, "First part")):
        yield f"a name is shown as {cells(page, 'First part')}"
    b = model(folder / "b&.obj", [("\u202educt", (1, 1, 1), (3, 3, 3)), ("post", (19.5, 0, 0), (21, 1, 1))])
    later, rows = written(soms, folder, "later", a, "--against", b, "--baseline", folder / "old.json")
    page = Look(browser, later, DESK)
    yield from same(page, rows)
    if sorted(cells(page, "Status")) != ["active", "resolved"]:
        yield f"statuses are {cells(page, 'Status')}"
    page.browser.find_element("css selector", '#statuses input[data-status="active"]').click()
    if [rows[r]["status"] for r in page.soms("shown()")] != ["resolved"]:
        yield "statuses cannot be filtered"
    press(page, ".clash")
    page.landed()
    if "resolved" not in page.element("details").text:
        yield "a row that is resolved has no details"
    none, rows = written(soms, folder, "none", a, "--against", b, "--ignore-class", "crossing")
    page = Look(browser, none, DESK)
    said = page.run("return document.querySelector('.lead').textContent")
    if said != "No parts clash." or page.element("table").is_displayed() or rows:
        yield f"an empty list says '{said}'"
    yield from console_faults(browser)


def many_faults(browser, soms, folder):
    """Rows by the ten thousand: all there, few drawn."""
    lines = []
    count = 120

    def bar(name, low, high):
        base = len([1 for line in lines if line.startswith("v ")]) + 1
        lines.extend(f"v {' '.join(str((high if k >> axis & 1 else low)[axis]) for axis in range(3))}" for k in range(8))
        lines.append(f"o {name}")
        lines.extend("f " + " ".join(str(base + c) for c in face) for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)))

    for k in range(count):
        bar(f"beam {k}", (2 * k, -1, 0), (2 * k + 1, 2 * count, 1))
    (folder / "beams.obj").write_text("\n".join(lines) + "\n", encoding="ascii")
    lines.clear()
    for k in range(count):
        bar(f"duct {k}", (-1, 2 * k, 0.25), (2 * count, 2 * k + 1, 0.75))
    (folder / "ducts.obj").write_text("\n".join(lines) + "\n", encoding="ascii")
    page_file, rows = written(soms, folder, "many", folder / "beams.obj", "--against", folder / "ducts.obj")
    page = Look(browser, page_file, DESK)
    if len(rows) != count * count or page.soms("rows") != len(rows) or len(page.soms("shown()")) != len(rows):
        yield f"{page.soms('rows')} of {len(rows)} rows are on the page"
    if page.run("return document.querySelectorAll('.clash').length") > 60:
        yield "rows are drawn that nobody sees"
    page.run("const t = document.getElementById('table'); t.scrollTop = t.scrollHeight")
    if not page.wait(f"return document.querySelector('.clash[data-row=\"{len(rows) - 1}\"]') !== null"):
        yield "the last row is out of reach"
    if page_file.stat().st_size > 1_000_000 + 450 * len(rows):
        yield f"a page of {len(rows)} rows has {page_file.stat().st_size} bytes"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(building_faults, words_faults, many_faults))
