"""Each line of tests/long.txt names tests that there are: a test that was renamed would go back to `make test`.

usage: long_test.py ROOT BUILD
"""
import pathlib
import re
import subprocess
import sys


def main():
    root, build = sys.argv[1:]
    listed = subprocess.run(["ctest", "-N"], cwd=build, capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^ +Test +#\d+: (\S+)", listed, re.MULTILINE)
    lines = [line for line in (pathlib.Path(root) / "tests/long.txt").read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    idle = [line for line in lines if not any(re.search(line, name) for name in names)]
    for line in idle:
        print(f"tests/long.txt: no test is named {line}")
    print(f"{len(names)} tests, {len(lines)} lines, {len(idle)} faults")
    return 1 if idle or not lines or not names else 0


if __name__ == "__main__":
    sys.exit(main())
