"""size_report.py SITE: what a first view transfers, gzipped, against the budget of 700 kB.

Counts the whole site but the dragon, which loads only when a lesson asks for it.
"""

import gzip
import pathlib
import sys

BUDGET = 700_000
LATER = {"meshes/dragon.ply"}
PACKED_ALREADY = {".png"}


def transfer(path):
    plain = path.read_bytes()
    return len(plain) if path.suffix in PACKED_ALREADY else len(gzip.compress(plain, 6))


site = pathlib.Path(sys.argv[1])
total = 0
for path in sorted(path for path in site.rglob("*") if path.is_file()):
    name = path.relative_to(site).as_posix()
    size = transfer(path)
    if name in LATER:
        print(f"{size:9,}  {name} (later)")
    else:
        total += size
        print(f"{size:9,}  {name}")
print(f"{total:9,}  of {BUDGET:,} bytes")
sys.exit(total > BUDGET)
