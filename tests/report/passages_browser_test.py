"""The page of a swept simulation, opened in Chromium: a passage is a row, and the mover stands at its moment."""
import pathlib
import subprocess
import sys

from look import DESK, Look, in_sight, lines, run_looks
from browser import console_faults

WALL = "OFF\n3 1 0\n5 -9 -9\n5 9 -9\n5 0 9\n3 0 1 2\n"
ROUTE = "x,y,z,qw,qx,qy,qz\n" + "".join(f"{x},0,0,1,0,0,0\n" for x in (0, 2, 12, 14))


def passage_faults(browser, soms, folder):
    (folder / "wall.off").write_text(WALL, encoding="utf-8")
    (folder / "route.csv").write_text(ROUTE, encoding="utf-8")
    subprocess.run([soms, "generate", "car", "-o", folder / "car.ply"], check=True, capture_output=True)
    page_file = folder / "swept.html"
    subprocess.run([soms, "simulate", folder / "wall.off", "--mover", folder / "car.ply", "--route", folder / "route.csv",
                    "--swept", "-o", page_file, "--quiet"], check=True, capture_output=True)
    page = Look(browser, page_file, DESK)
    rows = lines(page, "pair")
    if len(rows) != 1 or "car 0 passed through wall" not in rows[0].text:
        yield f"the list has '{[row.text for row in rows]}'"
        return
    if "frame 1 + 0." not in rows[0].text:
        yield f"the row does not tell the moment: '{rows[0].text}'"
    in_sight(page, rows[0]).click()
    page.landed()
    step = page.soms("step()")
    if not 1 < step < 2:
        yield f"the time is {step}, not between frames 1 and 2"
    target = page.soms("target()")
    center = page.soms("center(0)")
    if max(abs(a - b) for a, b in zip(target, center)) > 1e-3:
        yield f"the camera looks at {target}, not at the passage at {center}"
    if page.picture()["contact"] < 20:
        yield "the place of the passage is not marked"
    # Of the way from 2 to 12; the car is a little over four meters long, and meets the wall at 5.
    if not 0.02 < step - 1 < 0.3:
        yield f"the car meets the wall at {step - 1} of the way"
    yield from console_faults(browser)


if __name__ == "__main__":
    sys.exit(run_looks(passage_faults))
