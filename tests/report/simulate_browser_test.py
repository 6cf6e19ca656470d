"""The page of a simulation, opened in Chromium from a file: drawn, searched, flown through, printed, by mouse and by keys."""
import json
import pathlib
import subprocess
import sys
import tempfile

from look import DESK, IS_CONTACT, PHONE, Look, away, in_sight, lines, town
from browser import console_faults, outcome, start_browser


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
    most = page.run("return [...Array(soms.rows).keys()].reduce((most, r) => Math.max(most, soms.most(r)), 0)")
    if page.soms("most(soms.chosenRow())") != most or not page.run("return document.querySelector('.line').ariaSelected === 'true'"):
        yield "the page does not open on the event with the most pairs of triangles"
    if page.soms("calls()") > 60:
        yield f"{page.soms('calls()')} draw calls"
    if not page.element("drawn").text.startswith("Drawn: "):
        yield "nothing says what is drawn"
    if page.run("return document.querySelectorAll('figure svg').length") < 3:
        yield "plots are missing"


def fold_faults(page):
    """A press on a row: the camera flies there, and its contacts fold out and in again."""
    if lines(page, "contact"):
        yield "contacts are folded out before anybody queried"
    row = in_sight(page, lines(page, "pair")[2])
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
    if not away(page.soms("target()"), page.soms(f"center({r})")) <= 1e-3:
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
    row = in_sight(page, lines(page, "contact")[0])
    k = int(row.get_attribute("data-contact"))
    row.click()
    page.landed()
    after, target = page.soms("camera()"), page.soms("target()")
    if away(before, after) < 1:
        yield f"the camera stayed where it was: {before}, {after}"
    if not away(target, page.soms(f"focus({k})")) <= 1e-3:
        yield f"the camera looks at {target}, the contact is at {page.soms(f'focus({k})')}"
    if away(after, target) > 60:
        yield f"the camera is {away(after, target)} away from the contact"
    if page.soms("chosen()") != k:
        yield "the contact is not chosen"
    seen = page.colors()  # bodies may hide most of it
    if seen["contact"] + seen["hidden"] < 30:
        yield f"of the contact is seen {seen}"
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
    if sum(heap["all"] for heap in heaps) != page.soms("rows"):
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
    page.print_one()
    after = page.soms("chosenTriangles()")
    if before < 3 or after != before:
        yield f"printing leaves {after} corners of a chosen contact of {before}"


def print_faults(browser, file, answer):
    """On paper: a picture of each of the first 20 events, in the colors of paper."""
    page = Look(browser, file, DESK, "dark")
    opened = page.soms("chosenRow()")
    page.run("window.dispatchEvent(new Event('beforeprint'))")
    figures = page.run(IS_CONTACT + """return [...document.querySelectorAll('#prints figure')].map((figure) => {
        const canvas = figure.querySelector('canvas'), pen = canvas.getContext('2d');
        const {data} = pen.getImageData(0, 0, canvas.width, canvas.height);
        let [red, light] = [0, 0];
        for (let at = 0; at < data.length; at += 4) {
          red += isContact(data, at);
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
    if page.soms("chosenRow()") != opened or opened < 0:
        yield "printing chooses another row"
    sheets = browser.execute_cdp_cmd("Page.printToPDF", {"preferCSSPageSize": True})["data"]
    if len(sheets) < 100_000:
        yield f"what is printed has {len(sheets)} characters"
    yield from console_faults(browser)


def city_faults(browser, soms, folder):
    """The embedded city: a small page, and a first picture of few triangles. Times are printed, and decide nothing."""
    file = folder / "embedded.html"
    run = subprocess.run([soms, "simulate", "-o", file, "--json"], check=True,
                         capture_output=True, text=True)
    answer = json.loads(run.stdout)
    if file.stat().st_size > 8_000_000:
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
    in_sight(page, lines(page, "pair")[0]).click()
    page.landed()
    if page.picture()["contact"] < 20:
        yield "the first event of the embedded city is not seen"
    yield from console_faults(browser)


def scheme_faults(browser, file):
    papers = {}
    for scheme in ("light", "dark"):
        page = Look(browser, file, DESK, scheme)
        page.run("document.getElementById('whole').click()")
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
    yield from console_faults(browser)


def plain_faults(folder, file):
    """Without WebGL: figures, list and time line are there, and it is said what is not."""
    browser = start_browser(folder)
    try:
        page = Look(browser, file, DESK)
        words = page.element("trouble").text
        if "WebGL" not in words:
            yield f"without WebGL it says: '{words}'"
        in_sight(page, lines(page, "pair")[0]).click()
        if "touches" not in page.element("picked").text:
            yield "without WebGL a contact cannot be chosen"
        if page.run("return document.querySelectorAll('figure svg').length") < 3:
            yield "without WebGL plots are missing"
        yield from console_faults(browser)
    finally:
        browser.quit()


def main():
    soms = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = start_browser(folder, webgl=True)
        try:
            file = folder / "city.html"
            run = subprocess.run([soms, "simulate", town(folder), "--count", "60", "--frames", "60",
                                  "-o", file, "--json"], check=True, capture_output=True,
                                 text=True)
            found = [*simulate_faults(browser, file, json.loads(run.stdout)), *city_faults(browser, soms, folder)]
        finally:
            browser.quit()
        found += plain_faults(folder, file)
    return outcome(found)


if __name__ == "__main__":
    sys.exit(main())
