"""Which parts of two models of a building clash: a table as a CSV file, in ten lines.

    building_clashes.py STRUCTURE SERVICES CLASHES.csv
"""
import csv
import sys

import soms


def upright(file):
    """The model, rotated to z up where its file says that it is not."""
    mesh = soms.read_mesh(file)
    return mesh.transformed(1, mesh.up)


def main():
    structure, services, table = sys.argv[1:]
    clashes = soms.clash(upright(structure), upright(services), threads=0)
    columns = clashes.columns()
    with open(table, "w", encoding="utf-8", errors="surrogateescape", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(columns)
        rows.writerows(zip(*columns.values()))
    print(f"{len(clashes)} pairs of parts clash")


if __name__ == "__main__":
    main()
