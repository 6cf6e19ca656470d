"""Report pages, opened in Chromium from a file: drawn, searched, flown through, by mouse and by keys.

Needs Chromium, its driver and Selenium (section test of packages.txt); where one is missing the test
says so and is skipped. WebGL is drawn by software.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
PHONE = (390, 800)
DESK = (1200, 900)
PATIENCE = 1200  # seconds, a guard: software draws slowly where the machine is busy


def skip(why):
    print(f"skipped: {why}; the packages of section test in packages.txt bring it")
    sys.exit(SKIPPED)


def start_browser(folder, webgl):
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    driver = shutil.which("chromedriver")
    if chromium is None or driver is None:
        skip("Chromium or its driver is not installed")
    try:
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
    except ImportError:
        skip("Selenium for Python is not installed")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    drawing = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"]
    # As root Chromium runs without its sandbox only; containers have little shared memory.
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--no-first-run",
                     "--disable-background-networking", "--hide-scrollbars",
                     f"--user-data-dir={folder / ('profile' + str(webgl))}",
                     *(drawing if webgl else ["--disable-gpu", "--disable-3d-apis"])):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    os.environ["HOME"] = str(folder)
    browser = webdriver.Chrome(options=options, service=Service(executable_path=driver))
    browser.set_page_load_timeout(PATIENCE)
    browser.set_script_timeout(PATIENCE)
    return browser


# The browser decodes its own pictures: a million pixels are seconds of Python. What counts as the color of a contact, in
# light and dark, is that of apps/support/look.h.
READ_PICTURE = """
  const [source, done] = arguments, image = new Image();
  image.onload = () => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const pen = canvas.getContext('2d', {willReadFrequently: true});
    pen.drawImage(image, 0, 0);
    const {data} = pen.getImageData(0, 0, image.width, image.height), colors = new Set();
    let contact = 0;
    for (let at = 0; at < data.length; at += 4) {
      const [red, green, blue] = [data[at], data[at + 1], data[at + 2]];
      colors.add(red << 16 | green << 8 | blue);
      contact += red > 180 && green < 95 && blue < 80;
    }
    const corner = 4 * (5 * image.width + image.width - 5);
    done({colors: colors.size, contact, corner: data[corner] + data[corner + 1] + data[corner + 2]});
  };
  image.src = 'data:image/png;base64,' + source;"""


class Look:
    """A page that is open."""

    def __init__(self, browser, page, size, scheme="light", mark=""):
        self.browser = browser
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [
            {"name": "prefers-color-scheme", "value": scheme}]})
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": size == PHONE})
        browser.get("about:blank")
        browser.get(page.as_uri() + mark)
        self.wait("return Boolean(window.soms)")
        self.run("document.getElementById('look').scrollIntoView()")

    def run(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def wait(self, script):
        """True once the script says so; false if it never does."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            if self.run(script):
                return True
            time.sleep(0.05)
        return False

    def element(self, name):
        return self.browser.find_element("id", name)

    def soms(self, what):
        return self.run(f"return soms.{what}")

    def landed(self):
        return self.wait("return !soms.flying()")

    def canvas(self):
        """The picture, once it is drawn and stands still: its PNG in base64."""
        self.landed()
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done));")
        return self.element("canvas").screenshot_as_base64

    def picture(self):
        """Of that picture: how many colors, pixels of a contact, and the sum of a pixel at the upper right."""
        return self.browser.execute_async_script(READ_PICTURE, self.canvas())

    def is_wide(self):
        return self.run("return document.documentElement.scrollWidth"
                        " > document.documentElement.clientWidth")


def away(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5


def first_sight_faults(page, answer):
    if page.picture()["colors"] < 20:
        yield "the canvas is blank"
    if page.soms("contacts") != answer["contacts"]:
        yield f"{page.soms('contacts')} contacts on the page, {answer['contacts']} in the answer"
    if not 0 < page.soms("rows") == answer["events"]:
        yield f"{page.soms('rows')} rows on the page, {answer['events']} events in the answer"
    if f"{answer['events']:,} events" not in page.element("count").text:
        yield f"the list says '{page.element('count').text}'"
    sums = page.run("return [...Array(soms.rows).keys()].reduce((sum, r) => sum + soms.total(r), 0)")
    if sums != answer["contacts"]:
        yield f"the events of the page have {sums} contacts, the answer {answer['contacts']}"
    if page.soms("calls()") > 60:
        yield f"{page.soms('calls()')} draw calls"
    if not page.element("drawn").text.startswith("Drawn: "):
        yield "nothing says what is drawn"
    if page.run("return document.querySelectorAll('figure svg').length") < 3:
        yield "plots are missing"


def lines(page, kind):
    """Lines of the list that are drawn: "pair" for rows, "contact" for what is folded out."""
    return page.browser.find_elements("css selector", f".line.{kind}")


def fold_faults(page):
    """A press on a row: the camera flies there, and its contacts fold out and in again."""
    if lines(page, "contact"):
        yield "contacts are folded out before anybody queried"
    row = lines(page, "pair")[2]
    r = int(row.get_attribute("data-row"))
    if "contact" not in row.text or "at (" not in row.text or "at most" not in row.text:
        yield f"a row says neither counts nor place: '{row.text}'"
    row.click()
    page.landed()
    if page.picture()["contact"] < 20:
        yield "the curve of an event is not seen"
    if page.soms("most(%d)" % r) < 1:
        yield "an event has no pairs of triangles"
    if page.soms("chosenRow()") != r or page.soms("chosen()") != -1:
        yield "the row is not chosen"
    if away(page.soms("target()"), page.soms(f"center({r})")) > 1e-3:
        yield "the camera does not look at the row's place"
    if page.run("return location.hash") != f"#row={r}":
        yield "the address does not name the row"
    if len(lines(page, "contact")) < min(3, page.soms(f"held({r})")):
        yield "the contacts of the row do not fold out"
    page.element("list").send_keys("\ue012")  # left
    if lines(page, "contact"):
        yield "the left key does not close the row"
    page.element("list").send_keys("\ue014")  # right
    if not lines(page, "contact"):
        yield "the right key does not open the row"


def click_faults(page):
    """A press on a contact: the camera flies there, the triangles light up, time is the contact's."""
    before = page.soms("camera()")
    row = lines(page, "contact")[0]
    k = int(row.get_attribute("data-contact"))
    row.click()
    page.landed()
    after, target = page.soms("camera()"), page.soms("target()")
    if away(before, after) < 1:
        yield f"the camera stayed where it was: {before}, {after}"
    if away(target, page.soms(f"focus({k})")) > 1e-3:
        yield f"the camera looks at {target}, the contact is at {page.soms(f'focus({k})')}"
    if away(after, target) > 60:
        yield f"the camera is {away(after, target)} away from the contact"
    if page.soms("chosen()") != k:
        yield "the contact is not chosen"
    if page.picture()["contact"] < 30:
        yield "no triangle of the contact is seen"
    words = page.element("picked").text
    if "touches" not in words or "triangle" not in words:
        yield f"the contact is not reported: '{words}'"
    if page.run("return location.hash") != f"#contact={k}":
        yield "the address does not name the contact"


def search_faults(page):
    find = page.element("find")
    find.send_keys("CAR house_6")
    some = page.soms("shown()")
    shown = page.run("return [...document.querySelectorAll('.line.pair')].map(e => e.textContent)")
    if not 0 < some < page.soms("rows"):
        yield f"a search finds {some} of {page.soms('rows')} rows"
    if not all("car" in text and "house_6" in text for text in shown):
        yield f"a search for 'CAR house_6' shows {shown}"
    find.clear()
    find.send_keys("</script><b>")
    if page.element("count").text[:2] != "0 ":
        yield f"a search for nonsense finds: {page.element('count').text}"
    find.clear()
    find.send_keys(" ")


def key_faults(page):
    """Everything by keys alone."""
    keys = {"left": "\ue012", "down": "\ue015", "home": "\ue011"}
    page.element("list").send_keys(keys["home"])
    page.landed()
    first = page.soms("chosenRow()")
    page.element("list").send_keys(keys["down"])
    page.landed()
    if page.soms("chosenRow()") == first and page.soms("chosen()") < 0:
        yield "the arrow keys do not go through the list"
    canvas = page.element("canvas")
    for key in (keys["left"], keys["down"], "+", "-", keys["home"]):
        before = page.soms("camera()")
        canvas.send_keys(key)
        page.landed()
        if away(before, page.soms("camera()")) < 1e-4:
            yield f"key {key!r} does not move the camera"
    chosen = page.run("return [soms.chosenRow(), soms.chosen()]")
    canvas.send_keys("n")
    page.landed()
    if page.run("return [soms.chosenRow(), soms.chosen()]") == chosen:
        yield "key N does not go to the next line"
    canvas.send_keys("P")
    page.landed()
    if page.run("return [soms.chosenRow(), soms.chosen()]") != chosen:
        yield "key P, with Shift or Caps Lock, does not go to the line before"


def time_faults(page):
    page.run("document.getElementById('whole').click()")
    still = page.canvas()
    page.element("step").send_keys("\ue010")  # End
    if page.soms("step()") != 59:
        yield f"the slider's end is step {page.soms('step()')}"
    if page.canvas() == still:
        yield "nothing moved from the first to the last frame"
    # Where drawing takes seconds, all is played between two looks from here.
    page.run("""window.least = 59;
        (function note() { least = Math.min(least, soms.step()); requestAnimationFrame(note); })();
        document.getElementById('play').click()""")
    if not page.wait("return least < 59 && soms.step() > least"):
        yield "it does not play"
    page.run("const play = document.getElementById('play'); if (play.textContent === 'Pause') play.click()")
    stopped = page.soms("step()")
    page.run("window.drawn = 0; (function count() { ++drawn; requestAnimationFrame(count); })();")
    if not page.wait("return drawn > 12"):
        yield "the page draws no frames"
    if page.soms("step()") != stopped:
        yield "it does not pause"


def pick_faults(page):
    """A press on a spot in the picture, and on a bar of the time line."""
    page.run("document.getElementById('above').click()")
    page.landed()
    page.run("""
      const canvas = document.getElementById('canvas');
      const frame = canvas.getBoundingClientRect();
      window.found = false;
      for (let y = 4; y < frame.height && !found; y += 4) {
        for (let x = 4; x < frame.width && !found; x += 4) {
          const at = {clientX: frame.left + x, clientY: frame.top + y, bubbles: true, pointerId: 1};
          const before = soms.chosenRow();
          canvas.dispatchEvent(new PointerEvent('pointerdown', at));
          canvas.dispatchEvent(new PointerEvent('pointerup', at));
          found = soms.chosenRow() !== before;
        }
      }""")
    if not page.landed() or page.soms("chosenRow()") < 0 or not page.run("return found"):
        yield "no spot can be pressed"
    bars = page.browser.find_elements("css selector", "#time-line [data-contact]")
    k = int(bars[-1].get_attribute("data-contact"))
    page.run("arguments[0].dispatchEvent(new MouseEvent('click', {bubbles: true}))", bars[-1])
    page.landed()
    if page.soms("chosen()") != k:
        yield "a press on the time line does not choose its contact"


def spot_faults(page):
    """From afar, spots that lie on each other are one with a number; each row counts once."""
    page.run("document.getElementById('whole').click()")
    page.landed()
    page.run("""for (let n = 0; n < 25; ++n) {
        document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keydown', {key: '-', bubbles: true}));}""")
    page.canvas()
    heaps = page.soms("spots()")
    if sum(heap["all"] for heap in heaps) != page.soms("rows") - (page.soms("chosenRow()") >= 0):
        yield f"spots stand for {sum(heap['all'] for heap in heaps)} of {page.soms('rows')} rows"
    written = page.run("return [...document.querySelectorAll('#spots g')]"
                       ".filter((g) => g.style.display !== 'none').map((g) => g.textContent)")
    many = [heap["now"] or heap["all"] for heap in heaps if (heap["now"] or heap["all"]) > 1]
    if not many or sorted(written) != sorted(f"{count:,}" for count in many):
        yield f"the numbers on spots are {written}, not {many}"
    for k, one in enumerate(heaps):
        for other in heaps[:k]:
            if abs(one["x"] - other["x"]) + abs(one["y"] - other["y"]) < 10:
                yield f"two spots are one upon the other at {one['x']}, {one['y']}"


def restore_faults(browser, file):
    """After printing a contact is chosen as it was: its triangles, not its event."""
    page = Look(browser, file, DESK, mark="#contact=1")
    page.wait("return soms.chosen() === 1")
    page.landed()
    before = page.soms("chosenTriangles()")
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    page.run("window.dispatchEvent(new Event('afterprint'))")
    after = page.soms("chosenTriangles()")
    if before < 3 or after != before:
        yield f"printing leaves {after} corners of a chosen contact of {before}"


def print_faults(browser, file, answer):
    """On paper: a picture of each of the first 20 events, in the colors of paper."""
    page = Look(browser, file, DESK, "dark")
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    figures = page.run("""return [...document.querySelectorAll('#prints figure')].map((figure) => {
        const canvas = figure.querySelector('canvas'), pen = canvas.getContext('2d');
        const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
        let [red, light] = [0, 0];
        for (let at = 0; at < data.length; at += 4) {
          red += data[at] > 180 && data[at + 1] < 95 && data[at + 2] < 80;
          light += data[at] + data[at + 1] + data[at + 2] > 300;
        }
        return [figure.textContent, red, light / (data.length / 4)];});""")
    if len(figures) != min(20, answer["events"]):
        yield f"on paper there are pictures of {len(figures)} of {answer['events']} events"
    for text, red, light in figures:
        if red < 20 or light < 0.5 or "touches" not in text or "frame" not in text:
            yield f"on paper '{text}' has {red} pixels of a contact, {light:.2f} are light"
    page.run("window.dispatchEvent(new Event('afterprint'))")
    if page.run("return document.querySelectorAll('#prints figure').length"):
        yield "pictures for paper stay on the page"
    if page.soms("chosenRow()") != -1:
        yield "printing chooses a row"
    sheets = browser.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})["data"]
    if len(sheets) < 100_000:
        yield f"what is printed has {len(sheets)} characters"
    yield from log_faults(browser)


def city_faults(browser, soms, folder):
    """The embedded city: a small page, and a first picture of few triangles. Times are printed, and decide nothing."""
    file = folder / "embedded.html"
    run = subprocess.run([soms, "simulate", "--report", file, "--json"], check=True,
                         capture_output=True, text=True)
    answer = json.loads(run.stdout)
    if file.stat().st_size > 5_000_000:
        yield f"the embedded city takes {file.stat().st_size} bytes"
    page = Look(browser, file, DESK)
    page.wait("return Boolean(soms.firstPicture()?.at)")
    first = page.soms("firstPicture()")
    print(f"embedded city: first picture after {first['at']:.0f} ms, {first['triangles']} triangles")
    if not 1_000 < first["triangles"] < 60_000:
        yield f"the first picture of the embedded city has {first['triangles']} triangles"
    if page.soms("rows") != answer["events"] or page.soms("contacts") != answer["contacts"]:
        yield f"the page of the embedded city has {page.soms('rows')} events"
    if not page.wait("return soms.isWhole"):
        yield "the whole city does not arrive"
    lines(page, "pair")[0].click()
    page.landed()
    if page.picture()["contact"] < 20:
        yield "the first event of the embedded city is not seen"
    yield from log_faults(browser)


def scheme_faults(browser, file):
    papers = {}
    for scheme in ("light", "dark"):
        page = Look(browser, file, DESK, scheme)
        papers[scheme] = page.picture()["corner"]
        ink, paper = page.run("const s = getComputedStyle(document.body);"
                              "return [s.color, s.backgroundColor]")
        if ink == paper:
            yield f"{scheme}: {ink} on {paper}"
    if papers["dark"] >= papers["light"]:
        yield f"the picture is as bright in the dark: {papers}"
    page = Look(browser, file, PHONE)
    if page.is_wide():
        yield "390 pixels: the page scrolls sideways"
    if page.picture()["colors"] < 20:
        yield "390 pixels: the canvas is blank"
    for name in ("canvas", "find", "list", "step", "play", "next"):
        box = page.run("const r = document.getElementById(arguments[0]).getBoundingClientRect();"
                       "return [r.left, r.right, r.width, r.height]", name)
        if box[0] < 0 or box[1] > PHONE[0] or box[2] < 30 or box[3] < 10:
            yield f"390 pixels: {name} is at {box}"
    linked = Look(browser, file, DESK, mark="#contact=1")
    if not linked.wait("return soms.chosen() === 1"):
        yield "an address that names a contact does not show it"
    linked = Look(browser, file, DESK, mark="#row=1")
    if not linked.wait("return soms.chosenRow() === 1"):
        yield "an address that names a row does not show it"


def log_faults(browser):
    for entry in browser.get_log("browser"):
        # Software pictures are read back by this test itself, which the driver finds slow.
        if "GPU stall due to ReadPixels" not in entry["message"]:
            yield f"console: {entry['level']} {entry['message']}"
    for entry in browser.get_log("performance"):
        message = json.loads(entry["message"])["message"]
        if message["method"] == "Network.requestWillBeSent":
            address = message["params"]["request"]["url"]
            if not address.startswith(("file:", "data:", "about:", "chrome:", "blob:")):
                yield f"requested {address}"


def simulate_faults(browser, file, answer):
    page = Look(browser, file, DESK)
    for look in (lambda: first_sight_faults(page, answer), lambda: fold_faults(page),
                 lambda: click_faults(page),
                 lambda: search_faults(page), lambda: key_faults(page), lambda: time_faults(page),
                 lambda: pick_faults(page), lambda: spot_faults(page),
                 lambda: restore_faults(browser, file)):
        yield from look()
    yield from scheme_faults(browser, file)
    yield from print_faults(browser, file, answer)
    yield from log_faults(browser)


def gap_faults(browser, soms, folder):
    """A link of the table shows its gap: a line between the two, with its length."""
    file = folder / "near.html"
    subprocess.run([soms, "simulate", folder / "to<b>wn&.obj", "--count", "60", "--frames", "60",
                    "--clearance", "2", "--report", file, "--quiet"], check=True,
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
    if away(page.soms("target()"), page.soms("middle(1)")) > 1e-3:
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
    if shown[1] < 5 or abs(shown[2] - 0.5) > 0.05 or abs(shown[3] - 0.5) > 0.05:
        yield f"the line of the gap is not in the middle: {shown}"
    for moment in ("beforeprint", "afterprint"):
        page.run(f"window.dispatchEvent(new Event('{moment}'))")
    if page.soms("chosenGap()") != 1:
        yield "after printing no gap is chosen"
    linked = Look(browser, file, DESK, mark="#gap=2")
    if not linked.wait("return soms.chosenGap() === 2"):
        yield "an address that names a gap does not show it"
    lines(linked, "pair")[0].click()
    linked.landed()
    if linked.soms("chosenGap()") != -1:
        yield "a gap stays chosen beside a contact"
    for name, shape in (("a.ply", "sphere"), ("b.ply", "knot")):
        subprocess.run([soms, "generate", shape, "--triangles", "800", "-o", folder / name],
                       check=True, capture_output=True)
    subprocess.run([soms, "distance", folder / "a.ply", folder / "b.ply", "--pose", "4 0 0",
                    "--report", file], check=True, capture_output=True)
    page = Look(browser, file, DESK, "dark")
    page.canvas()
    shown = page.run("""return [...document.querySelectorAll('#gaps g')].map(g => [g.style.display,
        g.textContent, getComputedStyle(g.querySelector('.ink')).stroke])""")
    if len(shown) != 1 or shown[0][0] == "none" or not 0 < float(shown[0][1]) < 4:
        yield f"the distance of a single pose is drawn as {shown}"
    elif shown[0][2] != page.run("return getComputedStyle(document.body).color"):
        yield f"in the dark the line is {shown[0][2]}"
    yield from log_faults(browser)


def plain_faults(folder, file):
    """Without WebGL: figures, list and time line are there, and it is said what is not."""
    browser = start_browser(folder, False)
    try:
        page = Look(browser, file, DESK)
        words = page.element("trouble").text
        if "WebGL" not in words:
            yield f"without WebGL it says: '{words}'"
        lines(page, "pair")[0].click()
        if "touches" not in page.element("picked").text:
            yield "without WebGL a contact cannot be chosen"
        if page.run("return document.querySelectorAll('figure svg').length") < 3:
            yield "without WebGL plots are missing"
        yield from log_faults(browser)
    finally:
        browser.quit()


def town(folder):
    """A ground of 200 m with nine houses, whose names try to break out."""
    path = folder / "to<b>wn&.obj"
    lines = ["v 0 0 0", "v 200 0 0", "v 200 200 0", "v 0 200 0", "o ground", "f 1 2 3", "f 1 3 4"]
    for k in range(9):
        x, y, base = 20 + 60 * (k % 3), 20 + 60 * (k // 3), 5 + 8 * k
        for corner in range(8):
            lines.append(f"v {x + 40 * (corner & 1)} {y + 20 * (corner & 2)} {(8 + k) * (corner // 4)}")
        lines.append(f"o house_{k}</script><img>")
        for face in ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2),
                     (1, 3, 7, 5)):
            a, b, c, d = (base + corner for corner in face)
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


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
                              pose, "--report", file, "--json", "--no-pairs"], check=True,
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
        lines(page, "contact")[0].click()
        page.landed()
        if away(before, page.soms("camera()")) < 0.1:
            yield "overlap: the camera stayed where it was"
        if page.picture()["contact"] < 30:
            yield "overlap: no triangle of the contact is seen"
    yield from log_faults(browser)


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
                    fins(folder / "ducts.obj", "duct", parts, False), "--report", file, "--quiet"],
                   check=True, stdout=subprocess.DEVNULL)
    page = Look(browser, file, DESK)
    if page.soms("rows") != parts ** 2:
        yield f"many rows: {page.soms('rows')} rows of {parts ** 2}"
    if "100,489 pairs of parts" not in page.element("count").text:
        yield f"many rows: the list says '{page.element('count').text}'"
    if "10,000 of 100,489 pairs of triangles" not in page.element("missing").text:
        yield f"many rows: the picture says '{page.element('missing').text}'"
    page.element("order").send_keys("by begin")
    page.run("const list = document.getElementById('list'); list.scrollTop = list.scrollHeight")
    if not page.wait("return [...document.querySelectorAll('.line.pair b')]"
                     ".some(e => e.textContent === 'beam 316 touches duct 316')"):
        yield "many rows: the last row is out of reach"
    if page.run("return document.querySelectorAll('.line').length") > 60:
        yield "many rows: rows are drawn that nobody sees"
    page.element("find").send_keys("beam 316 duct 315")
    found = page.run("return [...document.querySelectorAll('.line.pair b')].map(e => e.textContent)")
    if "beam 316 touches duct 315" not in found or page.soms("shown()") > 9:
        yield f"many rows: a search finds {page.soms('shown()')}: {found[:3]}"
    row = lines(page, "pair")[0]
    r = int(row.get_attribute("data-row"))
    row.click()
    page.landed()
    if away(page.soms("target()"), page.soms(f"center({r})")) > 1e-3:
        yield "many rows: the camera does not go to a row without triangles"
    left = [line.text for line in lines(page, "left")]
    if page.soms(f"held({r})") == 0 and not any("not on this page" in text for text in left):
        yield f"many rows: a row without triangles does not say so: {left}"
    yield from log_faults(browser)


def reproduce_faults(browser, soms, folder):
    file = folder / "thesis.html"
    subprocess.run([soms, "reproduce", "--quick", "--quiet", "--item", "5.3", "-o", folder / "out",
                    "--report", file], check=True, stdout=subprocess.DEVNULL)
    browser.get(file.as_uri())
    links = browser.execute_script(
        "return [...document.querySelectorAll('a')].map(a => a.getAttribute('href'))")
    for link in links:
        if not link.startswith(("#", "data:")):
            yield f"reproduce: a link leads to {link}"
    if not any(link.startswith("data:text/csv") for link in links):
        yield "reproduce: no table can be taken along"
    yield from log_faults(browser)


def main():
    soms = sys.argv[1]
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = start_browser(folder, True)
        try:
            file = folder / "city.html"
            run = subprocess.run([soms, "simulate", town(folder), "--count", "60", "--frames", "60",
                                  "--report", file, "--json"], check=True, capture_output=True,
                                 text=True)
            found += simulate_faults(browser, file, json.loads(run.stdout))
            found += city_faults(browser, soms, folder)
            found += gap_faults(browser, soms, folder)
            found += overlap_faults(browser, soms, folder)
            found += many_rows_faults(browser, soms, folder)
            found += reproduce_faults(browser, soms, folder)
        finally:
            browser.quit()
        found += plain_faults(folder, file)
    for line in found:
        print(line)
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
