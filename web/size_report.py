"""size_report.py SITE: what a first view transfers at most, gzipped, against the budget of 700 kB.

A view loads one lesson, the program that runs it and, where its link asks for one, one mesh: the largest of each is counted.
Not the dragon, which loads only when somebody chooses it.
"""

import gzip
import json
import pathlib
import sys

BUDGET = 700_000
LATER = {"meshes/dragon.ply"}
ONE_OF = {"programs", "meshes", "lessons"}  # folders; their indexes are always loaded
PACKED_ALREADY = {".png"}


def transfer(path):
    plain = path.read_bytes()
    return len(plain) if path.suffix in PACKED_ALREADY else len(gzip.compress(plain, 6))


site = pathlib.Path(sys.argv[1])
sizes = {path.relative_to(site).as_posix(): transfer(path) for path in sorted(site.rglob("*")) if path.is_file()}
for name, size in sizes.items():
    print(f"{size:9,}  {name}{' (later)' if name in LATER else ''}")

lessons = json.loads((site / "lessons/index.json").read_text(encoding="utf-8"))
always = sum(size for name, size in sizes.items() if name.endswith(".json") or name.split("/")[0] not in ONE_OF)
mesh = max(size for name, size in sizes.items() if name.startswith("meshes/") and name not in LATER)
worst = 0
for program in sorted({lesson["program"] for lesson in lessons}):
    lesson = max(sizes[f"lessons/{lesson['id']}.toml"] for lesson in lessons if lesson["program"] == program)
    total = always + mesh + lesson + sizes[f"programs/{program}.mjs"] + sizes[f"programs/{program}.wasm"]
    print(f"{total:9,}  of {BUDGET:,} bytes: {program}, with its largest lesson and the largest mesh")
    worst = max(worst, total)
sys.exit(worst > BUDGET)
