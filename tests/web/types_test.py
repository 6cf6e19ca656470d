"""The types of the package, checked by TypeScript: types_test.py PACKAGE FOLDER ROOT.

Checked are programs that call each function, that hand over what three.js has by its real types, that know no browser, and
those that the package's README and ROOT's README.md and docs/web.md print. Tools come by npm into FOLDER.
"""
import pathlib
import re
import shutil
import sys

from npm_tools import HERE, bring, node

NAMES = "import(process.argv[1]).then((soms) => console.log(Object.keys(soms).join(' ')))"
# What printed programs use without a word.
DECLARED = """import type { BufferGeometry, Mesh } from 'three';
declare var carGeometry: BufferGeometry, cityGeometry: BufferGeometry, carMesh: Mesh, cityMesh: Mesh, mesh: Mesh;
declare var vertices: Float32Array, triangles: Uint32Array;
"""
CONFIGURATIONS = ("tsconfig.json", "tsconfig.bundler.json", "tsconfig.plain.json")


def printed(page):
    """The programs that a page prints."""
    found = re.findall(r"```js\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    assert found, f"{page} prints no program"
    return found


def prepare(package, folder, root):
    """Every program, in a folder from which node_modules is found."""
    programs = folder / "types"
    shutil.rmtree(programs, ignore_errors=True)
    shutil.copytree(HERE / "types", programs)
    (programs / "package.json").write_text('{"private": true, "type": "module"}\n', encoding="utf-8")
    texts = [text for page in (package / "README.md", root / "README.md", root / "docs" / "web.md") for text in printed(page)]
    for number, text in enumerate(texts):
        (programs / f"printed_{number}.ts").write_text(DECLARED + text, encoding="utf-8")
    return programs, len(texts)


def main(package, folder, root):
    package = pathlib.Path(package).resolve()
    folder = bring(folder, package)
    programs, count = prepare(package, folder, pathlib.Path(root))
    program = (programs / "every.ts").read_text(encoding="utf-8")
    listed = node(folder, "-e", NAMES, folder / "node_modules" / "soms" / "soms.js")
    assert listed.returncode == 0, listed.stderr
    left_out = [name for name in listed.stdout.split() if not re.search(rf"\bsoms\.{name}\b", program)]
    assert not left_out, f"every.ts does not use {left_out}"
    for configuration in CONFIGURATIONS:
        checked = node(programs, folder / "node_modules" / "typescript" / "bin" / "tsc", "--project", configuration)
        assert checked.returncode == 0, f"{configuration}: {checked.stdout}{checked.stderr}"
    print(f"{len(listed.stdout.split())} names and {count} printed programs, checked by TypeScript {len(CONFIGURATIONS)} times")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
