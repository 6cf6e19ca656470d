"""A page that uses the package, in a production build of vite, webpack and esbuild, each opened in a headless Chromium.

    bundlers_test.py PACKAGE FOLDER ROOT

The bundlers come by npm into FOLDER. Vite and webpack run as they are, without any configuration; esbuild by the command
that ROOT's docs/web.md prints.
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

from browser_test import serve
from npm_tools import HERE, bring, node, skip

sys.path.insert(0, str(HERE.parent / "support"))
from browser import start_browser  # noqa: E402

NODE = (20, 19)  # the bundlers need it
PAGE = '<!doctype html><meta charset="utf-8"><title>soms</title><link rel="icon" href="data:,"><script type="module" src="{}"></script>\n'
TRIANGLE = [0, 0, 0, 1, 0, 0, 0, 1, 0]


def commands(root):
    """Script and page of each bundler, as words for node."""
    esbuild = re.search(r"^npx (esbuild .*?[^\\])$", (root / "docs" / "web.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert esbuild, "docs/web.md prints no command of esbuild"
    words = shlex.split(esbuild.group(1).replace("\\\n", " "))
    return {"vite": (["vite/bin/vite.js", "build"], "./page.js"),
            "webpack": (["webpack-cli/bin/cli.js", "--mode", "production", "--entry", "./page.js"], "./main.js"),
            "esbuild": (["esbuild/bin/esbuild", *words[1:]], "./page.js")}


def bundled(folder, name, words, script):
    """The folder that a server serves: what the bundler made of the page."""
    project = folder / "bundlers" / name
    shutil.rmtree(project, ignore_errors=True)
    project.mkdir(parents=True)
    shutil.copy(HERE / "bundlers" / "page.js", project)
    (project / "package.json").write_text('{"private": true, "type": "module"}\n', encoding="utf-8")
    if name == "vite":
        (project / "index.html").write_text(PAGE.format(script), encoding="utf-8")
    done = node(project, folder / "node_modules" / words[0], *words[1:])
    assert done.returncode == 0, f"{name}: {done.stdout}{done.stderr}"
    site = project / "dist"
    if name != "vite":
        (site / "index.html").write_text(PAGE.format(script), encoding="utf-8")
    return site


def faults(name, outcome, log, site):
    """What differs from what the page must say, and from the three files that it takes."""
    count = {suffix: len(list(site.rglob(suffix))) for suffix in ("*.js", "*.wasm")}
    if count != {"*.js": 2, "*.wasm": 1}:
        yield f"{name}: {count}, not the page's script, the worker's, and one module"
    if "failure" in outcome:
        yield f"{name}: {outcome['failure']}"
        return
    wanted = {"turns": 1, "triangles": 12, "upper": [1, 1, 1], "refused": "SomsError usage", "memory": True,
              "freed": "SomsError usage: this Shape was freed", "parts": [TRIANGLE, TRIANGLE], "there": outcome["here"]}
    for key, value in wanted.items():
        if outcome[key] != value:
            yield f"{name}: {key} is {outcome[key]}, not {value}"
    if len(outcome["here"]) == 0:
        yield f"{name}: the boxes do not touch"
    yield from (f"{name}: {entry['message']}" for entry in log if entry["level"] == "SEVERE")


def main(package, folder, root):
    version = subprocess.run(["node", "--version"], capture_output=True, text=True, check=True).stdout
    if tuple(map(int, version.strip("v\n").split(".")[:2])) < NODE:
        skip(f"bundlers need node {NODE[0]}.{NODE[1]}; this is {version.strip()}")
    folder = bring(folder, package)
    found = []
    with tempfile.TemporaryDirectory() as profile:
        browser = start_browser(pathlib.Path(profile))
        try:
            for name, (words, script) in commands(pathlib.Path(root)).items():
                site = bundled(folder, name, words, script)
                browser.get(f"http://127.0.0.1:{serve(site)}/index.html")
                outcome = browser.execute_async_script(
                    "const done = arguments[0], failed = (what) => done({failure: String(what)});"
                    "window.outcome ? window.outcome.then(done, failed) : failed('the page has no outcome');")
                wrong = list(faults(name, outcome, browser.get_log("browser"), site))
                found += wrong
                files = sorted(f"{file.relative_to(site)} {file.stat().st_size:,}" for file in site.rglob("*") if file.is_file())
                print(f"{name}: {'differs' if wrong else 'as it must be'}; {', '.join(files)} bytes")
        finally:
            browser.quit()
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
