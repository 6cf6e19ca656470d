"""What the command says of IFC models with holes: ifc_by_command.py SOMS WEB_IFC. Skips (77) where the npm
package is not in the build."""

import json
import os
import pathlib
import subprocess
import sys

MODELS = pathlib.Path(__file__).resolve().parent.parent / "data" / "ifc"
LOST = ("elements with a shape of which web-ifc makes no triangles, not read: 1, "
        "the first IfcBeam 'B' (0000000000000000000003)")


def main():
    soms, package = sys.argv[1:]
    if not (pathlib.Path(package) / "package.json").is_file():
        print("web-ifc is not in the build: tools/install_web_ifc.sh installs it by npm")
        return 77

    def run(*words):
        environment = {**os.environ, "SOMS_WEB_IFC": package}
        return subprocess.run([soms, *words], env=environment, text=True, capture_output=True, check=True)

    faults = []
    for name in ("opening.ifc", "voiding.ifc"):
        rows = [json.loads(line) for line in run("clash", MODELS / name, "--json").stdout.splitlines()]
        clashes = [row for row in rows if "class" in row]
        if not rows or clashes:
            faults.append(f"{name}: {len(rows)} rows, {len(clashes)} clashes: {clashes}")
    for words in (["info"], ["info", "--json"]):
        text = run(*words, MODELS / "lost_void.ifc").stdout
        if LOST not in text:
            faults.append(f"lost_void.ifc: {' '.join(words)} does not say: {LOST}")
    print("\n".join(faults) or "holes are no bodies, and what they take whole is counted")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
