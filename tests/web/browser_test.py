"""The package in a headless Chromium, served by a plain server: browser_test.py PACKAGE DATA.

500 rows of each truth set on the page, a tree file, and queries in a worker.
"""
import functools
import http.server
import json
import pathlib
import shutil
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from browser import start_browser  # noqa: E402

CASES = 500
PAGE = """<!doctype html><meta charset="utf-8"><title>soms</title><script type="module">
import * as soms from "/package/soms.js";
import { start } from "/package/worker.js";
import { checkTruth } from "/tests/truth.mjs";
const read = async (path) => new Uint8Array(await (await fetch(`/data/${path}`)).arrayBuffer());
window.outcome = (async () => {
  await soms.load();
  const truth = await checkTruth(soms, read, %d);
  const triangle = { vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0] };
  const file = new soms.Shape(triangle).save();
  const opened = soms.openShape(file, { check: "full" });
  const remote = await start();
  const shape = await remote.openShape(file);
  const inWorker = await remote.overlap(shape, shape);
  await remote.close();
  return { ...truth, opened: soms.overlap(opened, opened).any, worker: inWorker.any, set: soms.instructionSet() };
})();
</script>""" % CASES


def serve(folder):
    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server.server_address[1]


def main(package, data):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        site = folder / "site"
        site.mkdir()
        shutil.copytree(package, site / "package")
        shutil.copytree(data, site / "data")
        shutil.copytree(pathlib.Path(__file__).parent, site / "tests")
        (site / "index.html").write_text(PAGE, encoding="utf-8")
        browser = start_browser(folder)
        try:
            browser.get(f"http://127.0.0.1:{serve(site)}/index.html")
            outcome = browser.execute_async_script(
                "const done = arguments[0]; window.outcome.then(done, (error) => done({failure: String(error)}));")
        finally:
            browser.quit()
    assert "failure" not in outcome, outcome["failure"]
    assert not outcome["faults"], "\n".join(outcome["faults"][:20])
    assert outcome["opened"] is True and outcome["worker"] is True and outcome["set"] == "simd128", outcome
    assert outcome["sets"]["overlaps"] >= 4 * CASES, outcome["sets"]
    print(f"{outcome['checks']} checks in Chromium: {json.dumps(outcome['sets'])}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
