"""Code, docs and messages use the field's words and one spelling, American.

Each row of WORDS is a word that soms once used for a thing that the field calls otherwise. A row of ALLOWED
lets a word stand in some lines, and says why.

usage: words_test.py ROOT [--list]   (with --list: every place, not only the first few of a word)
"""
import collections
import pathlib
import re
import sys

FOLDERS = ("soms", "apps", "thesis", "bench", "tests", "tools", "docs", "cmake", "python")
SUFFIXES = (".h", ".cpp", ".py", ".cmake", ".txt", ".md", ".sh", ".in", ".map")
SKIPPED = re.compile(r"^(tests/data/|tests/fuzz/(seeds|words)/|tests/structure/words_test\.py|apps/report/web/)")
LEAST_FILES = 600

# word: (what to say, pattern)
WORDS = {
    "walk": ("traversal, traverse", r"(?i)(?<!side)walk"),
    "open (a node)": ("descend", r"\bopens_[xyab]\b|\bopen_(a|b|both)\b|\b(nodes?|pairs?|boxes) (is|are|was|were) opened\b|\bopens? (both|the (larger|first|second)) nodes?\b"),
    "place, code, word": ("node or leaf reference, node id, token", r"\bPlacePair\b|\bcodes?_[xy]\b|\btake_word\b|\bword_in_line\b|\bColladaWords\b"),
    "columns": ("min/max height grid, column sweep", r"\b(layout|detail)::Columns\b|\bcolumns_y_\b|\bclass Columns\b"),
    "scouts, flight": ("batched root descent, in-flight query", r"(?i)\bscout|\bflights_of\b|\bstruct Flight\b"),
    "viewer (of a pair)": ("reference frame", r"\bfirst_is_viewer\b|\bdetail::Viewer\b|\bfixed_viewer_\b"),
    "lone box": ("single-box descent", r"(?i)\blone[_ -]|\bLoneBox"),
    "reach": ("L1 radius", r"\b(node|block|x|y|a|b)(\.|->)reach\b"),
    "turned": ("oriented", r"\bis_turned\b|\b(node|x|y)(\.|->)turned\b|\bunturned\b"),
    "looseness, decline, pace": ("SAH degradation, rebuild interval", r"(?i)\blooseness|\bdecline(d|_|\b)|\bpace(_|\b)|\b(Gl)?Pace\b"),
    "crowd, forest": ("moving boxes or primitive range, subtrees", r"(?i)crowds?(_|\b)|[a-z]Crowd|forest(_|\b)"),
    "contestant, rival": ("library under test, peer", r"(?i)contestant|\brivals?(_|\b)|_rivals?\b"),
    "told": ("reported, distinguished", r"\b[Tt]old(_|\b)|[a-z]Told|\buntold_"),
    "asked": ("queried, requested", r"\b[Aa]sked(_|\b)|_asked\b|[a-z]Asked"),
    "way": ("route", r"\bWays?\b(?=[ ({:&>])(?! [a-z])|\bevery_way\b|_ways\b|\bplan_ways\b"),
    "ending": ("file extension", r"\bendings\b|_endings?\b|\ban ending\b|\bEndings?\("),
    "anew": ("again, re-", r"\banew\b"),
    "British spelling": ("American spelling", r"(?i)\b(kilo|milli|centi)?metres?\b|colour|neighbour|behaviour|favour|\blicence\b|\bcentres?\b|\bgrey\b|\btowards\b|artefact"
                                              r"|catalogue|\bdefence\b|(travell|labell|modell|levell)(ed|ing)\b"
                                              r"|\b(optim|normal|initial|recogn|organ|serial|minim|maxim|summar|general|quant|visual)is(e|ed|es|ing|ation)\b"),
    "option of the command": ("the library's own argument: the command adds its options", r'(?<!//)"[^"\n]*--[a-z]'),
    "message nobody writes": ("what happened, where, and what to do, as SQLite or ripgrep would", r'(?<!//)"[^"\n]*('
                              r"\bstands? (still|twice|before|where)\b|\bwholly (in|out)side\b|\blimit leaves\b|\bwhose words\b|\btake one of\b"
                              r"|\bbytes that are left\b|\bnone of the named\b|\bto and fro\b|\bwhat is warned of\b|\bshown in the shape\b"
                              r"|\bis no (item|file|whole|instruction|regular|base64|well-formed)|\bthe name says\b|\bnamed twice\b|\bwould not end\b"
                              r"|\bmend\b|\bmake room\b|\b(is|its|are) turned\b|\b(a|one) number a column\b|\bones? row a (line|pair|pose)\b)"),
}
WHERE = {"option of the command": re.compile(r"^soms/.*\.(h|cpp)$"),
         "message nobody writes": re.compile(r"^(soms|apps|bench/peers|thesis)/.*\.(h|cpp)$")}  # elsewhere: everywhere

# (word or *, path, line or None, reason)
ALLOWED = [
    ("*", r"^CHANGELOG\.md$", None, "says what was released under the names of then"),
    ("walk", r"^(soms|tests)/generate/|^docs/(generate|simulate|commands)\.md", r"(?i)walk", "persons walk on sidewalks"),
    ("scouts, flight", r"", r"CameraFlight", "the camera flies"),
    ("looseness, decline, pace", r"^tests/", r"\bDecline[A-Z]|\bDeclines?\b", "to refuse"),
    ("crowd, forest", r"^tests/geometry/closedness_test", r'"forest"', "the name of a mesh of the truth set"),
    ("crowd, forest", r"^docs/data\.md", r"MagicForest", "the name of a repository"),
    ("British spelling", r"^tests/io/import_test\.cpp", r"METRE", "a keyword of IFC"),
    ("British spelling", r"^tests/io/losses_test\.cpp", r"face_colours\.off", "the name of a file"),
    ("British spelling", r"^tests/commands/simulate/simulate_test\.cpp", r"--colou?r", "an option misspelled on purpose"),
]


def texts(root):
    """(path from the root, text) of every file that people read."""
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.is_file() and path.suffix in SUFFIXES and not SKIPPED.match(name):
                yield name, path.read_text(encoding="utf-8", errors="replace")
    for path in sorted(root.glob("*.md")) + [root / "Makefile", root / "CMakeLists.txt"]:
        yield path.name, path.read_text(encoding="utf-8")


def is_allowed(word, name, line):
    return any(which in (word, "*") and re.search(where, name) and (what is None or re.search(what, line))
               for which, where, what, _ in ALLOWED)


def main():
    root, listed = pathlib.Path(sys.argv[1]), "--list" in sys.argv
    patterns = {word: re.compile(pattern) for word, (_, pattern) in WORDS.items()}
    found, files = collections.defaultdict(list), 0
    for name, text in texts(root):
        files += 1
        # Few words stand anywhere in a file: its lines are searched for those only.
        in_file = [(word, pattern) for word, pattern in patterns.items()
                   if (word not in WHERE or WHERE[word].search(name)) and pattern.search(text)]
        for number, line in enumerate(text.splitlines() if in_file else (), 1):
            for word, pattern in in_file:
                if pattern.search(line) and not is_allowed(word, name, line):
                    found[word].append(f"{name}:{number}: {line.strip()[:120]}")
    for word, places in found.items():
        print(f"{word} ({len(places)}): say {WORDS[word][0]}")
        print("\n".join("  " + place for place in (places if listed else places[:5])))
    print(f"{files} files, {sum(map(len, found.values()))} faults")
    return 1 if found or files < LEAST_FILES else 0


sys.exit(main())
