"""The cells of python/examples/tour.ipynb run in order, and put out what is stored there.

    notebook_test.py --write    runs them and stores what they put out
"""
import ast
import contextlib
import io
import json
import os
import pathlib
import sys
import unittest

NOTEBOOK = pathlib.Path(__file__).resolve().parents[2] / "python/examples/tour.ipynb"
MOST_BYTES = 500_000
SHOWN_AS = {"_repr_html_": "text/html", "_repr_svg_": "image/svg+xml"}


def lines_of(text):
    return text.splitlines(keepends=True)


def shown(value):
    """The data of an output, as a notebook stores it."""
    data = {kind: lines_of(getattr(value, method)()) for method, kind in SHOWN_AS.items()
            if hasattr(value, method)}
    # A repr by address differs from run to run.
    return data if data else {"text/plain": lines_of(repr(value))}


def run(code, names, number):
    """What a cell puts out: its text, then the value of its last line."""
    tree = ast.parse(code)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    text = io.StringIO()
    with contextlib.redirect_stdout(text):
        exec(compile(tree, f"cell {number}", "exec"), names)
        value = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names) if last else None
    outputs = []
    if text.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": lines_of(text.getvalue())})
    if value is not None:
        outputs.append({"data": shown(value), "execution_count": number, "metadata": {},
                        "output_type": "execute_result"})
    return outputs


def run_all(notebook):
    """Puts the outputs into the cells of code."""
    names = {"__name__": "__main__"}
    number = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            number += 1
            cell["execution_count"] = number
            cell["outputs"] = run("".join(cell["source"]), names, number)
    return notebook


def read():
    return json.loads(NOTEBOOK.read_text(encoding="utf-8"))


class Notebook(unittest.TestCase):
    def test_outputs_are_those_that_are_stored(self):
        self.assertLess(os.path.getsize(NOTEBOOK), MOST_BYTES)
        stored, made = read(), run_all(read())
        self.assertEqual(len(stored["cells"]), len(made["cells"]))
        for before, after in zip(stored["cells"], made["cells"]):
            self.assertEqual(before, after)

    def test_its_picture_is_in_it(self):
        pictures = [cell for cell in read()["cells"] if "attachments" in cell]
        self.assertEqual(len(pictures), 1)
        (name, data), = pictures[0]["attachments"].items()
        self.assertIn(f"attachment:{name}", "".join(pictures[0]["source"]))
        self.assertTrue(data["image/png"].startswith("iVBORw0KGgo"))


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        NOTEBOOK.write_text(json.dumps(run_all(read()), indent=1, ensure_ascii=False) + "\n",
                            encoding="utf-8")
    else:
        unittest.main()
