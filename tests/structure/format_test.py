"""Every C++ source of the project is as clang-format leaves it."""
import pathlib
import shutil
import subprocess
import sys

FOLDERS = ("soms", "apps", "thesis", "tests", "bench", "python")


def main():
    root = pathlib.Path(sys.argv[1])
    program = shutil.which("clang-format") or shutil.which("clang-format-14")
    if program is None:
        print("clang-format is missing: install the packages of section test")
        return 1
    files = [f for folder in FOLDERS for f in sorted((root / folder).rglob("*"))
             if f.suffix in {".h", ".cpp"}]
    failed = subprocess.run([program, "--dry-run", "-Werror", *map(str, files)], check=False,
                            capture_output=True, text=True)
    print(failed.stderr[-4000:])
    print(f"{len(files)} files")
    return failed.returncode


if __name__ == "__main__":
    sys.exit(main())
