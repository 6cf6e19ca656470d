"""No test's outcome depends on how fast the machine is: tests wait for events, not for time.

Found are sleeps, clocks and time limits in tests. ALLOWED says for each file that may have some what
they are and why a slow machine changes nothing there (CONTRIBUTING.md, "Tests and the clock").
"""
import pathlib
import re
import sys

SUFFIXES = {".h", ".cpp", ".py", ".sh", ".txt", ".cmake"}
LEAST_GUARD = 1200  # seconds
PATTERNS = {
    "sleep": re.compile(r"\b(?:sleep(?:_for|_until)?|usleep|nanosleep)\s*\(|\bsleep [0-9.]"),
    "pause": re.compile(r"\bwait_at_least\("),
    "wait_for": re.compile(r"[.>]wait_(?:for|until)\(\s*(?:lock|std::chrono|[0-9])"),
    "clock": re.compile(r"\b(?:steady_clock|system_clock|high_resolution_clock)\b|\bstd::clock\(|\bclock_gettime\("
                        r"|\btime\.(?:time|monotonic|perf_counter|process_time)\("),
    "seconds of a child": re.compile(r"\bprocessor_seconds\("),
    "program timeout": re.compile(r"\"timeout\"|(?<![\w-])timeout [-0-9]|\btimeout=(?!None\b)"),
    "alarm": re.compile(r"\b(?:alarm|setitimer|timer_settime)\("),
    "processor limit": re.compile(r"\bRLIMIT_CPU\b|\bulimit -t\b"),
}
TIME_LIMIT = re.compile(r"\"--timeout\",\s*\"([0-9.]+)\"|--timeout ([0-9.]+)")
GUARD = re.compile(r"\bTIMEOUT\s+(\S+?)[\s)]|\b(?:SOMS_TEST_GUARD|PATIENCE|SECONDS)\s*=?\s*([0-9]+)")

DEADLINE = "a deadline that is past, or is doubled until the query has begun, which takes minutes as a whole"
ALLOWED = {
    "tests/structure/clock_test.py": ("*", "these words"),
    "tests/support/wait.h": (("pause",), "the one place where tests wait"),
    "tests/support/wait.cpp": (("sleep", "pause"), "the one place where tests wait: looks at events again and again"),
    "tests/support/effort.h": (("clock",), "processor time as a multiple of that of a fixed calculation"),
    "tests/support/effort.cpp": (("clock", "seconds of a child"), "processor time as a multiple of that of a fixed calculation"),
    "tests/tiles/tile_set_test.cpp": (("clock",), "the least moment, and moments of which any may pass: bounds hold whichever does"),
    "tests/scene/closest_body_test.cpp": (("clock",), "the least moment there is"),
    "tests/scene/body_hit_test.cpp": (("clock",), "the least moment there is"),
    "tests/scene/scene_query_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/detail/engine/limit_test.cpp": (("clock",), "the least and the greatest moment there are"),
    "tests/query/detail/near/point_goal_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/closest_test.cpp": (("clock",), "deadlines, each later than the one before, until the query is complete"),
    "tests/query/solid_test.cpp": (("clock",), "the least moment there is"),
    "tests/clash/clash_test.cpp": (("clock",), "the least moment there is"),
    "tests/robot/robot_path_test.cpp": (("clock",), "the least moment there is"),
    "tests/robot/robot_query_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/contains_parts_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/contains_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/self_overlap_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/signed_closest_test.cpp": (("clock",), "a moment long past"),
    "tests/query/ray_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/distance_cut_test.cpp": (("clock",), "deadlines, each later than the one before, until the query is complete"),
    "tests/motion/first_contact_batch_test.cpp": (("clock",), "the least moment there is"),
    "tests/motion/first_contact_cut_test.cpp": (("clock",), "deadlines, each later than the one before, until the query is complete"),
    "tests/query/winding_test.cpp": (("clock",), "the least moment there is"),
    "tests/query/distance_threads_test.cpp": (("clock",), "deadlines; what is claimed holds wherever they end a query"),
    "tests/query/overlap_test.cpp": (("clock",), DEADLINE),
    "tests/support/truth/query_row_parts.h": (("clock",), DEADLINE),
    "tests/thesis/named_overlap_test.cpp": (("clock",), DEADLINE),
    "tests/base/limits_test.cpp": (("clock",), "the least moment there is, moments that passed, and one that doubles until the step is done"),
    "tests/scene/clearance_along_test.cpp": (("clock",), "the least moment there is"),
    "tests/python/answers_test.py": (("program timeout",), "a parameter of queries: 0, time was up before the start"),
    "tests/python/clash_test.py": (("program timeout",), "a parameter of queries: 0, time was up before the start"),
    "tests/python/motion_test.py": (("program timeout",), "a parameter of queries: 0, time was up before the start"),
    "tests/python/errors_test.py": (("program timeout",), "a parameter of queries that is refused, or 0"),
    "tests/regressions/growth_regressions_test.cpp": (("clock",), "printed, not judged"),
    "tests/commands/output_test.cpp": (("pause",), "a bar shows itself after a second, or later"),
    "tests/view/window/display.h": (("seconds of a child",), "for ViewerTest.RestsWhenPaused"),
    "tests/view/window/display.cpp": (("seconds of a child",), "for ViewerTest.RestsWhenPaused"),
    "tests/view/window/viewer_test.cpp": (("pause", "seconds of a child"),
                                          "waits until no processor time is taken, for as long as that needs"),
    "tests/python/cluster_models.py": (("sleep",), "looks again and again at what processes have written"),
    "tests/report/look.py": (("sleep", "clock"), "looks at a page again and again, within a guard"),
    "tests/docs/examples_test.py": (("clock", "program timeout"), "seconds that are printed, and a guard"),
    "tests/install/bare_debian_test.py": (("clock",), "printed, not judged"),
    "tests/endurance/endurance.py": (("sleep", "clock"), "kills at random moments: any of them is right"),
}
# `--timeout` of the command: time is up in something that never ends by itself, whatever was done by then.
ENDLESS = {
    "tests/commands/bench_test.cpp": "its child sleeps for ever",
    "tests/commands/viewer_test.cpp": "its child sleeps for ever",
    "tests/commands/interrupts_test.cpp": "waits for a pipe that stays silent, or makes a city of minutes; status 4 at any moment",
    "tests/commands/simulate/simulate_options_test.cpp": "places a million movers; status 4 at any moment",
    "tests/commands/pairs/overlap_test.cpp": "0: time was up before the start",
    "tests/view/verbs/render_test.cpp": "0: time was up before the start",
}


def faults_of(inside, text):
    allowed, _ = ALLOWED.get(inside, ((), ""))
    for number, line in enumerate(text.splitlines(), 1):
        place = f"{inside}, line {number}"
        for kind, pattern in PATTERNS.items():
            if pattern.search(line) and allowed != "*" and kind not in allowed:
                yield f"{place}: {kind}: {line.strip()}"
        if allowed == "*":
            continue
        if TIME_LIMIT.search(line) and inside not in ENDLESS:
            yield f"{place}: time limit of the command: {line.strip()}"
        for found in GUARD.finditer(line):
            limit = found.group(1) or found.group(2)
            if limit != "${SOMS_TEST_GUARD}" and (not limit.isdigit() or int(limit) < LEAST_GUARD):
                yield f"{place}: a guard of {limit} s, less than {LEAST_GUARD}"


def main():
    root = pathlib.Path(sys.argv[1])
    files = [f for f in sorted((root / "tests").rglob("*"))
             if f.suffix in SUFFIXES and "data" not in f.relative_to(root / "tests").parts[:1]]
    faults = []
    for file in files:
        inside = str(file.relative_to(root))
        faults += faults_of(inside, file.read_text(encoding="utf-8"))
    for listed in sorted({*ALLOWED, *ENDLESS}):
        if not (root / listed).exists():
            faults.append(f"{listed} is listed here and gone")
    for fault in faults:
        print(fault)
    if faults:
        print("Wait for an event instead (tests/support/wait.h); CONTRIBUTING.md tells more.")
    print(f"{len(files)} files")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
