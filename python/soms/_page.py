"""The page of a report: bodies in three dimensions, and what an answer says of them."""

import os
from typing import Any

from soms import _soms

# A notebook keeps what its cells show.
NOTEBOOK_TRIANGLES = 60_000


class Page:
    """Page(given, answer=None, *, poses=None, title='', triangles=240_000)

    A page in HTML with a view of bodies in three dimensions, which needs no network: a notebook shows
    it, write makes a file of it, a browser opens that.

    given: a Body, Shape or Mesh, a list of them, or a Scene at its present poses. answer: a StepReport
    of that scene; or, of a list [a, b], an Overlap or Distance, or with poses a batch of them. The page
    lists what touches and how far apart what does not. poses: of a, as overlap takes them. triangles:
    as many are drawn at most, fewer where movers share models; large models are drawn coarser, and the
    page says so. Answers are never coarser.

    html: the text. triangles, triangles_in_all: how many it draws, of how many.
    Size: 0.65 MB, and typically 5 bytes a triangle that is drawn. Raises Error of kind usage.
    """

    def __init__(
        self, given: Any, answer: Any = None, *, poses: Any = None, title: str = "",
        triangles: int = 240_000,
    ) -> None:
        self.html: str
        self.triangles: int
        self.triangles_in_all: int
        self.html, self.triangles, self.triangles_in_all = _soms._page(
            given, answer, poses, title, triangles)

    def write(self, path: "str | os.PathLike[str]") -> None:
        """Writes the page to a file."""
        with open(path, "w", encoding="utf-8", newline="\n") as file:
            file.write(self.html)

    def __repr__(self) -> str:
        return (f"Page{{{self.triangles} of {self.triangles_in_all} triangles, "
                f"{len(self.html)} characters}}")

    def _repr_html_(self) -> str:
        """The page in a frame of its own, as a notebook shows it: its scripts run there, and see
        nothing of the notebook."""
        text = self.html.replace("&", "&amp;").replace('"', "&quot;")
        return (f'<iframe srcdoc="{text}" sandbox="allow-scripts" title="soms" '
                'style="width:100%;height:680px;border:0"></iframe>')


def notebook_html(given: Any) -> str:
    """What a notebook shows of a body or a scene."""
    return Page(given, triangles=NOTEBOOK_TRIANGLES)._repr_html_()
