"""Does a command print what a page shows?

The rule, by which a page may be read, too: blanks and ends of lines do not count. `...` stands for
anything. A number with fewer digits behind its point stands for those that round to it. Times differ
from run to run: any number will do in place of one that a unit of time follows (ms, us, ns, s), that is
the value of a JSON key which ends so or on `seconds`, or that stands below such a unit in the heading of a
table: in that column of one with bars, in the last column of another.
"""
import re
from decimal import Decimal

TOKEN = re.compile(r"\.\.\.|-?\d+(?:\.\d+)?(?:e[-+]?\d+)?|[A-Za-z_]+|\n|\S")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
UNITS = {"ms", "us", "ns", "s"}
TIMED_KEY = re.compile(r"\w*(_ms|_us|_ns|_s|seconds)")


def cells(words):
    """The number of each word's column: of a table with bars, else 0, or 1 for the last word."""
    if "|" not in words:
        return [int(place == len(words) - 1) for place in range(len(words))]
    bars = 0
    places = []
    for word in words:
        bars += word == "|"
        places.append(bars)
    return places


def tokens(text):
    """(token, true for a time) of each; ends of lines are left out."""
    found, timed_columns = [], None  # None outside of a table
    for line in text.splitlines():
        words = TOKEN.findall(line)
        columns = cells(words)
        numbers = [bool(NUMBER.fullmatch(word)) for word in words]
        times = set()
        for place, number in enumerate(numbers):
            after = words[place + 1] if place + 1 < len(words) else ""
            key = words[place - 3] if place >= 3 and words[place - 2:place] == ['"', ":"] else ""
            in_table = timed_columns is not None and columns[place] in timed_columns
            if number and (after in UNITS or TIMED_KEY.fullmatch(key) or in_table):
                times.add(place)
        if not any(numbers) and "..." not in words and not set("".join(words)) <= set("|-:"):
            units = {column for word, column in zip(words, columns) if word in UNITS}
            timed_columns = units - {0} or None
        found += [(word, place in times) for place, word in enumerate(words)]
    return found


def same(shown, printed):
    (word, timed), (other, _) = shown, printed
    if word == other:
        return True
    if not (NUMBER.fullmatch(word) and NUMBER.fullmatch(other)):
        return False
    if timed:
        return True
    places = re.fullmatch(r"-?\d+\.(\d+)", word)
    if places is None:
        return False
    half = Decimal(5).scaleb(-len(places[1]) - 1)
    return abs(Decimal(other) - Decimal(word)) <= half


def difference(shown, printed):
    """None where `printed` is what `shown` shows; else the words around the first difference."""
    wanted, given = tokens(shown), tokens(printed)
    # reach[j]: the tokens of `wanted` so far may stand for the first j of `given`.
    reach, best = {0}, 0
    for number, token in enumerate(wanted):
        if token[0] == "...":
            reach = set(range(min(reach), len(given) + 1))
        else:
            reach = {j + 1 for j in reach if j < len(given) and same(token, given[j])}
        if not reach:
            def words(row, place):
                return " ".join(word for word, _ in row[max(0, place - 4):place + 5])
            return f"shown: {words(wanted, number)}\nprinted: {words(given, best)}"
        best = min(reach)
    if len(given) in reach:
        return None
    return "printed, but not shown: " + " ".join(word for word, _ in given[min(reach):][:12])
