"""The README's program builds against an installed soms and says what the command says.

    install_test.py SOURCE BUILD COMPILER [FLAG...]

Installs the build into a scratch prefix, moves it elsewhere, and builds the first C++ block of
README.md there with find_package(soms); without flags (those of a sanitizer) with pkg-config, too.
The programs beside the command, the manual and the words for the shell are found there. A component
that is not installed is refused, and CMake says why.
"""
import pathlib
import subprocess
import sys
import tempfile

from outside import CONSUMER, Models, by_cmake, by_pkg_config, install, readme_program, run


# Of a format that soms-import reads.
TRIANGLE_AC = """AC3Db
MATERIAL "" rgb 1 1 1  amb 0.2 0.2 0.2  emis 0 0 0  spec 0.5 0.5 0.5  shi 10  trans 0
OBJECT poly
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x0
mat 0
refs 3
0 0 0
1 0 0
2 0 0
kids 0
"""


def check_command(prefix, build, folder):
    """What the command needs lies under its own prefix; nothing else of the system is queried."""
    soms = prefix / "bin/soms"
    said = run(soms, "reproduce", "--help", env={"PATH": "/nowhere"})
    if "Usage: soms reproduce" not in said:
        sys.exit("soms reproduce --help does not come from soms-reproduce")
    if (build / "bin/soms-view").exists():
        said = run(soms, "view", "--help", env={"PATH": "/nowhere"})
        if "Usage: soms view" not in said:
            sys.exit("soms view --help does not come from soms-view")
    if (build / "bin/soms-import").exists():
        (folder / "triangle.ac").write_text(TRIANGLE_AC, encoding="utf-8")
        said = run(soms, "info", folder / "triangle.ac", "--json", env={"PATH": "/nowhere"})
        if '"triangles":1,' not in said:
            sys.exit(f"soms-import is not found, or does not read: {said}")
    for name in ("man/man1/soms.1", "man/man1/soms-overlap.1",
                 "bash-completion/completions/soms", "doc/soms/README.md"):
        if not (prefix / "share" / name).exists():
            sys.exit(f"share/{name} is not installed")


def check_missing_components(prefix, folder, compiler):
    """find_package says what to do about a component that is not installed."""
    shared = any(prefix.rglob("soms_shared.cmake"))
    missing, reason = (("static", "only the shared library is installed") if shared else
                       ("shared", "only the static library is installed; build soms with "
                                  "-D SOMS_SHARED=ON"))
    for component, expected in ((missing, reason), ("viewer", 'soms has no component "viewer"')):
        done = subprocess.run(
            ["cmake", "-S", CONSUMER, "-B", folder / f"without-{component}", "-G", "Ninja",
             f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_PREFIX_PATH={prefix}",
             f"-DCONSUMER_COMPONENTS={component}"], check=False, capture_output=True, text=True)
        if done.returncode == 0 or expected not in " ".join(done.stderr.split()):
            sys.exit(f"find_package(soms COMPONENTS {component}): status {done.returncode}, not "
                     f"'{expected}':\n{done.stderr}")
        print(f"find_package(soms COMPONENTS {component}): refused with its reason", flush=True)


def main():
    source, build, compiler = map(pathlib.Path, sys.argv[1:4])
    flags = " ".join(sys.argv[4:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = install(build, folder / "moved")
        check_command(prefix, build, folder)
        check_missing_components(prefix, folder, compiler)
        program = readme_program(source)
        models = Models(folder, prefix / "bin/soms", program)
        models.check("find_package(soms)", *by_cmake(
            folder / "cmake", program, compiler, f"-DCMAKE_PREFIX_PATH={prefix}",
            f"-DCMAKE_CXX_FLAGS={flags}"))
        if not flags:
            models.check("pkg-config soms", *by_pkg_config(
                folder / "pkg-config", program, compiler, prefix))


if __name__ == "__main__":
    main()
