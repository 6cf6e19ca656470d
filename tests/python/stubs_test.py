"""The stubs name what the module has, with its arguments; mypy --strict accepts an example; help is
useful."""
import ast
import inspect
import pathlib
import pydoc
import shutil
import subprocess
import sys
import unittest

import soms
from soms import _enums, _soms

PACKAGE = pathlib.Path(soms.__file__).parent
EXAMPLE = pathlib.Path(__file__).with_name("typing_example.py")
OF_EVERY_CLASS = {"__init__", "__eq__", "__hash__", "__repr__", "__bool__", "__doc__", "__module__",
                  "__new__", "__getstate__", "__setstate__", "_pybind11_conduit_v1_"}


def declared():
    """Functions and classes of the stub: argument names of each, and names of each class."""
    tree = ast.parse((PACKAGE / "_soms.pyi").read_text(encoding="utf-8"))
    functions = {node.name: [arg.arg for arg in (*node.args.args, *node.args.kwonlyargs)]
                 for node in tree.body
                 if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")}
    classes = {node.name: {member.name for member in node.body
                           if isinstance(member, ast.FunctionDef)}
               for node in tree.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")}
    return functions, classes


class Stubs(unittest.TestCase):
    def test_names_of_the_module(self):
        functions, classes = declared()
        there = {name for name in vars(_soms) if not name.startswith("_")}
        self.assertEqual(there, set(functions) | set(classes))
        for name, members in classes.items():
            made = set(vars(getattr(_soms, name))) - OF_EVERY_CLASS
            self.assertEqual(made, members - OF_EVERY_CLASS, name)

    def test_arguments_are_those_of_the_docstrings(self):
        for name, arguments in declared()[0].items():
            first = getattr(_soms, name).__doc__.splitlines()[0]
            self.assertTrue(first.startswith(f"{name}("), first)
            shown = ast.parse(f"def {first.split(' -> ')[0]}: ...").body[0].args
            self.assertEqual([arg.arg for arg in (*shown.args, *shown.kwonlyargs)], arguments, name)

    def test_the_package_offers_all_of_it(self):
        functions, classes = declared()
        enums = {name for name, value in vars(_enums).items() if inspect.isclass(value)}
        offered = {name for name in vars(soms) if not name.startswith("_")}
        self.assertEqual(offered, set(functions) | set(classes) | enums | {"Error", "Page"})

    def test_everything_says_what_it_is(self):
        functions, classes = declared()
        for name in (*functions, *classes):
            self.assertTrue(getattr(soms, name).__doc__, name)
        for name, members in classes.items():
            for member in members - OF_EVERY_CLASS - {"__len__", "__mul__", "__matmul__", "__enter__", "__exit__"}:
                self.assertTrue(getattr(getattr(soms, name), member).__doc__, f"{name}.{member}")
        text = pydoc.plain(pydoc.render_doc(soms))
        for word in ("Exact collision queries", "overlap(a, b, poses=None", "class Mesh"):
            self.assertIn(word, text)

    def test_types_are_accepted(self):
        subprocess.run([sys.executable, EXAMPLE], check=True, stdout=subprocess.DEVNULL)
        self.assertTrue((PACKAGE / "py.typed").exists())
        if not shutil.which("mypy"):
            self.skipTest("mypy is not installed")
        said = subprocess.run(["mypy", "--strict", f"--cache-dir={PACKAGE.parent / '.mypy_cache'}", EXAMPLE],
                              capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin:/bin", "MYPYPATH": str(PACKAGE.parent)})
        self.assertEqual(said.returncode, 0, said.stdout)


if __name__ == "__main__":
    unittest.main()
