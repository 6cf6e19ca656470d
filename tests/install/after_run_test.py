"""After `make run`, which builds the command alone, `make install` installs all of soms.

    after_run_test.py SOURCE BUILD COMPILER

In a copy of SOURCE: `make run`; `cmake --install` alone, which must copy nothing and name the one
command that is missing; `make install`; then that command and `cmake --install` once more, with the
same outcome. BUILD is a finished release build. The copy takes its objects from there, where it has
them, in place of compiling them again: what is tried is the rules, not the compiler.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from install_test import check_command

COMPILER = """#!/bin/sh
for word; do
  case $before in -o) object=$word ;; -MF) depends=$word ;; esac
  [ "$word" = -c ] && compiles=yes
  before=$word
done
if [ "$compiles" ] && [ -f "{build}/$object" ]; then
  [ -z "$depends" ] || echo "$object:" > "$depends"
  echo "$object" >> {taken}
  exec cp "{build}/$object" "$object"
fi
exec {compiler} "$@"
"""


class Copy:
    """A copy of the project in which nothing is built yet."""

    def __init__(self, source, build, compiler, folder):
        self.source, self.taken = folder / "soms", folder / "taken"
        shutil.copytree(source, self.source, ignore=lambda place, _: (
            {"build", ".git"} if pathlib.Path(place) == source else {"node_modules"}))
        # What is missing is not a test's to install.
        (self.source / "tools/install_packages.sh").write_text("#!/bin/sh\n", encoding="utf-8")
        wrapper = folder / "c++"
        wrapper.write_text(COMPILER.format(build=build, taken=self.taken, compiler=compiler),
                           encoding="utf-8")
        wrapper.chmod(0o755)
        self.environment = {name: value for name, value in os.environ.items()
                            if name not in {"MAKEFLAGS", "MFLAGS", "MAKELEVEL", "PREFIX", "DESTDIR"}}
        self.environment["CXX"] = str(wrapper)
        # With a launcher each file is compiled alone, as it was in BUILD then; this one does nothing.
        self.environment.pop("CMAKE_CXX_COMPILER_LAUNCHER", None)
        cache = (build / "CMakeCache.txt").read_text(encoding="utf-8")
        if re.search(r"^CMAKE_CXX_COMPILER_LAUNCHER:\w+=.|^SOMS_UNITE:\w+=OFF", cache, re.MULTILINE):
            self.environment["CMAKE_CXX_COMPILER_LAUNCHER"] = "/usr/bin/env"

    def say(self, *words):
        done = subprocess.run([str(word) for word in words], check=False, cwd=self.source,
                              env=self.environment, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout

    def do(self, *words):
        status, said = self.say(*words)
        if status != 0:
            sys.exit(f"{said[-3000:]}\n{' '.join(map(str, words))}: exit {status}")
        return said


def refused(copy, prefix):
    """The one command that `cmake --install` alone asks for, having copied nothing."""
    status, said = copy.say("cmake", "--install", "build/release", "--prefix", prefix)
    command = re.search(r"^ *(cmake --build \S+ --target soms_installed)$", said, re.MULTILINE)
    if status == 0 or prefix.exists() or "Nothing was installed" not in said or command is None:
        sys.exit(f"cmake --install before all is built: exit {status}, {said[-3000:]}")
    return command.group(1).split()


def check_thesis_is_named(copy):
    """What `make run` leaves out says how to get it."""
    for words in (["thesis"], ["thesis", "--help"], ["overlap", "a.ply", "b.ply", "--tree", "traversal=e-node"],
                  ["simulate", "--tree", "traversal=larger"]):
        status, said = copy.say("build/release/bin/soms", *words)
        if status != 3 or "make build" not in said:
            sys.exit(f"soms {' '.join(words)} without the thesis: exit {status}, {said[-3000:]}")


def main():
    source, build, compiler = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        copy = Copy(source, build, compiler, folder)
        copy.do("make", "run", "ARGS=--frames 1 --count 10")
        built = copy.source / "build/release"
        if (built / "manual").exists():
            sys.exit("make run builds all of soms: this test begins with the command alone")
        check_thesis_is_named(copy)
        refused(copy, folder / "early")
        copy.do("make", "install", "PREFIX=/opt/soms", f"DESTDIR={folder / 'root'}")
        check_command(folder / "root/opt/soms", built, folder)
        shutil.rmtree(built / "manual")
        (built / "bin/soms-view").unlink(missing_ok=True)
        copy.do(*refused(copy, folder / "later"))
        copy.do("cmake", "--install", "build/release", "--prefix", folder / "later")
        check_command(folder / "later", built, folder)
        installed = [sorted(path.relative_to(place) for path in place.rglob("*"))
                     for place in (folder / "root/opt/soms", folder / "later")]
        if installed[0] != installed[1] or not (folder / "later/include/soms/soms.h").exists():
            sys.exit("both ways to install differ, or leave the library out")
        taken = len(copy.taken.read_text(encoding="utf-8").splitlines())
        print(f"{len(installed[0])} paths installed, both ways; {taken} objects taken over")


if __name__ == "__main__":
    main()
