"""Folders that hold a bare Debian 12, and commands run in them as on a machine of their own.

Made by debootstrap from the host's own sources of packages. What the commands mount is seen by them
alone and ends with them.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77  # the exit status that ctest counts as skipped
SUITE = "bookworm"


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(SKIPPED)


def why_impossible():
    """What keeps debootstrap from running here, or None."""
    if os.geteuid() != 0:
        return "debootstrap needs root"
    for tool in ("debootstrap", "apt-get", "unshare", "chroot"):
        if shutil.which(tool) is None:
            return f"{tool} is not installed"
    if subprocess.run(["unshare", "--mount", "--pid", "--fork", "true"], check=False,
                      capture_output=True).returncode != 0:
        return "this system lets nobody unshare mounts"
    if not sources():
        return f"the host has no sources of Debian's {SUITE}"
    return None


def sources():
    """Addresses and suites of Debian's packages, as the host's apt has them."""
    listed = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(REPO_URI) $(CODENAME) $(COMPONENT)",
         "Created-By: Packages"], check=False, capture_output=True, text=True).stdout
    rows = {tuple(line.split()) for line in listed.splitlines() if line.count(" ") == 2}
    return sorted(row for row in rows if row[1].split("-")[0] == SUITE and row[2] == "main")


def settings_of_acquire():
    """How the host's apt fetches: proxies, and dates that it lets pass."""
    dump = subprocess.run(["apt-config", "dump", "Acquire"], check=True, capture_output=True,
                          text=True).stdout
    wanted = ("Acquire::http", "Acquire::https", "Acquire::Check-", "Acquire::Max-ValidTime")
    return "".join(f"{line}\n" for line in dump.splitlines()
                   if line.startswith(wanted) and not line.endswith('"";'))


class BareDebian:
    """A folder with a bare Debian. `base` is made where it is missing and kept for the next."""

    def __init__(self, work, packages=()):
        self.work = pathlib.Path(work)
        self.work.mkdir(parents=True, exist_ok=True)
        base = self.work / "base"
        if not (base / "made").exists():
            self._make(base)
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="debian-", dir=self.work))
        subprocess.run(["cp", "-a", "--reflink=auto", f"{base}/.", self.root], check=True)
        if packages:
            self.run("apt-get", "install", "-y", "-q", "--no-install-recommends", *packages)

    def _make(self, base):
        shutil.rmtree(base, ignore_errors=True)
        mirror = next(address for address, suite, _ in sources() if suite == SUITE)
        print(f"debootstrap {SUITE} {base}", flush=True)
        with open(self.work / "debootstrap.log", "w", encoding="utf-8") as log:
            done = subprocess.run(["debootstrap", "--variant=minbase", SUITE, base, mirror],
                                  check=False, stdout=log, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            sys.exit(f"debootstrap: exit {done.returncode}; see {log.name}")
        rows = "".join(f"deb {address} {suite} {part}\n" for address, suite, part in sources())
        (base / "etc/apt/sources.list").write_text(rows, encoding="utf-8")
        (base / "etc/apt/apt.conf.d/90host").write_text(settings_of_acquire(), encoding="utf-8")
        for name in ("resolv.conf", "hosts"):
            shutil.copy(f"/etc/{name}", base / "etc" / name)
        self.root = base
        self.run("apt-get", "update", "-q")
        (base / "made").touch()

    def run(self, *command, log=None, check=True):
        """Runs a command in the folder; returns what is left of its output, and its status."""
        mounts = ('mount -t devpts devpts "$0/dev/pts" -o newinstance,ptmxmode=0666,mode=620 && '
                  'mkdir -p "$0/dev/shm" && mount -t tmpfs tmpfs "$0/dev/shm" && '
                  'exec chroot "$0" "$@"')
        words = ["unshare", "--mount", "--pid", "--fork", "--kill-child",
                 f"--mount-proc={self.root}/proc", "sh", "-c", mounts, self.root, "env", "-i",
                 "HOME=/root", "TERM=dumb", "LANG=C.UTF-8", "DEBIAN_FRONTEND=noninteractive",
                 "PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin", *command]
        out = subprocess.PIPE if log is None else log
        done = subprocess.run([str(word) for word in words], check=False, stdout=out,
                              stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True)
        if check and done.returncode != 0:
            print((done.stdout or "")[-3000:])
            sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode} in {self.root}")
        return done

    def remove(self):
        shutil.rmtree(self.root)
