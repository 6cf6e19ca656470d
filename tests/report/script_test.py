"""The script of the report page, apps/report/web/dist/report.js, is what its sources make.

`hash`: the sources have not changed since it was made; `live_hash`: nor those of the module beside it. `rebuild`: making it again gives the same
bytes; skipped where node or the packages (`npm ci`) are missing. `search`: what the list of contacts
finds; `words`: what the page says of rows that touch; `clash_rows`: which
clashes a page shows, and what it says of them; `chains`: in which order lines are dashed. The last four are skipped where node is missing.
"""
import hashlib
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
MAKE = "cd apps/report/web && npm ci && npm run build"


def hash_of_sources(web):
    """As build.mjs has it."""
    names = ["build.mjs", "package-lock.json", "package.json",
             *sorted(f"src/{file.name}" for file in (web / "src").iterdir()),
             *(f"../../../web/package/{name}.js" for name in ("errors", "host", "module"))]
    digest = hashlib.sha256()
    for name in names:
        digest.update(name.encode() + b"\0" + (web / name).read_bytes() + b"\0")
    return digest.hexdigest()


def check_hash(web):
    head = (web / "dist/report.js").read_text(encoding="ascii")[:1000]
    wanted = hash_of_sources(web)
    if f"sha256 {wanted} " not in head:
        print(f"the sources changed (sha256 {wanted}); make the script again: {MAKE}")
        return 1
    return 0


def check_live_hash(web):
    """The first line of live.sources is of the files that the others name, as web/pack_live.py has it."""
    head, *names = (web / "dist/live.sources").read_text(encoding="ascii").splitlines()
    root = web.parent.parent.parent
    digest = hashlib.sha256()
    for name in names:
        if not (root / name).is_file():
            print(f"{name} is gone; make the module again: make live")
            return 1
        digest.update(name.encode() + b"\0" + (root / name).read_bytes() + b"\0")
    if len(names) < 100 or head != f"sha256 {digest.hexdigest()}":
        print(f"sources of the module of live reports changed (sha256 {digest.hexdigest()}); make it again: make live")
        return 1
    return 0


def check_rebuild(web):
    node = shutil.which("node")
    if node is None or not (web / "node_modules/esbuild").is_dir() \
            or not (web / "node_modules/three").is_dir():
        print(f"skipped: node or its packages are not installed ({MAKE})")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([node, web / "build.mjs", folder], check=True)
        for name in ("report.js", "LICENSE.three"):
            if (pathlib.Path(folder) / name).read_bytes() != (web / "dist" / name).read_bytes():
                print(f"dist/{name} is not what the sources make: {MAKE}")
                return 1
    return 0


# A contact of triangle 12345 of "crate, 12,345" in frames 1,234 to 2,000, queries, and if they find it.
SEARCH = """
import { haystack, holds, rowHaystack } from '%(words)s';
const names = ['crate, 12,345', 'dock'];
const all = {
  scene: { bodies: { names, moves: [1, 0] }, moving: 1, parts: ['lid'], paths: ['crates/lid'], steps: { noun: 'frame', count: 3000 } },
  contacts: { row: () => 0, a: () => 0, b: () => 1, part: () => 0xffffffff, begin: () => 1234, end: () => 2000,
    triangles: (k, side) => (side === 0 ? [4711, 8] : [23456]), pairsInAll: () => 2, pairCount: () => 2 },
  rows: { meeting: () => 0, after: () => 0, a: () => 0, b: () => 1, part: (r, side) => (side === 0 ? 0 : 0xffffffff), begin: () => 3, end: () => 3,
    steps: () => 1, triangle: (r, side) => (side === 0 ? undefined : 23456) },
};
const rowHay = rowHaystack(all, 0);
for (const [query, found] of [['lid dock', true], ['crates/lid', true], ['23,456', true], ['frame 3', true],
  ['undefined', false], ['crates/box', false]]) {
  if (holds(rowHay, query) !== found) {
    console.log(`"${query}" ${found ? 'is not found' : 'is found'} in row "${rowHay}"`);
    process.exitCode = 1;
  }
}
const hay = haystack(all, 7);
for (const [query, found] of [
  ['', true], ['crate', true], ['CRATE dock', true], ['crate, 12,345', true], ['crate 12345', true],
  ['1,234', true], ['1234', true], ['frames 1,234 to 2,000', true], ['12,34', true], ['4,711', true],
  ['4711', true], ['8, 4,711', true], ['23,456', true], ['#7', true], ['9,999', false], ['4,712', false],
  ['crate nowhere', false]]) {
  if (holds(hay, query) !== found) {
    console.log(`"${query}" ${found ? 'is not found' : 'is found'} in "${hay}"`);
    process.exitCode = 1;
  }
}
"""


# Two movers that touch each other and a part of the city; pages whose contacts are not all there.
WORDS = """
import { counts, gapWords, liveAnswer, liveOthers, liveWhere, notDrawn, rowMost, rowNoun, shortName, whatIsDrawn } from '%(words)s';
import { Entries, NO, PERHAPS, YES } from '%(entries)s';
import { LiveData, whyNot } from '%(live_data)s';
import { argumentOf, poseOf, roundedPlace, turnOf } from '%(pose)s';
const NONE = 0xffffffff;
const page = ({ parts = [0, NONE], complete = true, held = [[0], [1]], all = 2, noun = '', spans = [[3, 9, 7], [3, 9, 3]] }) => ({
  scene: { complete, models: [], parts: ['lid'], row: { one: noun, many: noun && `${noun}s` }, bodies: { names: [], all: 0 }, gaps: { listed: 2, all: 9 },
    contacts: { listed: held.flat().length, all, one: 'contact', many: 'contacts' },
    steps: { kept: [0], count: 1, noun: 'frame' } },
  contacts: { begin: (k) => [3, 5][k], end: (k) => [3, 6][k] },
  rows: { count: parts.length, part: (r, side) => (side === 1 ? parts[r] : NONE), contacts: (r) => held[r],
    total: () => 9, begin: (r) => spans[r][0], end: (r) => spans[r][1], steps: (r) => spans[r][2] },
});
const check = (found, expected) => {
  if (found !== expected) {
    console.log(`"${found}" should be "${expected}"`);
    process.exitCode = 1;
  }
};
check(counts(page({}), 2), 'All 2 pairs of parts or bodies that touch; 2 contacts in all');
check(counts(page({ noun: 'event' }), 2), 'All 2 events; 2 contacts in all');
check(counts(page({ noun: 'event', complete: false }), 1), '1 of 2 events and 2 contacts found so far; there may be more');
check(counts(page({}), 1), '1 of 2 pairs of parts or bodies that touch; 2 contacts in all');
const cut = page({ complete: false, parts: [0, 0] });
check(counts(cut, 2), '2 pairs of parts and 2 contacts found so far; there may be more');
check(whatIsDrawn(cut).includes('all'), false);
check(counts(page({ complete: false, parts: [] }), 0), 'Nothing found so far.');
check(counts(page({ parts: [] }), 0), 'Nothing touches.');
const most = (pairs) => rowMost({ scene: { steps: { noun: 'frame' } }, rows: { mostPairs: () => pairs, mostStep: () => 1234 } }, 0);
check(most(0), '');
check(most(1), 'at most 1 pair of triangles, at frame 1,234');
check(most(4711), 'at most 4,711 pairs of triangles, at frame 1,234');
check(rowNoun(page({ parts: [NONE] }), 1), '1 pair of bodies');
check(counts(page({ parts: [NONE] }), 1), '1 pair of bodies that touches; 2 contacts in all');
check(rowNoun(page({ parts: [0] }), 1), '1 pair of parts');
check(notDrawn(page({})), '');
check(notDrawn(page({ all: 12 })), 'Drawn: 2 of 12 contacts, spread over all 2 pairs of parts or bodies');
check(notDrawn(page({ held: [[0], []], all: 12 })), 'Drawn: 1 of 12 contacts, from 1 of 2 pairs of parts or bodies');
check(shortName('Slab:Level 0:Concrete 250'), 'Slab:Level 0:Concrete 250');
check(shortName('x'.repeat(60) + ' 17'), 'x'.repeat(13) + '...' + 'x'.repeat(25) + ' 17');
check(whatIsDrawn(page({})).includes('gaps: the nearest 2 of 9'), true);
const near = (count, end) => ({
  scene: { bodies: { names: ['car 3', 'wall'] }, steps: { count, noun: 'frame' }, size: 10, scale: 2, origin: [1, 0, 0] },
  gaps: { a: () => 0, b: () => 1, begin: () => 3, end: () => end, nearest: () => 3, lengths: ['2 m'], point: (g, side) => [4 * side, 0, 0] },
});
check(gapWords(near(9, 5), 0), 'car 3 and wall: 2 m at frame 3; near in frames 3 to 5; from (1, 0, 0) to (3, 0, 0)');
check(gapWords(near(9, 3), 0), 'car 3 and wall: 2 m at frame 3; from (1, 0, 0) to (3, 0, 0)');
check(gapWords(near(1, 3), 0), 'car 3 and wall: 2 m; from (1, 0, 0) to (3, 0, 0)');
const named = { scene: { bodies: { names: ['car', 'wall', 'van'] } } };
check(liveAnswer(named, 0, { touched: [], gap: { body: 1, lower: 0.123456 } }, { left: 0 }), 'car touches nothing: 0.1235 from wall');
check(liveAnswer(named, 0, { touched: [], gap: null }, { left: 0 }), 'car touches nothing');
check(liveAnswer(named, 0, { touched: [], gap: null }, { left: 0, known: 10 }), 'car touches nothing; the nearest is at least 9.99 away');
check(liveAnswer(named, 0, { touched: [], gap: null }, { left: 0, known: -1 }),
  'car is where this page does not hold all exact triangles: what it touches is not known here');
check(liveAnswer(named, 0, { touched: [], gap: null }, { left: 2 }), 'car touches nothing that it is compared with');
check(liveAnswer(named, 0, { touched: [{ body: 1, pairs: 1 }] }, { left: 0 }), 'car touches wall: 1 pair of triangles');
check(liveAnswer(named, 0, { touched: [{ body: 1, pairs: 5 }, { body: 2, pairs: 1234 }] }, { left: 0 }),
  'car touches van (1,234), wall (5): 1,239 pairs of triangles');
const known = (near, x, radius) => LiveData.prototype.known.call({ scene: { live: { near } }, middle: () => [0, 0, 0] }, 0,
  [1, 0, 0, x, 0, 1, 0, 5, 0, 0, 1, 5], radius);
check(known([], 5, 2), Infinity);
check(Math.abs(known([[-9, 0, 0, -8, 1, 1], [0, 0, 0, 10, 10, 10]], 4, 1) - 3) < 1e-6, true);
check(known([[0, 0, 0, 10, 10, 10]], 9, 2) < 0, true);
check(liveWhere(named, 0, true, true, -1), 'car is where the report has it.');
check(liveWhere(named, 0, true, false, -1), 'car is where the report has it, rounded.');
check(liveWhere(named, 0, false, false, 1), 'car is moved. wall stays where the report has it, at a pose without a short form.');
check(liveOthers(named, 3, 0), '');
check(liveOthers(named, 1, 7), 'Compared with 1 body; the other movers (7) are left out, as this page holds their poses rounded.');
check(whyNot({ scene: { live: { room: 2e6, models: [] } } }),
  'the exact triangles of its models take more than the 2 MB that a page has room for');
check(whyNot({ scene: { live: { room: 2e6, models: [{}] } } }), 'this browser has no workers'); // node has none of this name
check(argumentOf([1, 0, 0, 0.5, 0, 1, 0, -1e-9, 0, 0, 1, 3]), '0.5 -1e-9 3');
check(argumentOf(poseOf([0, 0, 0.6, 0.8], [1, 2, 3])), '1 2 3 0.8 0 0 0.6');
check(argumentOf([1, 1e-9, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]), null); // within what soms takes as rigid, but of no quaternion
for (const turn of [[0.6, 0, 0, 0.8], [0.8, -0.6, 0, 0], [0, 0, 1, 0], [0.5, 0.5, -0.5, 0.5], [0, 0, 0, 1]]) {
  check(turnOf(poseOf(turn, [0, 0, 0])).map((part) => part.toFixed(12)).join(), turn.map((part) => part.toFixed(12)).join());
}
check(roundedPlace(1.23456789, 4), 1.234568);
check(roundedPlace(123456.789, 4e6), 123457);
const entries = new Entries(page({}));
// The first row touches at each step; of the second three of seven are known, and two contacts are there.
for (const [r, step, expected] of [[0, 2, NO], [0, 4, YES], [1, 3, YES], [1, 4, PERHAPS], [1, 5, YES],
  [1, 8, PERHAPS], [1, 9, YES], [1, 10, NO]]) {
  check(entries.lasts(r, step), expected);
}
"""


# Rows of a clash list: which are shown, in which order, and what is said of them.
CLASH_ROWS = """
import { ClashRows, countWords, detailsOf, pairCounts, rowSentence, sideName } from '%(clash_rows)s';
const check = (found, expected) => {
  if (JSON.stringify(found) !== JSON.stringify(expected)) {
    console.log(`${JSON.stringify(found)} should be ${JSON.stringify(expected)}`);
    process.exitCode = 1;
  }
};
const sides = [
  { file: 'x/a.obj', part: 'Slab', id: null, path: ['Level 1', 'Slab'], index: 0, set: 'slabs' },
  { file: 'b.obj', part: null, id: null, path: [], index: null },
  { file: 'b.obj', part: 'Duct', id: 'guid-9', type: 'IfcDuct', path: ['Duct'], index: 3, odd_edges: 4, set: 'ducts' }];
const rows = [
  { a: 0, b: 1, class: 'touching', relation: 'touching', gap: [0, 0], place: [1, 2, 3], triangle_pairs: 12, status: 'new', key: '00ff' },
  { a: 0, b: 2, class: 'crossing', relation: 'crossing', gap: [0, 0], place: [0, 2, 3], triangle_pairs: 7, status: 'active', key: '11ee', depth: 0.25, group: 'level 1' },
  { a: 0, b: 2, class: 'near', relation: 'clear', gap: [0.5, 0.5], place: null, triangle_pairs: 0, status: 'resolved', key: '22dd', later_key: { x: 1 } }];
const all = { sides, rows, totals: { complete: true } };
check(sides.map(sideName), ['Level 1/Slab', 'b', 'Duct']);
const table = new ClashRows(all);
check(table.columns.map(({ key }) => key), ['number', 'class', 'status', 'group', 'a', 'b', 'gap', 'depth', 'triangle_pairs', 'place']);
check(table.order, [1, 0, 2]); // the worst first
for (const [key, order] of [['class', [2, 0, 1]], ['class', [1, 0, 2]], ['triangle_pairs', [2, 1, 0]], ['gap', [0, 1, 2]], ['gap', [2, 0, 1]],
  ['place', [2, 1, 0]], ['b', [1, 2, 0]], ['status', [1, 0, 2]], ['depth', [0, 2, 1]], ['number', [0, 1, 2]]]) {
  table.sortBy(key);
  check(table.order, order);
}
for (const [query, order] of [['guid-9', [1, 2]], ['IFCDUCT', [1, 2]], ['level slab', [0, 1, 2]], ['x/a.obj 00ff', [0]], ['nothing', []], ['', [0, 1, 2]]]) {
  table.query = query;
  table.sift();
  check(table.order, order);
}
table.hidden.class.add('touching');
table.sift();
check(countWords(table), '2 of 3 rows');
table.hidden.status.add('active');
table.sift();
check(table.order, [2]);
table.hidden.class.clear();
table.hidden.status.clear();
table.pair = { key: 'file', names: ['x/a.obj', 'b.obj'] };
table.sift();
check(countWords(table), 'All 3 rows');
table.pair = { key: 'set', names: ['slabs', 'ducts'] };
table.sift();
check(table.order, [1, 2]);
check(table.counts.class, [['crossing', 1], ['touching', 1], ['near', 1]]);
check(pairCounts(all, 'set'), [{ names: ['slabs', 'ducts'], count: 2 }, { names: ['slabs', ''], count: 1 }]);
const said = detailsOf(all, 2).map(([name, value]) => `${name}: ${value}`).join('; ');
for (const words of ['class: near', 'first part: Level 1/Slab', 'its file: x/a.obj', 'its id: guid-9', 'its odd edges: 4', 'gap: 0.5', 'later key: x: 1', 'gap: 0.5', 'key: 22dd']) {
  check(said.includes(words), true);
}
const deep = rows.map((row, r) => ({ ...row, class: 'crossing', status: undefined, depth: [0.0481876, 0.5, 0.25][r], box: [[0, 1, 2], [3, 4, 5.25]] }));
const sorted = new ClashRows({ ...all, rows: deep });
check(sorted.order, [1, 2, 0]); // the deepest first
const cells = (r) => Object.fromEntries(sorted.columns.map(({ key, text }) => [key, text(deep[r], r)]));
check([cells(0).depth, cells(0).gap, cells(2).gap], ['0.04819', '', '0.5']);
check(new ClashRows({ ...all, rows: deep.slice(0, 2) }).columns.some(({ key }) => key === 'gap'), false);
check(Object.fromEntries(detailsOf({ ...all, rows: deep }, 0)).box, '(0, 1, 2) to (3, 4, 5.25)');
check(rowSentence({ ...all, rows: deep }, 0), 'Level 1/Slab and b: crossing, 0.04819 deep, at (1, 2, 3)');
check(countWords(new ClashRows({ sides, rows: [], totals: { complete: true } })), 'No parts clash.');
const many = Array.from({ length: 100000 }, (_, r) => ({ ...rows[r %% 3], triangle_pairs: r %% 977 }));
const large = new ClashRows({ sides, rows: many, totals: { complete: true } });
large.sortBy('triangle_pairs');
check([large.order.length, many[large.order[0]].triangle_pairs, many[large.order[99999]].triangle_pairs], [100000, 0, 976]);
"""

# The sides of a square and an open line, in no order and no direction.
CHAINS = """
import { chained } from '%(chains)s';
const lines = [[0, 0, 1, 0], [1, 1, 0, 1], [5, 0, 6, 0], [1, 1, 1, 0], [0, 1, 0, 0], [7, 0, 6, 0]];
const given = Float32Array.from(lines.flatMap(([a, b, c, d]) => [a, b, 0, c, d, 0]));
const found = chained(given, 1e-3);
const ends = Array.from({ length: 12 }, (_, k) => found.subarray(3 * k, 3 * k + 3).join());
const breaks = [1, 2, 3, 4, 5].filter((k) => ends[2 * k - 1] !== ends[2 * k]).length;
if (breaks !== 1 || found.length !== given.length || new Set(ends).size !== 7) {
  console.log(`chained: ${ends}`);
  process.exitCode = 1;
}
"""


def run_script(web, script):
    node = shutil.which("node")
    if node is None:
        print("skipped: node is not installed")
        return SKIPPED
    names = {name: (web / f"src/{name}.js").as_uri() for name in ("words", "entries", "live_data", "pose", "clash_rows", "chains")}
    return subprocess.run([node, "--input-type=module", "-e", script % names], check=False).returncode


def main():
    check, web = sys.argv[1], pathlib.Path(sys.argv[2])
    lock = (web / "package-lock.json").read_text(encoding="ascii")
    if "resolved" in lock or "://" in lock:
        print("package-lock.json names the host of a registry")
        return 1
    return {"hash": check_hash, "live_hash": check_live_hash, "rebuild": check_rebuild, "search": lambda web: run_script(web, SEARCH),
            "words": lambda web: run_script(web, WORDS), "clash_rows": lambda web: run_script(web, CLASH_ROWS), "chains": lambda web: run_script(web, CHAINS)}[check](web)


if __name__ == "__main__":
    sys.exit(main())
