"""Every verb of the command prints and writes what is recorded here: text, JSON, CSV, arrays, pages and errors.

cases.txt lists the command lines and explains its form. outputs/VERB.txt holds what they print and write, with the exit
status. Whoever changes an output on purpose records it again and reviews the difference in the commit:

    recorded_test.py SOMS --record

Outputs are the same for every instruction set, number of threads, compiler and sanitizer. MASKS in forms.py lists what
is not compared. Help and man pages are not recorded.

usage: recorded_test.py SOMS [--record] [--threads N] [--keep FOLDER] [CASE...]
  --threads N      give every case this option, unless it has its own
  --keep FOLDER    leave the files of the cases there, to look at a difference of which only a digest is recorded
  CASE             compare only these cases
"""
import argparse
import concurrent.futures
import difflib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import forms

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parent / "data"
OUTPUTS = HERE / "outputs"
MOST_BYTES = 400_000  # of everything that is recorded
VERBS_WITHOUT_CASES = {"completion", "man"}  # what they print is help
OUTPUT_OPTIONS = r"^  (?:-\w,)?(--(?:binary|contacts|csv|events|journal|json|map|output|picture|record|report))(?= |$)"
NEEDS = {"bench": "soms-bench", "render": "soms-view", "reproduce": "soms-reproduce", "view": "soms-view"}


class Case:
    def __init__(self, name, words):
        self.name = name
        self.steps = [[]]
        for word in words:
            self.steps.append([]) if word == "&&" else self.steps[-1].append(word)
        bare = [word for word in self.steps[-1] if not re.match(r"[A-Z_]+=", word)]
        self.verb = bare[0] if bare and not bare[0].startswith("-") else "soms"
        self.has_program = len(bare) == len(self.steps[-1])  # a case that sets a variable is about its absence


def read_cases():
    inputs, models, cases = [], [], []
    for line in (HERE / "cases.txt").read_text(encoding="utf-8").splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "input":
            inputs.append(rest.strip())
        elif kind == "model":
            models.append(shlex.split(rest))
        elif kind == "case":
            name, _, words = rest.partition(":")
            cases.append(Case(name.strip(), shlex.split(words)))
        elif line and not line.startswith("#"):
            sys.exit(f"cases.txt: what is this? {line}")
    if len({case.name for case in cases}) != len(cases):
        sys.exit("cases.txt: two cases have one name")
    return inputs, models, cases


class Runner:
    def __init__(self, soms, threads):
        self.soms, self.threads, self.option = soms, threads, ["--threads", threads]
        self.environment = {name: value for name, value in os.environ.items()
                            if not name.startswith("SOMS_") or name == "SOMS_ISA"}
        self.environment["SOURCE_DATE_EPOCH"] = "1000000000"  # archives state the time of their making

    def run(self, words, folder):
        """One command: (words, status, output, errors)."""
        words, environment, given = list(words), dict(self.environment), b""
        while words and re.match(r"[A-Z_]+=", words[0]):
            name, _, value = words.pop(0).partition("=")
            environment[name] = value
        if "<" in words:
            at = words.index("<")
            given = (folder / words[at + 1]).read_bytes()
            del words[at:at + 2]
        if self.threads and "--threads" not in words and not words[0].startswith("-"):
            words += self.option
        done = subprocess.run([self.soms, *words], check=False, capture_output=True, input=given, cwd=folder,
                              env=environment)
        return done.returncode, self.as_recorded(done.stdout), self.as_recorded(done.stderr)

    def as_recorded(self, data):
        """Without what differs between runs: some outputs repeat the command line, one lists what this machine can."""
        data = re.sub(rb"use one of [a-z0-9, ]+, or unset it", b"use one of those of this machine, or unset it", data)
        return data.replace((" " + " ".join(self.option)).encode(), b"") if self.threads else data

    def lines_of(self, case, folder, inputs):
        """What is recorded of a case."""
        folder.mkdir(parents=True)
        for file in inputs.iterdir():
            os.link(file, folder / file.name)
        yield f"## {case.name}"
        for step in case.steps:
            status, out, err = self.run(step, folder)
            yield f"$ {shown(step)}"
            yield f"status {status}"
            for name, data in (("output", out), ("errors", err)):
                if data:
                    yield f"{name}:"
                    yield from ("  " + line for line in printed_lines(data))
        for file in sorted(folder.rglob("*")):
            if file.is_file() and not (inputs / file.name).exists():
                yield f"{file.relative_to(folder)}:"
                yield from ("  " + line for line in forms.file_lines(file.name, self.as_recorded(file.read_bytes())))
        for file in inputs.iterdir():
            (folder / file.name).unlink()  # what stays, for --keep, are the outputs


def shown(words):
    """A command line as one types it."""
    count = sum(1 for word in words if re.match(r"[A-Z_]+=", word))
    return " ".join([*words[:count], "soms", *(word if word == "<" else shlex.quote(word) for word in words[count:])])


def printed_lines(data):
    try:
        return forms.text_lines(forms.masked(data.decode()))
    except UnicodeDecodeError:
        return [forms.digest(data)]


def make_inputs(runner, inputs, models, folder):
    folder.mkdir()
    for source in [*(DATA / name for name in inputs), *sorted((HERE / "inputs").iterdir())]:
        (folder / source.name).write_bytes(source.read_bytes())
    for words in models:
        status, _, err = runner.run(words, folder)
        if status != 0:
            sys.exit(f"soms {shlex.join(words)}: {err.decode()}")


def verbs_of(soms):
    text = subprocess.run([soms, "--help"], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"^  ([a-z]+)  +\S", text.partition("Verbs:")[2] or text, re.MULTILINE))


def recorded_cases():
    """{case: its recorded lines} of all files."""
    found = {}
    for file in sorted(OUTPUTS.glob("*.txt")):
        for block in re.split(r"^(?=## )", file.read_text(encoding="utf-8"), flags=re.MULTILINE):
            if block.startswith("## "):
                found[block.split("\n", 1)[0][3:]] = block.rstrip("\n").split("\n")
    return found


def write(cases, now):
    OUTPUTS.mkdir(exist_ok=True)
    for verb in {case.verb for case in cases}:
        blocks = ["\n".join(now[case.name]) + "\n" for case in cases if case.verb == verb and case.name in now]
        (OUTPUTS / f"{verb}.txt").write_text("\n".join(blocks), encoding="utf-8")


def differences(cases, now, was):
    found = 0
    for case in cases:
        if now[case.name] != was.get(case.name):
            found += 1
            print("\n".join(difflib.unified_diff(was.get(case.name, []), now[case.name], "recorded", case.name, n=2, lineterm="")))
    return found


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("soms", type=pathlib.Path)
    parser.add_argument("--record", action="store_true")
    parser.add_argument("--threads")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("cases", nargs="*")
    return parser.parse_args()


def faults_of_list(soms, cases, was):
    for verb in sorted(verbs_of(soms) - VERBS_WITHOUT_CASES):
        words = {word for case in cases for step in case.steps if verb in step for word in step}
        if not words:
            yield f"no case of {verb}"
        words |= {"--output"} if "-o" in words else set()
        usage = subprocess.run([soms, verb, "--help"], check=False, capture_output=True, text=True).stdout
        for option in re.findall(OUTPUT_OPTIONS, usage, re.MULTILINE):
            if option not in words:
                yield f"no case of {verb} has {option}"
    for name in sorted(set(was) - {case.name for case in cases}):
        yield f"{name} is recorded and no case"
    if sum(file.stat().st_size for file in OUTPUTS.glob("*.txt")) > MOST_BYTES:
        yield f"more than {MOST_BYTES:,} bytes are recorded"


def main():
    wanted = arguments()
    soms = wanted.soms.resolve()
    inputs, models, all_cases = read_cases()
    cases = [case for case in all_cases if not wanted.cases or case.name in wanted.cases]
    missing = {verb for verb, name in NEEDS.items() if not soms.with_name(name).exists()}
    runnable = [case for case in cases if case.verb not in missing or not case.has_program]
    runner = Runner(soms, wanted.threads)
    with tempfile.TemporaryDirectory() as temporary:
        folder = (wanted.keep or pathlib.Path(temporary) / "cases").resolve()
        folder.mkdir(parents=True, exist_ok=True)
        make_inputs(runner, inputs, models, folder / "inputs")
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            lines = pool.map(lambda case: list(runner.lines_of(case, folder / case.name, folder / "inputs")), runnable)
            now = dict(zip((case.name for case in runnable), lines))
    was = recorded_cases()
    if wanted.record:
        write(all_cases, was | now)
        was = recorded_cases()
    found = list(faults_of_list(soms, all_cases, was))
    for line in found:
        print(line)
    count = differences(runnable, now, was) + len(found)
    absent = sorted({NEEDS[case.verb] for case in cases if case not in runnable})
    skipped = f", {len(cases) - len(runnable)} skipped without {', '.join(absent)}" if absent else ""
    print(f"{len(runnable)} cases{skipped}, {count} faults")
    return 1 if count or not runnable else 0


if __name__ == "__main__":
    sys.exit(main())
