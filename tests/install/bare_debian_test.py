"""Both commands of the README work on a bare Debian 12 that has nothing but git and make.

    bare_debian_test.py SOURCE WORK [COMMAND...]

Clones SOURCE's last commit into a bare Debian under the folder WORK and runs the commands of the
README's first block of shell lines, or COMMANDs in their place. Skipped, aloud and with exit status
77, where debootstrap cannot run. The folder stays where a command fails; logs stay always.
"""
import pathlib
import re
import subprocess
import sys
import time

from bare_debian import BareDebian, skip, why_impossible


def commands_of(readme):
    block = re.search(r"```sh\n(.*?)```", readme.read_text(encoding="utf-8"), re.DOTALL)
    commands = re.findall(r"^(make \w+)", block.group(1) if block else "", re.MULTILINE)
    if commands != ["make run", "make test"]:
        sys.exit(f"README.md begins with other commands: {commands}")
    return commands


def main():
    source, work = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    commands = sys.argv[3:] or commands_of(source / "README.md")
    why_not = why_impossible()
    if why_not:
        skip(why_not)
    debian = BareDebian(work, ["git", "make"])
    debian.run("sh", "-c", "rm -rf /var/lib/apt/lists/*")  # as on a fresh system
    subprocess.run(["git", "-C", source, "bundle", "create", "-q", debian.root / "soms.bundle",
                    "HEAD"], check=True)
    debian.run("git", "clone", "-q", "/soms.bundle", "/root/soms")
    for number, command in enumerate(commands):
        path = work / f"{number}-{re.sub('[^a-z0-9]+', '-', command)[:40]}.log"
        print(f"{command}: {path}", flush=True)
        begin = time.monotonic()
        with open(path, "w", encoding="utf-8") as log:
            done = debian.run("sh", "-c", f"cd /root/soms && {command}", log=log, check=False)
        tail = path.read_text(encoding="utf-8", errors="replace").splitlines()[-15:]
        print("\n".join(f"  {line}" for line in tail))
        if done.returncode != 0:
            sys.exit(f"{command}: exit {done.returncode}; the folder {debian.root} is kept")
        print(f"{command}: {time.monotonic() - begin:.0f} s", flush=True)
    debian.remove()
    print(f"{len(commands)} commands work on a bare Debian 12")


if __name__ == "__main__":
    main()
