"""R99: the wheel of `make python` loads in a clean environment, needs nothing but the libraries of C and
C++, and answers.

    wheel_test.py FOLDER

Exit status 77 where FOLDER holds no wheel.
"""
import pathlib
import subprocess
import sys
import tempfile
import zipfile

SYSTEM = {"linux-vdso.so.1", "libstdc++.so.6", "libm.so.6", "libgcc_s.so.1", "libc.so.6",
          "libpthread.so.0", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
WANTED = {"soms/__init__.py", "soms/_enums.py", "soms/_error.py", "soms/_page.py", "soms/_soms.pyi", "soms/py.typed"}
MOST_BYTES = 3_000_000
USE = """
import pathlib, soms
assert str(pathlib.Path(soms.__file__)).startswith({environment!r}), soms.__file__
car, city = soms.generate("car"), soms.generate("city", 5672)
answer = soms.overlap(soms.Body(car, [10, 0, -2]), city, threads=2)
print(len(answer.pairs), "pairs,", soms.__version__)
assert answer.any
assert "soms-scene" in soms.Page([car, city]).html
{dae}
"""
# COLLADA is read by a library that the wheel must bring.
DAE = """
try:
    soms.read_mesh(b"<?xml version='1.0'?><COLLADA version='1.4.1'></COLLADA>", name="x.dae")
except soms.Error as error:
    assert error.kind != "unsupported", error
"""


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, text=True,
                          stdout=subprocess.PIPE, **options).stdout


def check_contents(wheel, folder):
    """What is in it, and what its module is linked with."""
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
        missing = WANTED - names
        modules = [name for name in names if name.endswith(".so")]
        if missing or len(modules) != 1:
            sys.exit(f"{wheel.name} lacks {sorted(missing)}, has {modules}")
        module = pathlib.Path(archive.extract(modules[0], folder))
    linked = {pathlib.PurePath(line.split()[0]).name for line in run("ldd", module).splitlines()}
    if linked - SYSTEM:
        sys.exit(f"{module.name} needs {sorted(linked - SYSTEM)}")
    if wheel.stat().st_size > MOST_BYTES or not any(name.endswith("LICENSE.three") for name in names):
        sys.exit(f"{wheel.name} has {wheel.stat().st_size} bytes and {sorted(names)}")
    print(f"{wheel.name}: {wheel.stat().st_size} bytes, linked with {sorted(linked)}")


def check_loads(wheel, folder):
    """In an environment of its own, which sees numpy and pip of the system and nothing of this folder."""
    environment = folder / "environment"
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", environment)
    python = environment / "bin/python"
    run(python, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--force-reinstall",
        wheel)
    print(run(python, "-c", USE.format(environment=str(environment.resolve()), dae=DAE), cwd=folder,
              env={"PATH": "/usr/bin:/bin"}), end="")


def main():
    wheels = sorted(pathlib.Path(sys.argv[1]).glob("soms-*.whl"))
    if not wheels:
        print(f"skipped: no wheel in {sys.argv[1]}; make python makes one")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_contents(wheels[-1], folder)
        check_loads(wheels[-1], folder)


if __name__ == "__main__":
    main()
