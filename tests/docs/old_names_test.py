"""Old names of options: each example of the pages of an earlier release that has one gives the same answer by the new name.

The examples are in earlier/, a script a page. A `soms` that stands before the command in PATH runs each call with an old name twice:
as it is written, and by the new name. Both must have the same status and standard output, and the first says once for each old name
what it is now. Which names are old is read from the parsers (`soms VERB --verb-as-json`), and each must occur in an example.

usage: old_names_test.py COMMAND
"""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
REMARK = re.compile(r"^(--[\w-]+)(?: \S+)? is now (--[\w-]+)(?: \S+)?; the old form ends with the next release$", re.MULTILINE)
SECONDS = re.compile(r"\d[\d,.e+-]* (?:ms|s|us|fps|million|MB|kB)\b|\"[a-z_]*(?:ms|seconds|fps|rate|mean|median|worst|share_of_others)[a-z_]*\":[^,}]*|(?:median|worst|mean) [\d.,]+|[\d.,]+ (?:frames|queries) a second|(?m:^\| \w+ \| .* \|$)")
WRAPPER = """#!/bin/sh
exec "{python}" "{script}" --call "$@"
"""


def names_of(command):
    """Old names of each verb with the new ones."""
    help_text = subprocess.run([command, "--help"], check=True, capture_output=True, text=True).stdout
    verbs = [line.split()[0] for line in help_text.split("Verbs:\n", 1)[1].split("\n\n", 1)[0].splitlines()]
    names = {}
    for verb in verbs:
        done = subprocess.run([command, verb, "--verb-as-json"], capture_output=True, text=True)
        options = json.loads(done.stdout)["options"] if done.returncode == 0 else []
        for option in options:
            for old in option["old_names"]:
                names.setdefault(verb, {})[old] = option["names"][0]
    return names


def call(words):
    """Stands for the command: answers, and notes what differs by the new names."""
    command, names = os.environ["SOMS_REAL"], json.loads(os.environ["SOMS_OLD_NAMES"]).get(words[0] if words else "", {})
    given = {word.split("=")[0] for word in words} & set(names)
    text = sys.stdin.read() if given and "-" in words else None
    run = lambda line: subprocess.run([command, *line], text=True, input=text, stdin=None if text is not None else sys.stdin,
                                      capture_output=True)
    if not given or "-q" in words or "--quiet" in words:
        sys.exit(subprocess.run([command, *words]).returncode)
    old = run(words)
    remarks = REMARK.findall(old.stderr)
    now = dict(remarks)
    new = run([now[name] + word[len(name):] if (name := word.split("=")[0]) in now else word for word in words])
    with open(os.environ["SOMS_NOTED"], "a", encoding="utf-8") as file:
        for name in now:
            file.write(f"used {words[0]} {name}\n")
        plain = lambda text: SECONDS.sub("", text)
        if (old.returncode, plain(old.stdout)) != (new.returncode, plain(new.stdout)):
            file.write(f"fault {words}: {old.returncode} {old.stdout!r} {old.stderr!r}, by the new names {new.returncode} {new.stdout!r} {new.stderr!r}\n")
        if len(remarks) != len(now) or REMARK.search(new.stderr) or any(now[name] != names[name] for name in now):
            file.write(f"fault {words}: remarks {old.stderr!r}, by the new names {new.stderr!r}\n")
    sys.stdout.write(old.stdout)
    sys.stderr.write(old.stderr)
    sys.exit(old.returncode)


def run_page(page, folder, environment):
    folder.mkdir()
    subprocess.run(["bash", page], cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True)


def main():
    if sys.argv[1] == "--call":
        call(sys.argv[2:])
    command = pathlib.Path(sys.argv[1]).resolve()
    names = names_of(command)
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "bin").mkdir()
        wrapper = folder / "bin/soms"
        wrapper.write_text(WRAPPER.format(python=sys.executable, script=pathlib.Path(__file__).resolve()), encoding="utf-8")
        wrapper.chmod(0o755)
        noted = folder / "noted"
        noted.touch()
        environment = {"PATH": f"{folder}/bin:/usr/local/bin:/usr/bin:/bin", "HOME": place, "LC_ALL": "C.UTF-8", "SOMS_REAL": str(command),
                       "SOMS_OLD_NAMES": json.dumps(names), "SOMS_NOTED": str(noted),
                       "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "")}
        pages = sorted((HERE / "earlier").glob("*.sh"))
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            list(pool.map(lambda page: run_page(page, folder / page.stem, environment), pages))
        lines = noted.read_text(encoding="utf-8").splitlines()
    used = {tuple(line.split()[1:]) for line in lines if line.startswith("used ")}
    faults = [line for line in lines if line.startswith("fault ")]
    faults += [f"no example of earlier/ has soms {verb} {old}" for verb, of_verb in names.items() for old in of_verb
               if (verb, old) not in used]
    print(*faults, f"{sum(line.startswith('used ') for line in lines)} old names in examples, {len(faults)} faults", sep="\n")
    return 1 if faults or not used else 0


if __name__ == "__main__":
    sys.exit(main())
