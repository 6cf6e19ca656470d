"""Programs outside the project that use an installed soms: the README's, and one that catches."""
import os
import pathlib
import re
import shlex
import subprocess
import sys

CONSUMER = pathlib.Path(__file__).resolve().parent / "consumer"


def run(*arguments, **options):
    done = subprocess.run([str(a) for a in arguments], check=False, capture_output=True, text=True,
                          **options)
    if done.returncode != 0:
        print(done.stdout[-3000:], done.stderr[-3000:])
        sys.exit(f"{' '.join(map(str, arguments[:3]))}: exit {done.returncode}")
    return done.stdout


def install(build, prefix):
    """Installs a build and moves what it installed, so that no path of the first place is right."""
    first = prefix.with_name(prefix.name + "-first")
    run("cmake", "--install", build, "--prefix", first)
    first.rename(prefix)
    return prefix


def readme_program(source):
    text = (source / "README.md").read_text(encoding="utf-8")
    found = re.search(r"```cpp\n(.*?)```", text, re.DOTALL)
    if found is None:
        sys.exit("README.md has no C++ block")
    return found.group(1)


class Models:
    """The models of the README in a folder, how many pairs the command finds in them, and their distance."""

    def __init__(self, folder, soms, program):
        self.folder = folder
        run(soms, "generate", "city", "--triangles", "5672", "-o", "city.ply", cwd=folder)
        run(soms, "generate", "car", "-o", "car.ply", cwd=folder)
        touching, apart = (shift.replace(",", " ") for shift in re.findall(r"translation\(([^)]*)\)", program))
        said = run(soms, "overlap", "car.ply", "city.ply", "--pose", touching, "--json", cwd=folder)
        self.count = int(re.search(r'"count":(\d+)', said).group(1))
        said = run(soms, "distance", "car.ply", "city.ply", "--pose", apart, "--json", cwd=folder)
        self.distance = float(re.search(r'"lower":([^,]+)', said).group(1))
        if self.count == 0:
            sys.exit("the README's models do not touch: nothing would be compared")

    def check(self, how, consumer, catcher, **environment):
        """`consumer` names the command's pairs, `catcher` catches soms::Error."""
        environment = {**os.environ, **environment}
        said = run(consumer, cwd=self.folder, env=environment)
        lines = [line for line in said.splitlines() if " touches " in line]
        if len(lines) != self.count:
            sys.exit(f"{how}: the program names {len(lines)} pairs, the command {self.count}")
        if not said.endswith(f": {self.distance:g} apart\n"):
            sys.exit(f"{how}: the program says {said.splitlines()[-1]!r}, the command {self.distance}")
        caught = run(catcher, cwd=self.folder, env=environment)
        if caught != "caught cannot_open\n":
            sys.exit(f"{how}: the program caught {caught!r}")
        print(f"{how}: {self.count} pairs, and errors are caught", flush=True)


def by_cmake(folder, program, compiler, *settings):
    """Builds both programs by the project in consumer/. Returns their paths."""
    folder.mkdir()
    (folder / "example.cpp").write_text(program, encoding="utf-8")
    run("cmake", "-S", CONSUMER, "-B", folder / "build", "-G", "Ninja",
        f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCONSUMER_SOURCE={folder / 'example.cpp'}",
        *settings)
    run("cmake", "--build", folder / "build")
    return folder / "build/consumer", folder / "build/catcher"


def by_pkg_config(folder, program, compiler, prefix):
    """Builds both programs by one line each, as pkg-config tells it. Returns their paths."""
    folder.mkdir()
    (folder / "example.cpp").write_text(program, encoding="utf-8")
    places = ":".join(str(place) for place in prefix.glob("lib*/**/pkgconfig"))
    flags = shlex.split(run("pkg-config", "--cflags", "--libs", "soms",
                            env={**os.environ, "PKG_CONFIG_PATH": places}))
    for name, file in (("consumer", folder / "example.cpp"), ("catcher", CONSUMER / "catcher.cpp")):
        run(compiler, "-std=c++20", file, "-o", folder / name, *flags)
    return folder / "consumer", folder / "catcher"
