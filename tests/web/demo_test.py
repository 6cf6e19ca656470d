"""The demonstration page in a headless Chromium, by mouse, keys and files: demo_test.py DEMO DATA [SOMS].

What it shows must be what the command SOMS answers for the pose that it shows; without SOMS that part is left out, aloud.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import browser_test

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import look  # noqa: E402

FILES = ("meshes/ball.ply", "meshes/box2.ply")
ON_BODY = """
  const [wanted, done] = arguments;
  (async () => {
    const canvas = document.getElementById('picture'), {width, height} = canvas.getBoundingClientRect();
    for (let y = 0.1; y < 0.95; y += 0.02) {
      for (let x = 0.3; x < 0.95; x += 0.02) {
        if ((await demo.sees(2 * x - 1, 1 - 2 * y)) === wanted) {
          const inside = await demo.sees(2 * x - 1 + 0.03, 1 - 2 * y - 0.03);
          if (inside === wanted) return [Math.round(width * (x + 0.015) - width / 2), Math.round(height * (y + 0.015) - height / 2)];
        }
      }
    }
    return null;
  })().then(done);"""

# Pixels of the moved body's blue, of a contact's red, and at the place that was picked.
DRAWN = """
  const {width, height, bytes} = demo.pixels(), at = arguments[0], colors = {blue: 0, red: 0};
  for (let k = 0; k < bytes.length; k += 4) {
    colors.blue += bytes[k + 2] > 1.4 * bytes[k];
    colors.red += bytes[k] > 2.5 * bytes[k + 2];
  }
  const k = 4 * (width * Math.round(height / 2 - at[1]) + Math.round(width / 2 + at[0]));
  return {...colors, picked: bytes[k + 2] > 1.4 * bytes[k]};"""


class Demo:
    def __init__(self, browser, url):
        self.browser = browser
        browser.set_window_size(1200, 900)
        browser.get(url)
        self.settled()

    def run(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def wait(self, script):
        """Returns once the script says so; the browser looks at each frame."""
        self.browser.execute_async_script(
            "const done = arguments[0], holds = () => { %s };"
            "const look = () => (holds() ? done() : requestAnimationFrame(look)); look();" % script)

    def settled(self):
        """The answer, once it is that for where the body is."""
        self.wait("return Boolean(window.demo) && demo.state().settled")
        return self.run("const {count, gap, milliseconds} = demo.state(); return {count, gap, milliseconds};")

    def text(self, name):
        return self.run("return document.getElementById(arguments[0]).textContent", name)

    def place(self, what):
        """A place where the mouse is on that body, from the middle of the picture."""
        found = self.browser.execute_async_script(ON_BODY, what)
        assert found is not None, f"no place on {what}"
        return found

    def drag(self, what, by, shift=False):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.keys import Keys
        canvas = self.browser.find_element("id", "picture")
        before = self.text("pose")
        chain = ActionChains(self.browser)
        if shift:
            chain.key_down(Keys.SHIFT)
        chain.move_to_element_with_offset(canvas, *self.place(what)).click_and_hold().perform()
        self.wait("return demo.holds() !== null")
        ActionChains(self.browser).move_by_offset(by[0] // 2, by[1] // 2).move_by_offset(by[0] - by[0] // 2, by[1] - by[1] // 2).release().perform()
        if shift:
            ActionChains(self.browser).key_up(Keys.SHIFT).perform()
        self.settled()
        return before != self.text("pose")

    def exact_pose(self):
        return self.run("return document.getElementById('pose').title")

    def keys(self, *keys):
        self.browser.find_element("id", "picture").send_keys(*keys)
        return self.settled()


def by_command(command, data, pose):
    """Count of pairs and lower end of the distance, by the command."""
    files = [str(pathlib.Path(data) / name) for name in FILES]
    answers = [json.loads(subprocess.run([command, verb, files[1], files[0], "--pose", pose, "--json"], capture_output=True,
                                         text=True, check=True).stdout.splitlines()[0]) for verb in ("overlap", "distance")]
    return answers


def compare(demo, command, data):
    shown = demo.settled()
    if command is None:
        return shown
    overlap, distance = by_command(command, data, demo.exact_pose())
    assert shown["count"] == len(overlap["pairs"]), (shown, overlap)
    assert shown["gap"] == (0 if shown["count"] else distance["lower"]), (shown, distance)
    return shown


# By what is drawn: how many pixels differ from the sky at the left and right edges, and what the sky is; how far elements overlap.
LAYOUT = """
  const {width, height, bytes} = demo.pixels(), sky = [...bytes.slice(0, 3)];
  const differs = (x, y) => sky.some((c, k) => Math.abs(c - bytes[4 * (width * y + x) + k]) > 8);
  let edges = 0, drawn = 0;
  for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) {
    const on = differs(x, y);
    drawn += on;
    edges += on && (x < 2 || x >= width - 2);
  }
  const box = (name) => document.getElementById(name).getBoundingClientRect();
  const over = (a, b) => Math.max(0, Math.min(a.right, b.right) - Math.max(a.left, b.left))
                       * Math.max(0, Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
  return {edges, drawn, sky, covered: over(box('help'), box('bodies')) + over(box('help'), box('facts')),
          wide: document.documentElement.scrollWidth, below: box('help').bottom - window.innerHeight};"""


def check_phone(demo):
    """At 390 pixels nothing is cut or covered, and the colors are those of the one table, by the reader's scheme."""
    for scheme, dark in (("dark", 1), ("light", 0)):
        demo.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
        demo.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": True})
        demo.browser.refresh()
        demo.settled()
        seen = demo.run(LAYOUT)
        assert seen["edges"] == 0 and seen["drawn"] > 10000, seen
        assert seen["covered"] == 0 and seen["wide"] == 390 and seen["below"] <= 0, seen
        sky = look.colors()["sky-low"][dark]
        assert seen["sky"] == [int(sky[k:k + 2], 16) for k in (1, 3, 5)], (sky, seen)
    assert all(len(number) <= 9 for number in demo.text("pose").split()), demo.text("pose")
    demo.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    demo.browser.refresh()
    demo.settled()


def check_tree_file(demo, data):
    """A tree file dropped on the page: the same answers as of the model that it was made of."""
    model, zone = str(pathlib.Path(data) / FILES[0]), "document.querySelector('[data-body=moved]')"
    demo.browser.find_element("id", "moved").send_keys(model)
    demo.wait("return document.getElementById('moved-facts').textContent.startsWith('ball.ply')")
    before = demo.settled()
    made = demo.browser.execute_async_script("""
      const [url, done] = arguments;
      (async () => {
        const {start} = await import('soms/worker'), soms = await start();
        const input = document.getElementById('moved').files[0];
        const shape = await soms.shape(await soms.readMesh(await input.arrayBuffer(), input.name));
        const bytes = await shape.save(), box = new DataTransfer();
        box.items.add(new File([bytes], 'ball.somst'));
        %s.dispatchEvent(new DragEvent('drop', {dataTransfer: box, bubbles: true}));
        await soms.close();
        return bytes.length;
      })().then(done, (error) => done(String(error)));""" % zone, "")
    assert isinstance(made, int), made
    demo.wait("return document.getElementById('moved-facts').textContent.startsWith('ball.somst')")
    after = demo.settled()
    assert (after["count"], after["gap"]) == (before["count"], before["gap"]), (before, after)
    print(f"a tree file of {made} bytes: {after['count']} pairs, distance {after['gap']}")


def check(demo, data, command):
    from selenium.webdriver.common.keys import Keys
    # The samples are there at once, and are moved and turned by the mouse; the camera leaves the body alone.
    assert "50,000 triangles" in demo.text("fixed-facts") and "50,000 triangles" in demo.text("moved-facts")
    assert demo.settled()["count"] > 0
    drawn = demo.run(DRAWN, demo.place("moved"))
    assert drawn["picked"] and drawn["blue"] > 5000 and drawn["red"] > 100, drawn
    assert demo.drag("moved", (40, 12)) and demo.drag("moved", (25, -30), shift=True)
    assert not demo.drag(None, (30, 20))
    times = []
    for _ in range(30):
        times.append(demo.keys(Keys.ARROW_LEFT)["milliseconds"])
    print(f"bodies of 50,000 triangles: answers in {sorted(times)[15]:.1f} ms at the median, {max(times):.1f} at most")
    # A wrong file is an error in words, and what was there stays.
    broken = pathlib.Path(data) / "bad" / "3ds_chunk_huge.3ds"
    demo.browser.find_element("id", "moved").send_keys(str(broken))
    demo.wait("return !document.getElementById('error').hidden")
    assert len(demo.text("error")) > 20 and "50,000" in demo.text("moved-facts"), demo.text("error")
    # Files of one's own.
    for name, file in zip(("fixed", "moved"), FILES):
        demo.browser.find_element("id", name).send_keys(str(pathlib.Path(data) / file))
        demo.wait(f"return document.getElementById('{name}-facts').textContent.startsWith('{pathlib.Path(file).name}')")
    assert demo.run("return document.getElementById('error').hidden")
    seen = [compare(demo, command, data)]
    for _ in range(8):
        demo.keys(Keys.SHIFT, Keys.ARROW_LEFT, Keys.ARROW_UP, Keys.SHIFT)
        demo.keys(*[Keys.ARROW_LEFT] * 12)
        seen.append(compare(demo, command, data))
    demo.keys(Keys.HOME)
    demo.keys(*[Keys.ARROW_RIGHT] * 60)
    seen.append(compare(demo, command, data))
    counts = [answer["count"] for answer in seen]
    assert min(counts) == 0 and max(counts) > 0, seen
    assert all((answer["count"] == 0) == (answer["gap"] > 0) for answer in seen)
    check_tree_file(demo, data)
    check_phone(demo)
    print(f"{len(seen)} poses{'' if command else ', not compared: the command soms is not built'}: {counts} pairs")


def main(site, data, command=None):
    assert (pathlib.Path(site) / "colors.css").read_text(encoding="utf-8") == look.css(), "run tools/look.py css > web/demo/colors.css"
    with tempfile.TemporaryDirectory() as folder:
        browser = browser_test.start_browser(pathlib.Path(folder), webgl=True)
        try:
            check(Demo(browser, f"http://127.0.0.1:{browser_test.serve(site)}/index.html"), data, command or None)
        finally:
            browser.quit()


if __name__ == "__main__":
    main(*sys.argv[1:])
