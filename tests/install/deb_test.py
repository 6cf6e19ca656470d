"""Debian packages of soms are made, installed, used, and removed without a trace.

    deb_test.py SOURCE BUILD WORK

BUILD is a finished build of the preset "package". In a bare Debian 12 under the folder WORK, apt
installs the packages with what they depend on; where debootstrap cannot run, they are unpacked
instead, which is said. Takes minutes: part of `make packages`.
"""
import pathlib
import shutil
import sys
import tempfile

from bare_debian import BareDebian, why_impossible
from outside import CONSUMER, readme_program, run

WANTED = {
    "libsoms0": ["/usr/lib/*/libsoms.so.0.*"],
    "libsoms-dev": ["/usr/include/soms/soms.h", "/usr/lib/*/cmake/soms/soms-config.cmake",
                    "/usr/lib/*/pkgconfig/soms.pc", "/usr/lib/*/libsoms.so"],
    "soms-view": ["/usr/libexec/soms/soms-view"],
    "soms": ["/usr/bin/soms", "/usr/libexec/soms/soms-reproduce", "/usr/share/man/man1/soms-overlap.1",
             "/usr/share/bash-completion/completions/soms", "/usr/share/doc/soms/docs/install.md"],
}
USE = """set -e; cd /tmp
soms generate knot --triangles 2000 -o knot.ply
soms generate sphere --triangles 800 -o ball.off
soms overlap knot.ply ball.off --pose '0.5 0 0' --json --no-pairs
"""
DEVELOP = """set -e; cd /tmp/consumer
soms generate city --triangles 5672 -o city.ply; soms generate car -o car.ply
cmake -S . -B build -DCONSUMER_SOURCE=$PWD/example.cpp && cmake --build build
g++ -std=c++20 catcher.cpp -o one-line $(pkg-config --cflags --libs soms)
./build/consumer | tail -1; ./build/catcher; ./one-line
"""
PYTHON = """import soms
car = soms.Body(soms.generate("car"), [10, 0, -2])
city = soms.Body(soms.generate("city", 5672))
answer = soms.overlap(car, city, threads=2)
assert "<html" in soms.Page([car, city], answer).html
print(len(answer.pairs), "pairs")
"""
DRAW = """set -e; cd /tmp
soms generate city --triangles 2000 -o town.ply
soms render town.ply -o town.png --size 320x200
"""


def make(build, folder):
    """The packages by name."""
    if (build / "bin/soms-import").exists():
        WANTED["soms-import"] = ["/usr/libexec/soms/soms-import", "/usr/libexec/soms/soms-import-ifc.mjs"]
    if list((build / "python/soms").glob("_soms.*.so")):
        WANTED["python3-soms"] = ["/usr/lib/python3/dist-packages/soms/_soms.*.so",
                                  "/usr/lib/python3/dist-packages/soms/__init__.py",
                                  "/usr/lib/python3/dist-packages/soms/_soms.pyi",
                                  "/usr/lib/python3/dist-packages/soms/py.typed"]
    run("cpack", "-G", "DEB", "-B", folder, cwd=build)
    packages = {run("dpkg-deb", "-f", deb, "Package").strip(): deb
                for deb in sorted(folder.glob("*.deb"))}
    for start, places in WANTED.items():
        found = [name for name in packages if name == start or start == "libsoms0"
                 and name.startswith(start)]
        if not found:
            sys.exit(f"no package {start}: {sorted(packages)}")
        lines = run("dpkg-deb", "-c", packages[found[0]]).splitlines()
        paths = [pathlib.PurePath(line.split()[5].lstrip(".")) for line in lines]
        for place in places:
            if not any(path.match(place) for path in paths):
                sys.exit(f"{found[0]} has no {place}")
        depends = run("dpkg-deb", "-f", packages[found[0]], "Depends").strip()
        print(f"{found[0]}: {len(paths)} paths; depends on {depends}", flush=True)
    return packages


def check_python(said):
    if not said.endswith(" pairs\n") or said.startswith("0 "):
        sys.exit(f"python3-soms says {said}")
    return f"python3-soms: {said.strip()}"


def answer_of(said):
    found = [line for line in said.splitlines() if '"overlap":true' in line]
    if len(found) != 1:
        sys.exit(f"no answer: {said}")
    return found[0]


def check_installed(packages, source, work):
    debian = BareDebian(work)
    debian.run("apt-get", "update", "-q")
    inside = debian.root / "var/tmp/packages"
    inside.mkdir()
    for deb in packages.values():
        shutil.copy(deb, inside)
    install = ["apt-get", "install", "-y", "-q", "--no-install-recommends"]
    command = [name for name in packages if name == "soms" or name.startswith("libsoms0")]
    debian.run(*install, *(f"/var/tmp/packages/{packages[name].name}" for name in command))
    print(answer_of(debian.run("sh", "-c", USE).stdout), flush=True)
    debian.run(*install, "g++", "cmake", "make", "pkg-config",
               *(f"/var/tmp/packages/{deb.name}" for deb in packages.values()))
    consumer = debian.root / "tmp/consumer"
    shutil.copytree(CONSUMER, consumer)
    (consumer / "example.cpp").write_text(readme_program(source), encoding="utf-8")
    said = debian.run("sh", "-c", DEVELOP).stdout.splitlines()
    if " touches " not in said[-4] or " apart" not in said[-3] or said[-2:] != ["caught cannot_open"] * 2:
        sys.exit(f"what the packages build says {said[-4:]}")
    if "python3-soms" in packages:
        print(check_python(debian.run("python3", "-B", "-c", PYTHON).stdout), flush=True)
    debian.run(*install, "libgl1-mesa-dri")
    debian.run("sh", "-c", DRAW)
    if not (debian.root / "tmp/town.png").read_bytes().startswith(b"\x89PNG"):
        sys.exit("soms-view drew no picture")
    debian.run("dpkg", "--verify", *packages)
    debian.run("apt-get", "purge", "-y", "-q", *packages)
    left = debian.run("find", "/usr", "/etc", "/opt", "/var/lib", "-xdev", "-iname", "*soms*").stdout
    if left:
        sys.exit(f"left behind: {left}")
    debian.remove()
    print("installed, built against, removed: nothing is left")


def check_unpacked(packages, folder):
    for deb in packages.values():
        run("dpkg-deb", "-x", deb, folder)
    run(folder / "usr/bin/soms", "--version")
    models = ["generate", "knot", "--triangles", "2000", "-o", folder / "knot.ply"]
    run(folder / "usr/bin/soms", *models)
    if "python3-soms" in packages:
        there = {"PYTHONPATH": str(folder / "usr/lib/python3/dist-packages"),
                 "LD_LIBRARY_PATH": str(next((folder / "usr/lib").glob("*/libsoms.so.0.*")).parent)}
        print(check_python(run("/usr/bin/python3", "-B", "-c", PYTHON, env=there)))
    print("unpacked: soms runs")


def main():
    source, build, work = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        packages = make(build, folder / "made")
        why_not = why_impossible()
        if why_not is None:
            check_installed(packages, source, work)
        else:
            print(f"SKIPPED: apt installs nothing here: {why_not}; packages are unpacked instead")
            check_unpacked(packages, folder / "root")


if __name__ == "__main__":
    main()
