"""What `npm pack` makes of the package: the files that belong into it, and no more than 475 kB.

Then the package is unpacked into the node_modules of a project, which loads it by its name: pack_test.py PACKAGE.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

MOST_BYTES = 475_000
EXPECTED = {"LICENSE", "README.md", "package.json", "soms.wasm", "soms.js", "soms.d.ts", "worker.js", "worker.d.ts",
            "worker_names.js", "worker_thread.js", "module.js", "host.js", "node_thread.js", "errors.js", "answers.js", "arrays.js", "fields.js",
            "meshes.js", "motions.js", "pairs.js", "points.js", "rays.js"}
USER = """
import * as soms from "soms";
import { start } from "soms/worker";
await soms.load();
const shape = new soms.Shape({ vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0] });
const remote = await start();
const same = await remote.shape({ vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0] });
console.log(soms.overlap(shape, shape).any && (await remote.overlap(same, same)).any);
await remote.close();
"""


def main(package):
    if shutil.which("npm") is None:
        print("skipped: npm is not installed")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        made = subprocess.run(["npm", "pack", "--json", "--offline", "--pack-destination", folder,
                               pathlib.Path(package).resolve()],
                              capture_output=True, text=True, check=True)
        [facts] = json.loads(made.stdout)
        files = {file["path"] for file in facts["files"]}
        assert files == EXPECTED, files ^ EXPECTED
        assert facts["size"] <= MOST_BYTES, f"{facts['size']} bytes packed, more than {MOST_BYTES}"
        print(f"{facts['filename']}: {facts['size']} bytes packed, {facts['unpackedSize']} unpacked")
        modules = folder / "node_modules"
        modules.mkdir()
        shutil.unpack_archive(folder / facts["filename"], modules)
        (modules / "package").rename(modules / "soms")
        (folder / "user.mjs").write_text(USER, encoding="utf-8")
        ran = subprocess.run(["node", folder / "user.mjs"], capture_output=True, text=True)
        assert ran.returncode == 0 and ran.stdout.strip() == "true", ran.stdout + ran.stderr
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
