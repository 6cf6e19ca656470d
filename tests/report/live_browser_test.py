"""A body of a report page is moved by real events of mouse and keys; what the page says is what `soms` says at that pose."""
import json
import shlex
import subprocess
import sys

from look import DESK, Look, in_sight, lines, town, run_looks
from browser import console_faults

START = "2.5 0 0"  # apart
KEYS = {"page down": "\ue00f", "left": "\ue012"}


class Moved(Look):
    """A page on which a body is moved."""

    def __init__(self, browser, page, soms, models):
        super().__init__(browser, page, DESK)
        self.command = soms
        self.models = models

    def act(self):
        from selenium.webdriver.common.action_chains import ActionChains
        return ActionChains(self.browser, duration=0)

    def begin(self):
        self.element("move").click()
        return self.answer()

    def answer(self):
        """What the page says of the pose that is shown, once it does."""
        self.wait("return Boolean(soms.live().answer)")
        return self.soms("live().answer")

    def native(self, verb):
        pose = shlex.split(self.element("live-pose").text)
        run = subprocess.run([self.command, verb, *self.models, *pose, "--json", *(["--no-pairs"] if verb == "overlap" else [])],
                             check=True, capture_output=True, text=True)
        return json.loads(run.stdout)

    def faults(self, where):
        """The page's answer beside that of the command at the pose that the page shows."""
        found = self.answer()
        self.settle()
        pairs = sum(other["pairs"] for other in found["touched"])
        expected = self.native("overlap")["count"]
        if pairs != expected:
            yield f"{where}: {pairs} pairs of triangles touch, {expected} by the command"
        words = self.element("live-answer").text
        if (f"{pairs:,} pair" if pairs else "touches nothing") not in words:
            yield f"{where}: the page says '{words}' of {pairs} pairs"
        drawn = self.run("return getComputedStyle(document.getElementById('live-gap')).display !== 'none'")
        if drawn != (pairs == 0) or bool(found["lines"]) != (pairs > 0):
            yield f"{where}: of {pairs} pairs {found['lines']} lines are drawn, and {'a' if drawn else 'no'} gap"
        if pairs == 0:
            distance = self.native("distance")["lower"]
            if found["gap"]["lower"] != distance:
                yield f"{where}: {found['gap']['lower']} apart, {distance} by the command"

    def touches(self):
        return bool(self.answer()["touched"])


def drag_faults(page):
    """Into the other body and out again, step by step: contacts come and go where the command says so."""
    begin, camera = page.soms("live().pose"), page.soms("camera()")
    canvas = page.element("canvas")
    x, y = page.soms("onCanvas(soms.live().body)")
    box = canvas.rect
    page.act().move_to_element_with_offset(canvas, int(x - box["width"] / 2), int(y - box["height"] / 2)).click_and_hold().perform()
    other = page.soms("onCanvas(1)")
    seen, red = [], []
    for step in range(8):
        there = 4 if step < 4 else -4
        page.act().move_by_offset(round((other[0] - x) / there), round((other[1] - y) / there)).perform()
        yield from page.faults(f"drag {step}")
        seen.append(page.touches())
        if len(seen) == 1 or seen[-1] != seen[-2]:
            red.append((seen[-1], page.picture()["contact"]))
    page.act().release().perform()
    if seen[0] or seen[-1] or sum(seen) < 2 or sum(a != b for a, b in zip(seen, seen[1:])) != 2:
        yield f"on its route into the other and back the body touches it: {seen}"
    if not all((pixels > 20) == touching for touching, pixels in red):
        yield f"a curve is seen where it should not be, or the reverse: {red}"
    end = page.soms("live().pose")
    if page.soms("camera()") != camera or end[11] != begin[11] or [*end[:3], *end[4:7]] != [*begin[:3], *begin[4:7]]:
        yield f"a drag turns the camera or the body, or lifts it: {begin}, {end}"


def key_faults(page):
    """Turned and lifted by keys, and lifted by the mouse."""
    before = page.soms("live().pose")
    canvas = page.element("canvas")
    for key in ("q", "q", "W", KEYS["page down"], KEYS["left"]):
        canvas.send_keys(key)
    after = page.soms("live().pose")
    if after[:3] == before[:3] or after[11] >= before[11] or len(page.element("live-pose").text.split()) != 8:
        yield f"keys do not turn and lower the body: {after}"
    yield from page.faults("turned")
    from selenium.webdriver.common.keys import Keys
    x, y = page.soms("onCanvas(soms.live().body)")
    box = canvas.rect
    at = page.act().move_to_element_with_offset(canvas, int(x - box["width"] / 2), int(y - box["height"] / 2))
    at.key_down(Keys.SHIFT).click_and_hold().move_by_offset(9, -40).release().key_up(Keys.SHIFT).perform()
    lifted = page.soms("live().pose")
    if lifted[11] <= after[11] or (lifted[3], lifted[7]) != (after[3], after[7]):
        yield f"with Shift the mouse does not lift the body: {after}, {lifted}"
    yield from page.faults("lifted")


def pair_faults(browser, soms, folder):
    models = [folder / "ball.obj", folder / "knot.ply"]
    for model, shape, triangles in zip(models, ("sphere", "knot"), (320, 500)):
        subprocess.run([soms, "generate", shape, "--triangles", str(triangles), "-o", model, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
    file = folder / "pair.html"
    subprocess.run([soms, "overlap", *models, "--pose", START, "-o", file], check=True, stdout=subprocess.DEVNULL)
    page = Moved(browser, file, soms, models)
    page.begin()
    if page.element("live-pose").text != f'--pose "{START}"' or page.element("reset").is_enabled():
        yield f"the recorded pose is shown as {page.element('live-pose').text}"
    yield from page.faults("recorded")
    yield from drag_faults(page)
    yield from key_faults(page)
    page.element("reset").click()
    yield from page.faults("reset")
    if not page.soms("live().recorded") or page.element("live-pose").text != f'--pose "{START}"':
        yield "the body does not return to its recorded pose"
    page.element("move").click()
    if page.soms("live()") or page.element("live").is_displayed():
        yield "moving does not end"
    yield from console_faults(browser)


def mover_faults(browser, soms, folder):
    """A mover of a simulation, where the report has it: it touches what its event says, by as many triangles."""
    file = folder / "town.html"
    subprocess.run([soms, "simulate", town(folder), "--count", "20", "--frames", "60", "-o", file], check=True,
                   stdout=subprocess.DEVNULL)
    page = Moved(browser, file, soms, [])
    in_sight(page, lines(page, "pair")[0]).click()
    page.landed()
    r = page.soms("chosenRow()")
    found = page.begin()
    pairs = sum(other["pairs"] for other in found["touched"])
    if not page.soms("live().recorded") or pairs < page.soms(f"most({r})"):
        yield f"where the report has it, {pairs} pairs touch of the {page.soms(f'most({r})')} of its event"
    if page.element("live-others").text:
        yield f"movers are left out: {page.element('live-others').text}"
    page.element("canvas").send_keys(KEYS["left"])
    moved = page.soms("live().recorded")
    page.element("next").click()
    page.landed()
    page.answer()
    if moved or not page.soms("live().recorded") or page.soms("live().body") not in page.soms("bodies(soms.chosenRow())"):
        yield "what is chosen next is not shown where the report has it"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(pair_faults, mover_faults))
