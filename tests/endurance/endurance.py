"""What takes too long for the suite: long runs, kills at random moments, disks that fill up.

usage: endurance.py SOMS [--frames N]

Prints a line for each check with what was measured; the exit status is 1 if one failed. What cannot
be tried here (no right to mount) is skipped aloud.
"""
import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

OLD = b"old"
failures = 0


def tell(name, good, measured):
    global failures
    failures += not good
    print(f"{'ok' if good else 'FAILED':8}{name}: {measured}", flush=True)


def run(words, **options):
    return subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False, **options)


def generate(soms, kind, triangles, path, *options):
    subprocess.run([soms, "generate", kind, "--triangles", str(triangles), "-o", path, *options], check=True)


def resident(pid):
    """Resident memory of a process in KiB."""
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        for line in status:
            if line.startswith("VmRSS:"):
                return int(line.split()[1])
    return 0


def memory_of_a_long_run(soms, folder, frames):
    """Resident memory over a run: after a tenth of it, and the most in the rest."""
    town = str(folder / "town.ply")
    generate(soms, "city", 20000, town, "--extent", "4000", "--streets", "bare")  # as docs/performance.md has it
    child = subprocess.Popen([soms, "simulate", town, "--count", "50", "--frames", str(frames),
                              "--record", str(folder / "run.somsrec"), "-q"],
                             stdout=subprocess.DEVNULL)
    seen = []
    while child.poll() is None:
        try:
            seen.append(resident(child.pid))
        except (OSError, ProcessLookupError):
            break
        time.sleep(0.2)
    early = max(seen[: max(1, len(seen) // 10)])
    # 4 bytes a frame for its time, and the log of contacts.
    tell(f"{frames} frames", child.wait() == 0 and max(seen) < early + 16 * frames // 1024 + 4096,
         f"{early} KiB in the first tenth, {max(seen)} KiB at most")


def verbs_that_write(models, target):
    knot, town = str(models / "knot.ply"), str(models / "town.ply")
    return {
        "generate": (["generate", "city", "--triangles", "2000000", "-o", f"{target}/a.obj"], ["a.obj"]),
        "convert": (["convert", knot, f"{target}/a.obj"], ["a.obj"]),
        "overlap": (["overlap", knot, town, "-o", f"{target}/p.html"], ["p.html"]),
        "simulate": (["simulate", town, "--count", "30", "--frames", "300",
                      "--record", f"{target}/r", "-o", f"{target}/e.csv", "-o", f"{target}/m.svg",
                      "-o", f"{target}/p.html"], ["r", "e.csv", "m.svg", "p.html"]),
        "reproduce": (["reproduce", "--quick", "--item", "table-3.1,figure-4.2", "-o", f"{target}/o",
                       "--report", f"{target}/p"], ["p"]),
    }


def whole_or_old(target, names, whole):
    """What stands in the folder and is neither the old file nor a whole new one, be it about to
    take the old one's place."""
    faults = []
    for path in sorted(p for p in target.rglob("*") if p.is_file()):
        name = str(path.relative_to(target))
        content = path.read_bytes()
        if path.suffix == ".part" and names and content[-40:] in whole.values():
            continue  # killed between its own name and that of the old file
        if name not in names:
            if path.suffix == ".part" or not content.endswith(b"\n") and path.suffix in (".csv", ".svg"):
                faults.append(name)
        elif content != OLD and content[-40:] != whole[name]:
            faults.append(name)
    return faults


def kills(soms, models, scratch, tries):
    """kill -9 at random moments: the old file or the new one is there, and nothing beside it."""
    chance = random.Random(12)
    for verb in verbs_that_write(models, scratch):
        def fresh():
            target = pathlib.Path(tempfile.mkdtemp(dir=scratch))
            words, names = verbs_that_write(models, target)[verb]
            for name in names:
                (target / name).write_bytes(OLD)
            return target, [soms, *words], names

        target, words, names = fresh()
        begin = time.monotonic()
        good = run(words).returncode == 0
        lasts = time.monotonic() - begin
        whole = {name: (target / name).read_bytes()[-40:] for name in names}
        shutil.rmtree(target)
        faults, new = [], 0
        for _ in range(tries):
            target, words, names = fresh()
            child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(chance.uniform(0, lasts))
            child.send_signal(signal.SIGKILL)
            child.wait()
            new += any((target / name).read_bytes() != OLD for name in names)
            faults += whole_or_old(target, names, whole)
            shutil.rmtree(target)
        tell(f"kill -9 of {verb}", good and not faults,
             f"{tries} times in {lasts:.1f} s, {new} had a new file, faults: {faults or 'none'}")


def mounted(place, options):
    return run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", str(place)]).returncode == 0


def full_and_read_only_disks(soms, models, scratch):
    place = pathlib.Path(tempfile.mkdtemp(dir=scratch))
    if not mounted(place, "size=64k"):
        print("skipped: a full disk and a read-only one: no right to mount here")
        return
    try:
        for verb, (words, names) in verbs_that_write(models, place).items():
            run(["find", str(place), "-mindepth", "1", "-delete"])
            for name in names:
                (place / name).write_bytes(OLD)
            full = run([soms, *words])
            left = [n for n in os.listdir(place) if n not in names and n != "o"]
            old = all((place / name).read_bytes() == OLD for name in names)
            tell(f"full disk, {verb}", full.returncode == 5 and b"No space left" in full.stderr and old
                 and not left, f"status {full.returncode}: {full.stderr.decode().strip()[-70:]}")
        run(["find", str(place), "-mindepth", "1", "-delete"])
        run(["mount", "-o", "remount,ro", str(place)])
        for verb, (words, names) in verbs_that_write(models, place).items():
            refused = run([soms, *words])
            tell(f"read-only disk, {verb}", refused.returncode == 5 and b"Read-only" in refused.stderr,
                 f"status {refused.returncode}: {refused.stderr.decode().strip()[-70:]}")
    finally:
        run(["umount", str(place)])


def main():
    options = argparse.ArgumentParser()
    options.add_argument("soms")
    options.add_argument("--frames", type=int, default=100_000)
    options.add_argument("--kills", type=int, default=20)
    given = options.parse_args()
    soms = str(pathlib.Path(given.soms).resolve())
    with tempfile.TemporaryDirectory(prefix="soms-endurance-") as scratch:
        models = pathlib.Path(scratch) / "models"
        models.mkdir()
        generate(soms, "knot", 200000, str(models / "knot.ply"))
        subprocess.run([soms, "generate", "urban-mixed", "-o", str(models / "town.ply")], check=True)
        full_and_read_only_disks(soms, models, scratch)
        kills(soms, models, scratch, given.kills)
        memory_of_a_long_run(soms, pathlib.Path(scratch), given.frames)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
