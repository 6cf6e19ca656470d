"""What a notebook shows, in Chromium: the page draws in a frame that sees nothing of what is around it.

Needs what tests/support/browser.py needs; where it is missing the test says so and is skipped.
"""
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import soms
from browser import start_browser
from models import tetrahedron

DRAWN = """
const done = arguments[0];
const look = () => {
  const picture = window.soms?.firstPicture?.();
  picture ? done(picture.triangles) : requestAnimationFrame(look);
};
look();
"""
# The notebook's document is of another origin to a frame in a sandbox.
SEES_OUT = "try { return window.parent.document.title; } catch (error) { return null; }"


def check(browser, path):
    browser.get(path.as_uri())
    browser.switch_to.frame(browser.find_element("tag name", "iframe"))
    triangles = browser.execute_async_script(DRAWN)
    browser.find_element("id", "next").click()
    browser.find_element("css selector", 'a[href="#gap=0"]').click()
    found = {"draws": triangles > 0, "sees": browser.execute_script(SEES_OUT),
             "row": browser.execute_script("return window.soms.rows"),
             "gap": browser.execute_script("return window.soms.chosenGap()"),
             "errors": [entry["message"] for entry in browser.get_log("browser")
                        if entry["level"] == "SEVERE"]}
    wanted = {"draws": True, "sees": None, "row": 1, "gap": 0, "errors": []}
    if found != wanted:
        sys.exit(f"the frame shows {found}, not {wanted}")


def main():
    scene = soms.Scene()
    scene.add_environment(soms.Body(tetrahedron(), name="still"))
    for x in (0.5, 3):
        scene.add_mover(soms.Body(tetrahedron(), [x, 0, 0], f"mover at {x}"))
    page = soms.Page(scene, scene.step(clearance=1.5))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = folder / "notebook.html"
        path.write_text(f"<!DOCTYPE html><title>secret</title><p>A cell</p>{page._repr_html_()}",
                        encoding="utf-8")
        browser = start_browser(folder, webgl=True)
        try:
            check(browser, path)
        finally:
            browser.quit()
    print("a frame draws, and sees nothing of the notebook")


if __name__ == "__main__":
    main()
