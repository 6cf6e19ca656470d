"""tools/install_packages.sh installs what is missing, and nothing that a program in PATH offers already.

    packages_list_test.py SOURCE

apt and dpkg are scripts of this test, in a PATH of its own: it changes nothing, and needs no network.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

LIST = """[web]
cmake
# a comment
nodejs or node
npm or npm
libfmt-dev

[other]
npm or npm
"""
NOTES = '#!/bin/sh\necho "$*" >> "{log}"\n'
# dpkg-query says that cmake is installed, and nothing else.
QUERY = '#!/bin/sh\nfor word; do last=$word; done\n[ "$last" = cmake ] && echo installed\n'
# Debian's npm beside node of another source.
CONFLICT = '#!/bin/sh\ncase "$*" in *" npm"*) exit 100;; esac\necho "$*" >> "{log}"\n'


class Machine:
    """A copy of the script with a list of its own, and the programs of a machine."""

    def __init__(self, source, folder, programs, apt=NOTES):
        self.folder, self.log = folder, folder / "log"
        (folder / "tools").mkdir(parents=True)
        (folder / "packages.txt").write_text(LIST, encoding="utf-8")
        shutil.copy(source / "tools" / "install_packages.sh", folder / "tools")
        self.path = folder / "bin"
        self.path.mkdir()
        for name in ("sh", "awk", "dirname", "env"):
            (self.path / name).symlink_to(shutil.which(name))
        self.write("id", "#!/bin/sh\necho 0\n")
        if apt:
            self.write("dpkg-query", QUERY)
            self.write("apt-get", apt.format(log=self.log))
        for name in programs:
            self.write(name, "#!/bin/sh\n")

    def write(self, name, text):
        (self.path / name).write_text(text, encoding="utf-8")
        (self.path / name).chmod(0o755)

    def install(self, *sections):
        """Status, output, and the packages that apt was called to install, by call."""
        done = subprocess.run(["sh", self.folder / "tools" / "install_packages.sh", *sections], check=False, capture_output=True,
                              text=True, env={"PATH": str(self.path)})
        calls = self.log.read_text(encoding="utf-8").splitlines() if self.log.exists() else []
        installed = [[word for word in call.split()[1:] if not word.startswith("-")] for call in calls if call.startswith("install")]
        return done.returncode, done.stdout, installed


def main():
    source = pathlib.Path(sys.argv[1]).resolve()
    cases = {
        "nothing there": ([], NOTES, ["web"], 0, [["nodejs", "npm", "libfmt-dev"]]),
        "node and npm of another source": (["node", "npm"], CONFLICT, ["web"], 0, [["libfmt-dev"]]),
        "node without npm": (["node"], NOTES, ["web"], 0, [["npm", "libfmt-dev"]]),
        "all there": (["npm"], NOTES, ["other"], 0, []),
        "apt refuses": (["node"], CONFLICT, ["web"], 100, []),
    }
    faults = 0
    with tempfile.TemporaryDirectory() as name:
        for number, (what, (programs, apt, sections, status, packages)) in enumerate(cases.items()):
            said = Machine(source, pathlib.Path(name) / str(number), programs, apt).install(*sections)
            if (said[0], said[2]) != (status, packages):
                faults += 1
                print(f"{what}: status {said[0]}, installs {said[2]}, not {status} and {packages}\n{said[1]}")
        status, said, _ = Machine(source, pathlib.Path(name) / "no-apt", ["npm"], None).install("web")
        if status != 0 or said.splitlines()[1:] != ["  cmake", "  nodejs", "  libfmt-dev"]:
            faults += 1
            print(f"without apt: status {status}, {said}")
    print(f"{faults} faults in {len(cases) + 1} cases")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
