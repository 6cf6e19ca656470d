"""The wheel of the Python package works on a bare Debian 12 that has python3 and numpy, in a new environment.

    wheel_bare_test.py WHEELS WORK

WHEELS is a folder that holds the wheel, WORK one for bare Debians. Skipped, aloud and with exit
status 77, where there is no wheel or debootstrap cannot run. Takes minutes: part of `make bare`.
"""
import pathlib
import shutil
import sys

from bare_debian import BareDebian, skip, why_impossible
from deb_test import PYTHON, check_python

ENVIRONMENT = "/root/environment"


def main():
    wheels = sorted(pathlib.Path(sys.argv[1]).glob("soms-*.whl"))
    if not wheels:
        skip(f"no wheel in {sys.argv[1]}; make python makes one")
    why_not = why_impossible()
    if why_not:
        skip(why_not)
    debian = BareDebian(pathlib.Path(sys.argv[2]).resolve())
    debian.run("apt-get", "update", "-q")
    debian.run("apt-get", "install", "-y", "-q", "--no-install-recommends", "python3", "python3-numpy",
               "python3-venv")
    wheel = wheels[-1]
    shutil.copy(wheel, debian.root / "root")
    debian.run("python3", "-m", "venv", "--system-site-packages", ENVIRONMENT)
    debian.run(f"{ENVIRONMENT}/bin/python", "-m", "pip", "install", "-q", "--no-index", "--no-deps",
               f"/root/{wheel.name}")
    said = debian.run(f"{ENVIRONMENT}/bin/python", "-B", "-c", PYTHON).stdout
    print(f"{check_python(said)}, by {wheel.name} of {wheel.stat().st_size} bytes")
    debian.remove()


if __name__ == "__main__":
    main()
