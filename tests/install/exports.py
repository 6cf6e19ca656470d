"""What the shared library shows to the linker: names of soms, and few of soms::detail."""
import subprocess
import sys

MOST_DETAILS = 60


def check_exports(library):
    said = subprocess.run(["nm", "-DC", "--defined-only", str(library)], check=True,
                          capture_output=True, text=True).stdout
    names = [line.split(" ", 2)[2] for line in said.splitlines()]
    foreign = [name for name in names if "soms::" not in name]
    details = [name for name in names if "detail::" in name]
    if not any(name.startswith("soms::read_mesh(") for name in names):
        sys.exit(f"{library} does not show soms::read_mesh")
    if foreign or len(details) > MOST_DETAILS:
        sys.exit(f"{library} shows {foreign[:5]} and {len(details)} details: {details[:5]}")
    print(f"{library.name}: {len(names)} names, {len(details)} of them details", flush=True)
