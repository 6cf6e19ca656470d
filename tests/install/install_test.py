"""The README's ten lines build against an installed soms and say what the command says.

Installs the build into a scratch prefix, extracts the first C++ block of README.md, builds it with
find_package(soms), and runs it on a generated city and car that are placed to touch.
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*arguments, **options):
    done = subprocess.run([str(a) for a in arguments], check=False, capture_output=True, text=True,
                          **options)
    if done.returncode != 0:
        print(done.stdout[-3000:], done.stderr[-3000:])
        sys.exit(f"{arguments[0]} {arguments[1]}: exit {done.returncode}")
    return done.stdout


def first_cpp_block(readme):
    found = re.search(r"```cpp\n(.*?)```", readme.read_text(encoding="utf-8"), re.DOTALL)
    if found is None:
        sys.exit("README.md has no C++ block")
    return found.group(1)


def main():
    source, build, compiler = map(pathlib.Path, sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("cmake", "--install", build, "--prefix", folder / "prefix")
        program = first_cpp_block(source / "README.md")
        (folder / "example.cpp").write_text(program, encoding="utf-8")
        run("cmake", "-S", source / "tests/install/consumer", "-B", folder / "build", "-G", "Ninja",
            f"-DCMAKE_PREFIX_PATH={folder / 'prefix'}", f"-DCMAKE_CXX_COMPILER={compiler}",
            f"-DCMAKE_CXX_FLAGS={' '.join(sys.argv[4:])}",
            f"-DCONSUMER_SOURCE={folder / 'example.cpp'}")
        run("cmake", "--build", folder / "build")

        soms = folder / "prefix/bin/soms"
        run(soms, "generate", "city", "--triangles", "5672", "-o", "city.ply", cwd=folder)
        run(soms, "generate", "car", "-o", "car.ply", cwd=folder)
        said = run(folder / "build/consumer", cwd=folder)
        shift = re.search(r"translation\(([^)]*)\)", program).group(1).replace(",", " ")
        command = run(soms, "overlap", "car.ply", "city.ply", "--pose", shift, "--json", cwd=folder)
        count = int(re.search(r'"count":(\d+)', command).group(1))
        lines = [line for line in said.splitlines() if " touches " in line]
        if len(lines) != count:
            sys.exit(f"the program names {len(lines)} pairs, the command {count}")
        print(f"the README's program builds and runs: {count} pairs")


if __name__ == "__main__":
    main()
