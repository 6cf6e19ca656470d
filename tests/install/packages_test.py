"""Outside programs build against soms in every way it is offered, and are right.

    packages_test.py SOURCE STATIC SHARED COMPILER OTHER_COMPILER

STATIC and SHARED are finished builds of the library and the command. Installed and moved, each alone
and both together, they are used through CMake and through pkg-config, by the compiler that built
them and by another one; OTHER_COMPILER builds the project as a folder of its own, too. Takes minutes:
part of `make packages`.
"""
import pathlib
import re
import shutil
import sys
import tempfile

from exports import check_exports
from outside import Models, by_cmake, by_pkg_config, install, readme_program, run


class Outside:
    def __init__(self, folder, program, models):
        self.folder, self.program, self.models = folder, program, models
        self.count = 0

    def place(self):
        self.count += 1
        return self.folder / f"outside-{self.count}"

    def cmake(self, how, compiler, *settings):
        self.models.check(f"{how}, CMake, {compiler.name}",
                          *by_cmake(self.place(), self.program, compiler, *settings))

    def pkg_config(self, how, compiler, prefix):
        libraries = ":".join(str(file.parent) for file in prefix.rglob("libsoms.so"))
        self.models.check(f"{how}, pkg-config, {compiler.name}",
                          *by_pkg_config(self.place(), self.program, compiler, prefix),
                          LD_LIBRARY_PATH=libraries)


def kind_of(program):
    said = run("ldd", program)
    return "shared" if "libsoms.so" in said else "static"


def install_both(source, static, shared, folder):
    """Both kinds in one prefix. Builds agree on its folders then, so the static library goes into a
    build like the shared one that compiles nothing."""
    cache = (shared / "CMakeCache.txt").read_text(encoding="utf-8")
    libdir = re.search(r"^CMAKE_INSTALL_LIBDIR:\w+=(.*)$", cache, re.MULTILINE).group(1)
    again = folder / "static-again"
    run("cmake", "-S", source, "-B", again, "-G", "Ninja", f"-DCMAKE_INSTALL_LIBDIR={libdir}",
        "-DSOMS_BUILD_APPS=OFF", "-DSOMS_BUILD_VIEW=OFF", "-DSOMS_BUILD_IMPORT=OFF",
        "-DSOMS_BUILD_TESTS=OFF")
    for archive in ("libsoms.a", "libsoms-thesis.a"):
        shutil.copy(static / archive, again)
    prefix = folder / "both"
    run("cmake", "--install", again, "--prefix", prefix, "--component", "development")
    run("cmake", "--install", shared, "--prefix", prefix)
    return prefix


def check_choice(outside, prefix, compiler):
    """Where both kinds are installed, the consumer chooses."""
    for settings, kind in (([], "shared"), (["-DBUILD_SHARED_LIBS=OFF"], "static"),
                           (["-DBUILD_SHARED_LIBS=ON"], "shared"),
                           (["-DCONSUMER_COMPONENTS=static"], "static"),
                           (["-DCONSUMER_COMPONENTS=shared"], "shared")):
        said = kind_of(by_cmake(outside.place(), outside.program, compiler,
                                f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_CXX_FLAGS=-O0",
                                *settings)[0])
        if said != kind:
            sys.exit(f"{settings or 'no word'} gives the {said} library, not the {kind} one")
    print("both kinds in one place: chosen as requested", flush=True)


def check_core(source, folder, compiler):
    """The core alone, as a folder of a project on a system that has none of the other libraries."""
    missing = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in ("fmt", "pugixml", "nlohmann_json", "TBB")]
    run("cmake", "-S", CONSUMER, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
        f"-DCONSUMER_FOLDER={source}", "-DSOMS_CORE_ONLY=ON", "-DSOMS_USE_TBB=OFF", "-DCMAKE_CXX_FLAGS=-O1", *missing)
    run("cmake", "--build", folder)
    said = run(folder / "core", cwd=folder)
    if said != "touches\n":
        sys.exit(f"core: the program says {said!r}")
    print("core: built without any other library", flush=True)


def main():
    source, static, shared = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    compiler, other = map(pathlib.Path, sys.argv[4:6])
    compilers = [compiler, other]
    if shutil.which(str(other)) is None:
        print(f"SKIPPED: {other} is not installed; all is built by {compiler} alone")
        compilers = [compiler]
    check_exports(shared / "libsoms.so")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefixes = {"static": install(static, folder / "static"),
                    "shared": install(shared, folder / "shared")}
        program = readme_program(source)
        outside = Outside(folder, program,
                          Models(folder, prefixes["shared"] / "bin/soms", program))
        for kind, prefix in prefixes.items():
            for one in compilers:
                # A shared library brings what it needs: its users have neither fmt nor TBB to find.
                alone = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON" for package in
                         ("fmt", "TBB", "pugixml", "nlohmann_json")] if kind == "shared" else []
                outside.cmake(kind, one, f"-DCMAKE_PREFIX_PATH={prefix}", *alone)
                outside.pkg_config(kind, one, prefix)
        both = install_both(source, static, shared, folder)
        check_choice(outside, both, compiler)
        outside.pkg_config("both", compiler, both)
        outside.cmake("add_subdirectory", compilers[-1], f"-DCONSUMER_FOLDER={source}",
                      "-DCMAKE_CXX_FLAGS=-O1")
        check_core(source, folder / "core", compiler)


if __name__ == "__main__":
    main()
