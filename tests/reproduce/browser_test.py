"""The page of a run, opened in Chromium: nothing is fetched, nothing is broken, everything is seen."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import urllib.parse

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import console_faults, outcome, start_browser  # noqa: E402

ITEMS = "3.1,3.9,4.6,4.30,5.3,5.6"
PHONE = (390, 800)
DESK = (1200, 900)
A4 = (595.28, 841.89)  # points

# Pictures that are read when they come into sight: all of them now.
LOAD = """
document.querySelectorAll('details').forEach(d => d.open = true);
document.querySelectorAll('img').forEach(i => i.loading = 'eager');
const done = arguments[0];
Promise.all([...document.images].map(i => i.decode().catch(() => {}))).then(() => done());
"""

# Everything about the page that is to be judged, in one answer.
LOOK = """
document.querySelectorAll('details').forEach(d => d.open = true);
const box = e => { const r = e.getBoundingClientRect(); return [r.width, r.height]; };
const clipped = svg => {
  const page = svg.getBoundingClientRect();
  return [...svg.querySelectorAll('text')].filter(t => {
    const r = t.getBoundingClientRect();
    return r.left < page.left - 1 || r.right > page.right + 1 || r.top < page.top - 1 ||
           r.bottom > page.bottom + 1;
  }).map(t => t.textContent);
};
return {
  ids: [...document.querySelectorAll('[id]')].map(e => e.id),
  figures: Object.fromEntries([...document.querySelectorAll('figure')].map(f => {
    const svg = f.querySelector('svg');
    const image = f.querySelector('img');
    return [f.id, image ? {box: box(image), shapes: image.naturalWidth, clipped: []} :
                  {box: box(svg), shapes: svg.querySelectorAll('path,rect,circle').length,
                   clipped: clipped(svg)}];
  })),
  tables: Object.fromEntries([...document.querySelectorAll('table[id]')].map(t =>
    [t.id, {box: box(t), rows: t.tBodies[0].rows.length}])),
  links: [...document.querySelectorAll('a')].map(a => a.getAttribute('href')),
  wide: document.documentElement.scrollWidth - document.documentElement.clientWidth,
  paper: getComputedStyle(document.body).backgroundColor,
  ink: getComputedStyle(document.body).color,
};
"""


def light(color):
    """Brightness of "rgb(r, g, b)", 0 to 255."""
    numbers = color[color.index("(") + 1:color.index(")")].split(",")
    return sum(float(n) for n in numbers[:3]) / 3


def link_faults(look, folder):
    for target in look["links"]:
        parts = urllib.parse.urlparse(target)
        if parts.scheme or parts.netloc:
            yield f"link to {target} leaves the machine"
        elif parts.path and not (folder / urllib.parse.unquote(parts.path)).is_file():
            yield f"link to {target}: no such file"
        elif not parts.path and parts.fragment not in look["ids"]:
            yield f"link to {target}: no such part"


def content_faults(look, manifest):
    if len(set(look["ids"])) != len(look["ids"]):
        yield "an id stands twice"
    files = [f["file"] for item in manifest["items"] for f in item["files"]]
    figures = {"f-" + pathlib.Path(f).stem for f in files if f.endswith(".svg")}
    tables = {"t-" + pathlib.Path(f).stem for f in files if f.endswith(".csv")}
    if not figures or not tables:
        yield "the run made no figure or no table"
    if set(look["figures"]) != figures:
        yield f"figures differ from the run's: {set(look['figures']) ^ figures}"
    if not tables <= set(look["tables"]):
        yield f"tables are missing: {tables - set(look['tables'])}"
    for name, figure in look["figures"].items():
        if min(figure["box"]) < 50 or figure["shapes"] < 3:
            yield f"{name} is empty: {figure}"
        for words in figure["clipped"]:
            yield f"{name}: '{words}' is cut off"
    for name, table in look["tables"].items():
        if min(table["box"]) < 10 or table["rows"] == 0:
            yield f"{name} is empty: {table}"


def page_faults(browser, folder):
    """Looks at the page on a desk, in the dark, and on a phone."""
    manifest = json.loads((folder / "run.json").read_text(encoding="utf-8"))
    for scheme, size in (("light", DESK), ("dark", DESK), ("light", PHONE)):
        browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": scheme}]})
        browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": size[0], "height": size[1], "deviceScaleFactor": 1, "mobile": size == PHONE})
        browser.get((folder / "index.html").as_uri())
        browser.execute_async_script(LOAD)
        look = browser.execute_script(LOOK)
        where = f"{scheme}, {size[0]} pixels: "
        for fault in (*content_faults(look, manifest), *link_faults(look, folder)):
            yield where + fault
        if look["wide"] > 0:
            yield where + f"the page is {look['wide']} pixels too wide"
        if (light(look["paper"]) > light(look["ink"])) != (scheme == "light"):
            yield where + f"{look['ink']} on {look['paper']}"


def figure_faults(browser, folder):
    """Each figure alone, as the file that it is."""
    for file in sorted((folder / "figures").glob("*.svg")):
        browser.get(file.as_uri())
        root, faults = browser.execute_script(
            "return [document.documentElement.localName,"
            " document.getElementsByTagName('parsererror').length];")
        if root != "svg" or faults:
            yield f"{file.name} is no SVG"


def faults_of(browser, folder):
    yield from page_faults(browser, folder)
    yield from figure_faults(browser, folder)
    yield from console_faults(browser)


def pdf_faults(pdf):
    """The pages of the PDF: there are some, and all are A4."""
    pages = re.findall(rb"/Type /Page\b", pdf)
    boxes = re.findall(rb"/MediaBox \[([^]]*)\]", pdf)
    if not pdf.startswith(b"%PDF-") or not pages:
        yield "the PDF has no pages"
    if len(boxes) != len(pages):
        yield f"{len(pages)} pages, {len(boxes)} media boxes"
    for box in boxes:
        numbers = [float(number) for number in box.split()]
        if any(not abs(a - b) <= 0.5 for a, b in zip(numbers, (0, 0, *A4))):
            yield f"a page of the PDF is {numbers}"


def main():
    soms = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        browser = start_browser(folder)
        try:
            out = folder / "out"
            subprocess.run([soms, "reproduce", "--quick", "--quiet", "--item", ITEMS, "-o", out,
                            "--pdf", out / "thesis.pdf"],
                           check=True, stdout=subprocess.DEVNULL)
            found = list(faults_of(browser, out))
            found += pdf_faults((out / "thesis.pdf").read_bytes())
        finally:
            browser.quit()
    return outcome(found)


if __name__ == "__main__":
    sys.exit(main())
