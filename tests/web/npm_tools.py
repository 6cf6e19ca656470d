"""What tests of the package take from npm: TypeScript, bundlers and three.js, by the versions of npm/package-lock.json.

They come once, into a folder of the build; where they cannot be had, a test says so and is skipped.
"""
import json
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
SKIPPED = 77


def skip(why):
    print(f"skipped: {why}")
    sys.exit(SKIPPED)


def bring(folder, package):
    """The folder, in whose node_modules the tools are, and the package of soms beside them."""
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    lock = (HERE / "npm" / "package-lock.json").read_text(encoding="utf-8")
    hosts = [name for name, one in json.loads(lock)["packages"].items() if "resolved" in one]
    assert not hosts, f"npm/package-lock.json names the registry of {hosts}"
    brought = folder / "brought.json"
    if not brought.exists() or brought.read_text(encoding="utf-8") != lock:
        if shutil.which("npm") is None:
            skip("npm is not installed")
        brought.unlink(missing_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / "npm" / name, folder)
        came = subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder,
                              capture_output=True, text=True)
        if came.returncode != 0:
            skip(f"npm brings no tools: {' '.join(came.stderr.split())[:200]}")
        brought.write_text(lock, encoding="utf-8")
    shutil.rmtree(folder / "node_modules" / "soms", ignore_errors=True)
    shutil.copytree(package, folder / "node_modules" / "soms")
    return folder


def node(folder, *words):
    """Runs a script of node there."""
    return subprocess.run(["node", *map(str, words)], cwd=folder, capture_output=True, text=True)
