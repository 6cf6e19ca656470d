"""soms as a part of another project: how it is compiled there, and what an uninstalled build says.

    subproject_test.py SOURCE BUILD COMPILER

A project that has soms by FetchContent is configured, with the settings of its users, and its compile_commands.json is read;
nothing is compiled. BUILD is a build folder of soms, which find_package must not take for an installed soms. The presets and
make's rules are read, too: warnings are errors where make is given WERROR=ON, as .ci/run does, and nowhere else.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from outside import CONSUMER

STRICT = "CMAKE_COMPILE_WARNING_AS_ERROR"
UNDERSTOOD = "the library is optimized as for Release"


class Projects:
    def __init__(self, source, compiler, folder):
        self.source, self.compiler, self.folder = source, compiler, folder
        self.count = 0
        (folder / "example.cpp").write_text("int main() {}\n", encoding="utf-8")
        # A launcher or flags of the environment would be settings of every project.
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith(("CMAKE_", "CXX"))}

    def configure(self, *settings):
        """Status, what CMake said, and the build folder of a project that has soms as its part."""
        self.count += 1
        build = self.folder / str(self.count)
        done = subprocess.run(
            ["cmake", "-S", str(CONSUMER), "-B", str(build), "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={self.compiler}",
             f"-DCONSUMER_SOURCE={self.folder / 'example.cpp'}", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", *settings],
            check=False, capture_output=True, text=True, env=self.environment)
        return done.returncode, " ".join((done.stdout + done.stderr).split()), build

    def commands(self, *settings):
        """What CMake said, the commands that compile the library, and those that compile the user's program."""
        status, said, build = self.configure(f"-DCONSUMER_FETCHES={self.source}", *settings)
        if status != 0:
            sys.exit(f"{settings}: {said[-3000:]}")
        cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
        if not any("CMAKE_BUILD_TYPE" in word for word in settings) and "CMAKE_BUILD_TYPE:STRING=\n" not in cache:
            sys.exit(f"{settings}: soms sets the build type of a project that is not its own")
        every = [row["command"] for row in json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))]
        library = [command for command in every if "soms.dir/" in command or "soms_thesis.dir/" in command]
        user = [command for command in every if "verify_interface" not in command and command not in library]
        if len(library) < 20 or len(user) != 4:
            sys.exit(f"{settings}: {len(library)} files of the library, {len(user)} of the program")
        return said, library, user


def has(commands, flag):
    return [flag in command.split() for command in commands]


def optimization(projects):
    """Without a build type the library is optimized, and CMake says so; what users set is left alone."""
    said, library, user = projects.commands()
    if not all(has(library, "-O3")) or not all(has(library, "-DNDEBUG")):
        yield "without a build type the library is not compiled with -O3 -DNDEBUG"
    if UNDERSTOOD not in said:
        yield f"without a build type CMake does not say that {UNDERSTOOD}"
    if any(has(user, "-O3")) or any(has(user, "-DNDEBUG")):
        yield "without a build type the user's own files are optimized, too"
    if any("-Wconversion" in command for command in library):
        yield "a user compiles the library with the warnings of its developers"
    for settings, wanted in ((["-DCMAKE_BUILD_TYPE=Debug"], "-g"), (["-DCMAKE_CXX_FLAGS=-O1"], "-O1")):
        said, library, _ = projects.commands(*settings)
        if any(has(library, "-O3")) or not all(has(library, wanted)) or UNDERSTOOD in said:
            yield f"{settings}: the library is compiled with other flags"


def settings_of_users(projects):
    """Lots, strictness and a launcher are the user's to choose, and end where the library would not compile."""
    _, alone, _ = projects.commands("-DCMAKE_CXX_COMPILER_LAUNCHER=env", "-DCMAKE_UNITY_BUILD=ON")
    _, lots, _ = projects.commands("-DCMAKE_UNITY_BUILD=ON")
    _, plain, _ = projects.commands()
    if len(plain) > 0.75 * len(alone):
        yield f"{len(plain)} commands for the {len(alone)} files of the library: not in lots"
    if any("Unity/unity" in command for command in alone):
        yield "with a launcher files of the library are compiled in lots"
    if any("Unity/unity_0_cxx" in command for command in lots):
        yield "CMAKE_UNITY_BUILD puts files into lots that the library does not choose"
    _, library, user = projects.commands(f"-D{STRICT}=ON")
    if any(has(library, "-Werror")):
        yield "a user's strictness makes errors of the library's warnings"
    if not all(has(user, "-Werror")):
        yield "soms takes the strictness of a user's own files away"


def uninstalled(projects, build):
    """find_package on a build folder says what to do."""
    status, said, _ = projects.configure(f"-Dsoms_DIR={build}")
    for words in ("soms is built there, not installed", f"cmake --install {build} --prefix", "FetchContent"):
        if status == 0 or words not in said:
            yield f"find_package on a build folder: status {status}, without '{words}': {said[-800:]}"


def rules(source):
    """Warnings are errors where make is given WERROR=ON alone."""
    presets = json.loads((source / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]
    for preset in presets:
        if STRICT in preset.get("cacheVariables", {}):
            yield f"the preset {preset['name']} sets {STRICT}"
    if not re.search(r"^export WERROR=ON$", (source / ".ci" / "run").read_text(encoding="utf-8"), re.MULTILINE):
        yield ".ci/run does not export WERROR=ON"
    environment = {name: value for name, value in os.environ.items() if name not in {"MAKEFLAGS", "MFLAGS", "MAKELEVEL", "WERROR"}}
    for target in ("run", "build", "install", "test", "asan-library", "asan", "tsan", "tidy", "check"):
        for given in ("", "ON"):
            said = subprocess.run(["make", "-n", target, *(["WERROR=ON"] if given else [])], cwd=source, check=True,
                                  capture_output=True, text=True, env=environment).stdout.replace("\\\n", " ")
            strict = [STRICT + "=ON" in line for line in said.splitlines() if re.search(r"cmake --preset", line)]
            user = target in {"run", "build", "install"}
            if not strict or any(strict) != (target == "check" or (bool(given) and not user)):
                yield f"make {target} with WERROR={given}: {strict}"


def main():
    source, build, compiler = map(pathlib.Path, sys.argv[1:4])
    found = list(rules(source.resolve()))
    with tempfile.TemporaryDirectory() as name:
        projects = Projects(source.resolve(), compiler, pathlib.Path(name).resolve())
        for check in (optimization(projects), settings_of_users(projects), uninstalled(projects, build.resolve())):
            found += check
    print("\n".join(found))
    print(f"{len(found)} faults")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
