"""The types of the package, checked by TypeScript over a program that calls each function: types_test.py PACKAGE FOLDER.

TypeScript comes by npm once, into FOLDER; where the network is away the test says so and is skipped.
"""
import pathlib
import re
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).parent / "types"
NAMES = "import(process.argv[1]).then((soms) => console.log(Object.keys(soms).join(' ')))"


def prepare(package, folder):
    """The program with TypeScript and the package beside it; None where TypeScript cannot be had."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json", "tsconfig.json", "every.ts"):
        shutil.copy(HERE / name, folder)
    if not (folder / "node_modules" / "typescript" / "bin" / "tsc").exists():
        came = subprocess.run(["npm", "ci", "--no-audit", "--no-fund"], cwd=folder, capture_output=True, text=True)
        if came.returncode != 0:
            print(f"skipped: npm brings no TypeScript: {came.stderr.strip().splitlines()[-1:]}")
            return False
    shutil.rmtree(folder / "node_modules" / "soms", ignore_errors=True)
    shutil.copytree(package, folder / "node_modules" / "soms")
    return True


def main(package, folder):
    if shutil.which("npm") is None:
        print("skipped: npm is not installed")
        return 77
    folder = pathlib.Path(folder)
    if not prepare(pathlib.Path(package).resolve(), folder):
        return 77
    program = (folder / "every.ts").read_text(encoding="utf-8")
    listed = subprocess.run(["node", "-e", NAMES, str(folder / "node_modules" / "soms" / "soms.js")],
                            capture_output=True, text=True, check=True)
    left_out = [name for name in listed.stdout.split() if not re.search(rf"\bsoms\.{name}\b", program)]
    assert not left_out, f"every.ts does not use {left_out}"
    checked = subprocess.run(["node", "node_modules/typescript/bin/tsc", "--project", "."], cwd=folder,
                             capture_output=True, text=True)
    assert checked.returncode == 0, checked.stdout + checked.stderr
    print(f"{len(listed.stdout.split())} names, checked by TypeScript")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
