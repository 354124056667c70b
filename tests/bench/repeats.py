#!/usr/bin/env python3
"""repeats.py SNUG [RUNS [POINTS]]: whether `snug cost` says the same again, on a machine that does other work beside it.

Of each row that is trusted in two runs or more, how far its medians are apart, in the largest over the smallest.
"""
import json
import subprocess
import sys

snug, runs, points = sys.argv[1], int(sys.argv[2] if len(sys.argv) > 2 else 3), sys.argv[3:] or ["bunny"]
MOST = 1.25

medians, marked = {}, 0
for _ in range(runs):
    table = subprocess.run([snug, "cost", *points, "--json"], capture_output=True, text=True, check=True).stdout
    for row in json.loads(table)["rows"]:
        if row["time_ns"]["trusted"]:
            medians.setdefault((row["volume"], row["algorithm"]), []).append(row["time_ns"]["median"])
        else:
            marked += 1

apart = {row: max(times) / min(times) for row, times in medians.items() if len(times) > 1}
wide = {row: ratio for row, ratio in apart.items() if ratio > MOST}
print(f"{runs} runs: {sum(map(len, medians.values()))} rows trusted, {marked} marked as not; of {len(apart)} rows that "
      f"were trusted twice or more, {len(wide)} are more than {MOST} apart, at most {max(apart.values()):.2f}")
for (volume, algorithm), ratio in sorted(wide.items(), key=lambda entry: -entry[1]):
    print(f"  {volume} {algorithm}: {ratio:.2f}")
