"""On a processor with nothing beyond the x86-64 baseline, soms answers by its plain kernels.

    baseline_test.py SOMS

Runs the command under qemu's processor qemu64, which ends a program at any newer instruction, and
compares answers and costs with those of this machine. Skipped, aloud and with exit status 77,
without qemu or on another kind of processor.
"""
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import tempfile


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(77)


def say(words, folder, **environment):
    done = subprocess.run([str(word) for word in words], check=False, capture_output=True,
                          text=True, cwd=folder, env={**os.environ, **environment})
    return done.returncode, done.stdout, done.stderr


def main():
    soms = pathlib.Path(sys.argv[1]).resolve()
    qemu = shutil.which("qemu-x86_64-static") or shutil.which("qemu-x86_64")
    if platform.machine() != "x86_64":
        skip("this is no x86-64")
    if qemu is None:
        skip("qemu-x86_64-static is not installed (qemu-user-static)")
    baseline = [qemu, "-cpu", "qemu64", soms]
    ask = ["overlap", "knot.ply", "ball.off", "--pose", "0.5 0 0", "--json"]
    with tempfile.TemporaryDirectory() as folder:
        for model in (["knot", "--triangles", "2000", "-o", "knot.ply"],
                      ["sphere", "--triangles", "800", "-o", "ball.off"]):
            say([soms, "generate", *model], folder)
        status, _, error = say([*baseline, *ask], folder, SOMS_ISA="sse4")
        if status != 2 and status != 3 or "use one of scalar, or unset it" not in error:
            sys.exit(f"the emulated processor has more than plain kernels: {status}, {error}")
        here = say([soms, *ask], folder)
        there = say([*baseline, *ask], folder)
    if here[0] != 0 or '"count":' not in here[1]:
        sys.exit(f"no answer here: {here}")
    if there != here:
        sys.exit(f"here: {here}\nbaseline: {there}")
    print(f"{len(here[1])} bytes of answers, the same by plain kernels")


if __name__ == "__main__":
    main()
