#!/usr/bin/env python3
"""Numerical stability, stressed: runs small scenes and judges them by numbers.

    tests/stability/stability.py build/rift results/stability --doc doc/stability.md

makes all runs (some minutes), leaves scenes, meshes and results in the second
folder and writes the table between the markers of the file. --quick makes a small
version, as ctest does; --only picks a case by its name.
"""
import argparse
import concurrent.futures
import sys
import time

from cases import CASES
from scenes import Workshop

BEGIN = "<!-- Written by tests/stability/stability.py: -->\n"
END = "<!-- End of what is written. -->\n"


def table(rows):
    text = ("| Case | What is done | Expected | What came out | |\n"
            "|---|---|---|---|---|\n")
    for case, row in rows:
        verdict = "passed" if row.passed else "**failed**"
        text += (f"| {case} | {row.done} | {row.expected} | {row.found} "
                 f"| {verdict} |\n")
    return text


def write_between_markers(path, text):
    with open(path) as file:
        old = file.read()
    before, rest = old.split(BEGIN)
    after = rest.split(END)[1]
    with open(path, "w") as file:
        file.write(before + BEGIN + text + END + after)


def make_runs(shop, name, quick):
    """The rows of a case, which are printed as they come."""
    begin, rows = time.monotonic(), []
    for row in CASES[name](shop, quick):
        rows.append(row)
        verdict = "passed" if row.passed else "FAILED"
        print(f"{verdict}: {row.done}: {row.found} (expected: {row.expected})",
              flush=True)
    print(f"{name}: {time.monotonic() - begin:.1f} s", flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("rift", help="the program")
    parser.add_argument("work", help="folder for scenes and results")
    parser.add_argument("--quick", action="store_true", help="a small version")
    parser.add_argument("--only", action="append", choices=list(CASES), metavar="CASE",
                        help="one of: " + ", ".join(CASES))
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time")
    parser.add_argument("--doc", help="file with the markers of the table")
    arguments = parser.parse_args()

    start = time.monotonic()
    shop = Workshop(arguments.rift, arguments.work)
    names = arguments.only or list(CASES)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for name, of_case in zip(names, pool.map(
                lambda name: make_runs(shop, name, arguments.quick), names)):
            rows += [(name, row) for row in of_case]
    n_failed = sum(not row.passed for _, row in rows)
    summary = (f"{len(rows)} runs or series of runs in "
               f"{time.monotonic() - start:.0f} s: {len(rows) - n_failed} passed, "
               f"{n_failed} failed.")
    print(summary)
    if arguments.doc:
        write_between_markers(arguments.doc, f"{summary}\n\n" + table(rows))
    sys.exit(n_failed > 0)


if __name__ == "__main__":
    main()
