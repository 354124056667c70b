#!/usr/bin/env python3
"""job_seconds.py BUILD_FOLDER...: how long a build's jobs took in sum, target by target, from Ninja's own log.

Of use after a build from nothing, without ccache, on an idle machine: CCACHE_DISABLE=1 cmake --build build/release.
"""
import collections
import pathlib
import re
import sys


def jobs(folder):
    """Each job that the folder's files come from, by one of these: (file, seconds)."""
    last = {}
    for line in (folder / ".ninja_log").read_text().splitlines()[1:]:
        start, end, _, file, command = line.split("\t")
        last[file] = int(start), int(end), command
    files = {job: file for file, job in last.items() if (folder / file).exists()}
    return [(file, (end - start) / 1000) for (start, end, _), file in files.items()]


def target_of(file):
    found = re.search(r"CMakeFiles/(\w+)\.dir/", file)
    return found.group(1) if found else "all else"


for name in sys.argv[1:]:
    sums, counts = collections.Counter(), collections.Counter()
    for file, seconds in jobs(pathlib.Path(name)):
        sums[target_of(file)] += seconds
        counts[target_of(file)] += 1
    print(f"{name}: {sum(sums.values()):.0f} job seconds, {sum(counts.values())} jobs")
    for target, seconds in sums.most_common():
        print(f"  {seconds:6.0f} s  {counts[target]:3} jobs  {target}")
