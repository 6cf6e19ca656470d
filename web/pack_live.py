#!/usr/bin/env python3
"""Puts the module of live reports where reports take it from: pack_live.py BUILD OUT.

BUILD is the folder in which `soms_live` was built, OUT is apps/report/web/dist. Writes live.txt, the module packed by gzip,
in base64; and live.sources, the sha256 of its sources and their names, as the compiler read them. The test report.live_hash
fails if one of them changed since.
"""
import base64
import gzip
import hashlib
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
RULES = "web/live.cmake"


def hash_of(root, names):
    digest = hashlib.sha256()
    for name in names:
        digest.update(name.encode() + b"\0" + (root / name).read_bytes() + b"\0")
    return digest.hexdigest()


def ninja(build, *words):
    return subprocess.run(["ninja", "-C", build, "-t", *words], check=True, capture_output=True, text=True).stdout


def sources(build):
    """Files of the repository that objects of the module were made of, by the dependencies that ninja keeps."""
    objects = [name for name in ninja(build, "inputs", "live.wasm").splitlines() if name.endswith(".o")]
    names = {RULES}
    for line in ninja(build, "deps", *objects).splitlines():
        file = (build / line.strip()).resolve()
        if line.startswith(" ") and file.is_relative_to(ROOT) and not file.is_relative_to(build):
            names.add(str(file.relative_to(ROOT)))
    return sorted(names)


def main():
    build, out = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    names = sources(build)
    if len(names) < 2:
        sys.exit(f"{build}: soms_live is not built here")
    packed = gzip.compress((build / "live.wasm").read_bytes(), 9, mtime=0)
    (out / "live.txt").write_text(base64.b64encode(packed).decode("ascii"), encoding="ascii")
    (out / "live.sources").write_text("\n".join([f"sha256 {hash_of(ROOT, names)}", *names]) + "\n", encoding="ascii")
    print(f"{out / 'live.txt'}: {(out / 'live.txt').stat().st_size:,} bytes, made of {len(names)} files")


if __name__ == "__main__":
    main()
