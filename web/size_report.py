"""size_report.py SITE: what a first view transfers at most, gzipped, against the budget of 700 kB.

A view loads one lesson and, where its link asks for one, one mesh: the largest of each is counted. Not the dragon, which
loads only when somebody chooses it.
"""

import gzip
import pathlib
import sys

BUDGET = 700_000
LATER = {"meshes/dragon.ply"}
ONE_OF = {"meshes", "lessons"}  # folders; their indexes are always loaded
PACKED_ALREADY = {".png"}


def transfer(path):
    plain = path.read_bytes()
    return len(plain) if path.suffix in PACKED_ALREADY else len(gzip.compress(plain, 6))


site = pathlib.Path(sys.argv[1])
total = 0
largest = dict.fromkeys(ONE_OF, 0)
for path in sorted(path for path in site.rglob("*") if path.is_file()):
    name = path.relative_to(site).as_posix()
    folder = name.split("/")[0]
    size = transfer(path)
    if name in LATER:
        print(f"{size:9,}  {name} (later)")
        continue
    print(f"{size:9,}  {name}")
    if folder in ONE_OF and path.suffix != ".json":
        largest[folder] = max(largest[folder], size)
    else:
        total += size
total += sum(largest.values())
print(f"{total:9,}  of {BUDGET:,} bytes, with the largest lesson and mesh")
sys.exit(total > BUDGET)
