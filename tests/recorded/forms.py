"""What is recorded of an output: text as it is, arrays, archives, pictures and pages as lines that can be read.

Everything is compared by its bytes. What is long is recorded by its beginning and a digest of the whole.
NumPy is not needed: an array of it is a header in Python's syntax and plain bytes.
"""
import ast
import csv
import hashlib
import html.parser
import io
import re
import struct
import zipfile
import zlib

MOST_TEXT = 3000  # characters of a text that are recorded as they are
HEAD = 1500  # of a longer one
FIRST_VALUES = 6
MOST_MEMBERS = 10  # of an archive; the arrays of one are fewer
TEXTS = {".csv", ".json", ".jsonl", ".txt", ".svg", ".md", ".tex", ".obj", ".off", ".bcf", ".bcfv", ".bcfp", ".version", ".extensions"}
CODES = {"f8": "d", "f4": "f", "i8": "q", "i4": "i", "u8": "Q", "u4": "I", "u2": "H", "u1": "B", "i1": "b", "b1": "?"}

BLOCKS = {"h1", "h2", "h3", "p", "figcaption", "title", "summary"}  # words that are in no row of a table

# The only things that are not compared, and why: (pattern, what stands for it).
TIME = r'(?:\{[^{}]*\}|-?\d[\d.e+-]*|null)'
MASKS = [
    # Times and speeds: members of JSON, then what simulate, info and thesis print.
    (rf'("\w*(?:_ms|fps|seconds|_a_second)": ?){TIME}', r"\1TIME"),
    (r'("build_runs":)\d+', r"\1RUNS"),
    (r'("share_of_others":)(?:null|[\d.]+)', r"\1SHARE"),
    (r"(?m)^.*other programs used \d+ % of the processors.*\n", ""),
    (r"[\d.]+ ms, after [\d.]+ ms to", "TIME, after TIME to"),
    (r"[\d,]+ frames a second \(worst [\d,]+\), [\d,]+ queries", "SPEED frames a second (worst SPEED), SPEED queries"),
    (r"(?s)(<title>Time of each frame</title>).*?</svg>", r"\1</svg>"),
    (r"(?m)^( +[a-z-]+(?: +[\d,]+){5} +[\d.]+) +[\d.]+ +\d+$", r"\1 TIME"),
    (r"(?m)^( +\d+(?: +[\d,]+){5}) +(?:\d+\.\d+|-) +(?:[\d.]+|-)$", r"\1 TIME"),
    (r"(?m)^(\S+ +\w+(?: +[\d,-]+){9})(?: +(?:\d+\.\d+|-)){3} +(?:[\d.]+|-)$", r"\1 TIME"),
    (r"(?m)^collision in frames with overlapping roots: .*\nthat is .*\n", ""),  # absent where no time could be taken
    (r"(?m)^of \d+ tests?, \d+ below, \d+ within and \d+ above", "of TESTS below, within and above"),
    # The version, the instruction set, and what reproduce says of the run, the build and the machine.
    (r"\bsoms \d+\.\d+\.\d+", "soms VERSION"),
    (r'("(?:version|commit|date|ended)": ?)"[^"]*"', r'\1"MASKED"'),
    (r'("instruction_sets?": ?)(?:"\w+"|\[[^\]]*\])', r'\1"MASKED"'),
    (r"(instruction set )\w+, of .* here", r"\1MASKED"),
    (r'(?ms)^(  "(?:build|machine|load)": )\{.*?^  \}', r'\1"MASKED"'),
    (r'(?s)<h2 id="run">.*?(?=<h2 id="models">)', ""),
    (r'<p class="warn"><strong>The machine was busy.*</p>\n', ""),
    (r"(% Written by soms VERSION|quick run of).*", r"\1"),
]
TIMED_COLUMNS = re.compile(r"_ms$|^fps$")  # of CSV


def without_times(text):
    """A CSV whose columns of times are masked."""
    rows = list(csv.reader(io.StringIO(text)))
    timed = [at for at, name in enumerate(rows[0] if rows else []) if TIMED_COLUMNS.search(name)]
    if not timed:
        return text
    for row in rows[1:]:
        for at in timed:
            row[at] = "TIME"
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return out.getvalue()


def masked(text):
    for pattern, instead in MASKS:
        text = re.sub(pattern, instead, text)
    return text


def digest(data):
    return f"{len(data):,} bytes, sha256 {hashlib.sha256(data).hexdigest()[:16]}"


def text_lines(text):
    """A text as it is, or its beginning and a digest of all."""
    if len(text) <= MOST_TEXT:
        return text.splitlines() + ([] if text.endswith("\n") or not text else ["(no end of line)"])
    head = text[:HEAD].splitlines()
    return [*head, f"... {text.count(chr(10)):,} lines in all, {digest(text.encode())}"]


def first_values(kind, raw):
    if kind[1] in "SU":
        size = int(kind[2:]) * (4 if kind[1] == "U" else 1)
        words = [raw[i:i + size] for i in range(0, len(raw), size)][:FIRST_VALUES]
        return " ".join(word.decode("utf-32-le" if kind[1] == "U" else "utf-8").rstrip("\0") for word in words)
    code = CODES[kind[1:]]
    count = min(FIRST_VALUES, len(raw) // struct.calcsize(code))
    return " ".join(str(value) for value in struct.unpack_from(f"<{count}{code}", raw))


def array_line(data):
    """dtype, shape, digest and first values of what numpy.save writes."""
    length = struct.unpack_from("<H", data, 8)[0]
    header = ast.literal_eval(data[10:10 + length].decode())
    raw = data[10 + length:]
    order = " in Fortran order" if header["fortran_order"] else ""
    return f"{header['descr']} {header['shape']}{order}, {digest(raw)}: {first_values(header['descr'], raw)}"


def png_lines(data):
    """Sizes and pixels: how well they are compressed depends on the zlib of a machine."""
    at, packed, head = 8, b"", b""
    while at < len(data):
        size, name = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        head, packed = (body if name == b"IHDR" else head), packed + (body if name == b"IDAT" else b"")
        at += size + 12
    width, height, depth, color = struct.unpack_from(">IIBB", head)
    return [f"{width} x {height} pixels, {depth} bits, color type {color}, {digest(zlib.decompress(packed))}"]


class Page(html.parser.HTMLParser):
    """Words of a page, and its scripts by name; the controls of the 3-D view are the same on each page."""

    def __init__(self, text):
        super().__init__()
        self.lines, self.scripts, self.skipped = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if tag in {"tr", "dt"} and not self.skipped:
            self.lines.append("row:")
        if tag == "script":
            self.scripts.append([attrs.get("id", ""), attrs.get("type", ""), ""])
        if self.skipped or tag in {"script", "style", "svg"} or attrs.get("id") == "look":
            if tag not in {"input", "meta", "link", "br", "img", "hr"}:
                self.skipped.append(tag)

    def handle_endtag(self, tag):
        if self.skipped and tag in self.skipped:
            while self.skipped.pop() != tag:
                pass

    def handle_data(self, data):
        if self.skipped[-1:] == ["script"]:
            self.scripts[-1][2] += data
        elif not self.skipped and data.strip():
            words = " ".join(data.split())
            if self.lines and self.lines[-1].startswith("row:") and self.lasttag not in BLOCKS:
                self.lines[-1] += f" {words} |"
            else:
                self.lines.append(f"{self.lasttag}: {words}")


def page_lines(text):
    text = masked(text)
    page = Page(text)
    yield from text_lines("\n".join(page.lines) + "\n")
    for number, picture in enumerate(re.findall(r"(?s)<svg\b.*?</svg>", text)):
        yield f"picture {number}: {digest(picture.encode())}"
    for name, kind, body in page.scripts:
        if not name or name == "soms-module":
            yield f"script {name or 'of the page'}, not recorded"
        elif kind == "application/json":
            yield f"data {name}:"
            yield from text_lines(body)
        else:
            yield f"data {name}: {digest(body.encode())}"
    markup = re.sub(r"(?s)<(script|style)\b.*?</\1>", "", text)
    yield f"without scripts and styles: {digest(markup.encode())}"


def archive_lines(data):
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        names = archive.namelist()
        for name in names[:MOST_MEMBERS]:
            body = archive.read(name)
            if name.endswith(".npy"):
                yield f"{name.removesuffix('.npy')}: {array_line(body)}"
            else:
                yield f"{name}:"
                yield from ("  " + line for line in file_lines(name, body))
        if len(names) > MOST_MEMBERS:
            rest = [line for name in names[MOST_MEMBERS:] for line in (name, *file_lines(name, archive.read(name)))]
            yield f"... {len(names)} members in all, the rest: {digest(chr(10).join(rest).encode())}"


def file_lines(name, data):
    """What is recorded of a file."""
    suffix = "." + name.rsplit(".", 1)[-1]
    if suffix in {".npz", ".bcfzip", ".bcf"} and data[:2] == b"PK":
        return list(archive_lines(data))
    if suffix == ".npy":
        return [array_line(data)]
    if suffix == ".png":
        return png_lines(data)
    if suffix == ".html":
        return list(page_lines(data.decode()))
    if suffix in TEXTS:
        text = data.decode()
        return text_lines(masked(without_times(text) if suffix == ".csv" else text))
    return [digest(data)]
