"""A report page that is open in a browser, for tests that look at it by mouse and by keys."""
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import PATIENCE, outcome, start_browser  # noqa: E402

PHONE = (390, 800)
DESK = (1000, 600)  # few pixels: software draws them


# What counts as the color of a contact, in light and dark, is that of apps/draw/look.h.
IS_CONTACT = "const isContact = (data, at) => data[at] > 180 && data[at + 1] < 95 && data[at + 2] < 80;"

# The browser decodes its own pictures: a million pixels are seconds of Python.
READ_PICTURE = IS_CONTACT + """
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
      contact += isContact(data, at);
    }
    const corner = 4 * (5 * image.width + image.width - 5);
    done({colors: colors.size, contact, corner: data[corner] + data[corner + 1] + data[corner + 2]});
  };
  image.src = 'data:image/png;base64,' + source;"""

# Pixels of the colors of bodies, of contacts, of contacts that walls hide, and of shadows upon a ground, in the light scheme.
COUNT_COLORS = IS_CONTACT + """
  const [source, done] = arguments, image = new Image();
  image.onload = () => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const pen = canvas.getContext('2d', {willReadFrequently: true});
    pen.drawImage(image, 0, 0);
    const {data} = pen.getImageData(0, 0, image.width, image.height);
    const found = {blue: 0, sand: 0, contact: 0, hidden: 0, shadow: 0, light: 0, all: data.length / 4};
    for (let at = 0; at < data.length; at += 4) {
      const [r, g, b] = [data[at], data[at + 1], data[at + 2]];
      found.blue += b > r + 60 && b > g + 30;
      found.sand += r > b + 35 && g > b + 15 && r < g + 60;
      found.contact += isContact(data, at);
      found.hidden += r > g + 40 && r > b + 45 && Math.abs(g - b) < 25 && g > 110;
      const gray = Math.abs(r - g) < 12 && Math.abs(g - b) < 16;
      found.shadow += gray && r > 120 && r < 190;
      found.light += gray && r > 210;
    }
    done(found);
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

    def settle(self):
        """Waits for what is to be drawn next."""
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done));")

    def canvas(self):
        """The picture, once it is drawn and stands still: its PNG in base64."""
        self.landed()
        self.settle()
        return self.element("canvas").screenshot_as_base64

    def picture(self):
        """Of that picture: how many colors, pixels of a contact, and the sum of a pixel at the upper right."""
        return self.browser.execute_async_script(READ_PICTURE, self.canvas())

    def colors(self):
        """How many pixels of each meaning that picture has."""
        return self.browser.execute_async_script(COUNT_COLORS, self.canvas())

    def print_one(self):
        """Prints, as far as scripts notice, with one row in the list: each row on paper is a picture to draw."""
        self.element("find").send_keys(self.soms("title(0)"))
        for moment in ("beforeprint", "afterprint"):
            self.run(f"window.dispatchEvent(new Event('{moment}'))")

    def is_wide(self):
        return self.run("return document.documentElement.scrollWidth"
                        " > document.documentElement.clientWidth")


def away(a, b):
    return sum((x - y) ** 2 for x, y in zip(a, b)) ** 0.5


def lines(page, kind):
    """Lines of the list that are drawn: "pair" for rows, "contact" for what is folded out."""
    return page.browser.find_elements("css selector", f".line.{kind}")


def in_sight(page, line):
    """A line of the list, once the list is scrolled to it; scrolling draws lines again."""
    at = line.get_attribute("data-at")
    page.run("arguments[0].scrollIntoView({block: 'nearest'})", line)
    page.settle()
    return page.browser.find_element("css selector", f'.line[data-at="{at}"]')


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


def run_looks(*looks):
    """Calls each with a browser, the command and a folder. The exit status of a test that found their faults."""
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = start_browser(folder, webgl=True)
        try:
            for look in looks:
                found += look(browser, sys.argv[1], folder)
        finally:
            browser.quit()
    return outcome(found)
