#!/usr/bin/env python3
"""Writes soms/io/detail/cityjson/epsg_units.cpp: the units of the EPSG registry's reference systems.

Facts come from the database of PROJ (Debian: proj-data), which has the EPSG registry. A system is
listed by the one length unit of all its axes, as an angular one, or not at all. It prints how many
systems and runs of codes there are. Without --write it only says whether the file is up to date.
"""
import argparse
import pathlib
import re
import sqlite3
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
TARGET = ROOT / "soms" / "io" / "detail" / "epsg_units.cpp"
DATABASE = "/usr/share/proj/proj.db"
RUNS_A_LINE = 5
# The database has decimals that are not the nearest double.
EXACT = {"US survey foot": 1200 / 3937}


def units_of_systems(database):
    """Units of the axes of each horizontal, geocentric, vertical and compound system by code."""
    units = {}
    for authority, code, name, factor, kind in database.execute(
            "select auth_name, code, name, conv_factor, type from unit_of_measure"):
        units[authority, code] = (kind, EXACT.get(name, factor))
    axes = {}
    for authority, code, unit_authority, unit in database.execute(
            "select coordinate_system_auth_name, coordinate_system_code, uom_auth_name, uom_code "
            "from axis where uom_code is not null order by coordinate_system_order"):
        axes.setdefault((authority, code), []).append(units[unit_authority, unit])
    systems = {}
    for table in ("projected_crs", "geodetic_crs", "vertical_crs"):
        for code, authority, system in database.execute(
                f"select code, coordinate_system_auth_name, coordinate_system_code from {table} "
                "where auth_name = 'EPSG'"):
            systems[int(code)] = axes[authority, system]
    for code, horizontal, vertical in database.execute(
            "select code, horiz_crs_code, vertical_crs_code from compound_crs "
            "where auth_name = 'EPSG'"):
        systems[int(code)] = systems[int(horizontal)] + systems[int(vertical)]
    return systems


def unit_of(axes):
    """Meters a unit, 0 for angles, None where lengths differ."""
    if any(kind != "length" for kind, _ in axes):
        return 0.0
    return axes[0][1] if len(set(axes)) == 1 else None


def runs_of(units):
    """[first, count, meters] of codes that follow each other."""
    runs = []
    for code, unit in sorted(units.items()):
        if runs and runs[-1][0] + runs[-1][1] == code and runs[-1][2] == unit:
            runs[-1][1] += 1
        else:
            runs.append([code, 1, unit])
    return runs


def source(database):
    version, = database.execute("select value from metadata where key = 'EPSG.VERSION'").fetchone()
    units = {code: unit_of(axes) for code, axes in units_of_systems(database).items()}
    units = {code: unit for code, unit in units.items() if unit is not None}
    meters = sorted(set(units.values()))
    lines = [f"// Made by tools/make_epsg_units.py from the EPSG registry {version}, as PROJ has it.",
             '#include "soms/io/detail/cityjson/epsg_units.h"', "", "#include <array>", "",
             "namespace soms::detail {", "", "namespace {", "",
             "// clang-format off", "constexpr std::array kMeters = {"]
    lines += [f"    {unit!r}," for unit in meters]
    lines += ["};", "", "constexpr auto kRuns = std::to_array<EpsgRun>({"]
    runs = [f"{{{first}, {count}, {meters.index(unit)}}}" for first, count, unit in runs_of(units)]
    for at in range(0, len(runs), RUNS_A_LINE):
        lines.append("    " + ", ".join(runs[at:at + RUNS_A_LINE]) + ",")
    lines += ["});", "// clang-format on", "", "}  // namespace", "",
              "std::span<const EpsgRun> epsg_runs() {", "  return kRuns;", "}", "",
              "double epsg_meters(const EpsgRun& run) {", "  return kMeters.at(run.unit);", "}", "",
              "}  // namespace soms::detail", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--database", default=DATABASE, help="proj.db (%(default)s)")
    parser.add_argument("--write", action="store_true", help="write the file")
    options = parser.parse_args()
    with sqlite3.connect(f"file:{options.database}?mode=ro", uri=True) as database:
        text = source(database)
    counts = [int(count) for count in re.findall(r"\{\d+, (\d+), \d+\}", text)]
    print(f"{sum(counts):,} systems in {len(counts):,} runs of codes")
    if options.write:
        TARGET.write_text(text)
    elif TARGET.read_text() != text:
        sys.exit(f"{TARGET.relative_to(ROOT)} is not up to date: run it with --write")


if __name__ == "__main__":
    main()
