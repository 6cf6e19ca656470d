"""Each block of Python in docs/python.md, docs/motion.md and README.md runs, and prints what the block after it shows."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\nIt prints:\n\n```text\n(.*?)^```\n)?",
                   re.MULTILINE | re.DOTALL)
PAGES = {"docs/python.md": 4, "docs/motion.md": 3, "README.md": 1}


class Pages(unittest.TestCase):
    def test_blocks(self):
        for page, least in PAGES.items():
            blocks = BLOCK.findall((ROOT / page).read_text(encoding="utf-8"))
            self.assertGreaterEqual(len(blocks), least, page)
            for number, (code, shown) in enumerate(blocks):
                with self.subTest(page=page, block=number), tempfile.TemporaryDirectory() as folder:
                    run = subprocess.run([sys.executable, "-c", code], capture_output=True,
                                         text=True, check=False, cwd=folder)
                    self.assertEqual(run.returncode, 0, run.stderr)
                    if shown:
                        self.assertEqual(run.stdout, shown)


if __name__ == "__main__":
    unittest.main()
