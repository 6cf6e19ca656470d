"""The README's ten lines build against an installed soms and say what the command says.

    install_test.py SOURCE BUILD COMPILER [FLAG...]

Installs the build into a scratch prefix, moves it elsewhere, and builds the first C++ block of
README.md there with find_package(soms); without flags (those of a sanitizer) with pkg-config, too.
The programs beside the command, the manual and the words for the shell are found there.
"""
import pathlib
import sys
import tempfile

from outside import Models, by_cmake, by_pkg_config, install, readme_program, run


def check_command(prefix, build):
    """What the command needs lies under its own prefix; nothing else of the system is asked."""
    soms = prefix / "bin/soms"
    if (build / "bin/soms-view").exists():
        said = run(soms, "view", "--help", env={"PATH": "/nowhere"})
        if "Usage: soms view" not in said:
            sys.exit("soms view --help does not come from soms-view")
    for name in ("man/man1/soms.1", "man/man1/soms-overlap.1",
                 "bash-completion/completions/soms", "doc/soms/README.md"):
        if not (prefix / "share" / name).exists():
            sys.exit(f"share/{name} is not installed")


def main():
    source, build, compiler = map(pathlib.Path, sys.argv[1:4])
    flags = " ".join(sys.argv[4:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = install(build, folder / "moved")
        check_command(prefix, build)
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
