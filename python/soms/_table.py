"""Clash lists as tables."""

import html
from typing import Any

import numpy as np
from numpy.typing import NDArray

from soms._enums import ClashKind, Relation, Undecided

# Rows that a notebook shows.
NOTEBOOK_ROWS = 40


def clash_columns(clashes: Any) -> dict[str, NDArray[Any]]:
    """Columns of a ClashList by name, each with one entry for each row."""
    columns: dict[str, NDArray[Any]] = {
        "class": _words(ClashKind)[clashes.kind],
        "relation": _words(Relation)[clashes.relation],
        "why": _words(Undecided)[clashes.why],
    }
    for side, parts, numbers in zip("ab", clashes.parts, (clashes.a, clashes.b)):
        columns[side] = numbers
        columns[f"{side}_name"] = _texts(parts.names)[numbers]
        columns[f"{side}_id"] = _texts(parts.ids)[numbers]
        columns[f"{side}_type"] = _texts(parts.types)[numbers]
        columns[f"{side}_model"] = parts.model[numbers]
    columns["triangle_pairs"] = clashes.triangle_pairs
    columns["gap_lower"] = clashes.gap["lower"]
    columns["gap_upper"] = clashes.gap["upper"]
    columns["depth"] = clashes.depth
    for axis, letter in enumerate("xyz"):
        columns[f"direction_{letter}"] = clashes.direction[:, axis]
        columns[letter] = clashes.place[:, axis]
        columns[f"lower_{letter}"] = clashes.box[:, 0, axis]
        columns[f"upper_{letter}"] = clashes.box[:, 1, axis]
    columns["key"] = np.array([f"{key:016x}" for key in clashes.key.tolist()], dtype=object)
    return columns


def clash_html(clashes: Any) -> str:
    """The first rows of a ClashList for a notebook."""
    columns = clash_columns(clashes)
    shown = {"class": "class", "a_name": "a", "b_name": "b", "gap_lower": "gap", "depth": "depth",
             "triangle_pairs": "triangle pairs"}
    head = "".join(f"<th>{title}</th>" for title in shown.values())
    rows = []
    for i in range(min(len(clashes), NOTEBOOK_ROWS)):
        cells = (_cell(columns[name][i]) for name in shown)
        rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    more = len(clashes) - len(rows)
    rest = f"<p>and {more} more</p>" if more else ""
    return (f"<p>{html.escape(repr(clashes))}</p><table><thead><tr>{head}</tr></thead>"
            f"<tbody>{''.join(rows)}</tbody></table>{rest}")


def _words(members: Any) -> NDArray[Any]:
    return np.array([member.name for member in members], dtype=object)


def _texts(texts: list[str]) -> NDArray[Any]:
    return np.array(texts, dtype=object)


def _cell(value: Any) -> str:
    if isinstance(value, float):
        return "" if np.isnan(value) else f"{value:.6g}"
    return html.escape(str(value))
