"""size_report.py SITE: what a first view transfers at most, gzipped, against a budget.

A view loads the program, one lesson and, where its link asks for one, one mesh: the largest of each is counted.
Not the dragon, which loads only when somebody chooses it, nor the preview, which only lessons that are being written
load, nor the course's pictures, which its own page loads, nor the gallery's list, which loads when it is opened, nor what
only packages, embedded exercises, demos, code that is written, the dialog to share, and what keeps the page for use without a network load.
"""

import gzip
import pathlib
import sys

BUDGET = 1_554_500
LATER = {"meshes/dragon.ply", "preview.js", "cases.json", "packaged.js", "packaged.css", "scorm.js", "course_text.js", "inside.js", "splice.js", "share.js", "share.css",
         "offline.js", "updated.js", "sw.js", "demo.js", "demo.css", "demo_notes.js", "demo_record.js", "demo_text.js",
         "lecture.js", "lecture_program.js", "lecture_program.wasm", "vote.js", "qr.js", "hall.js", "hall.css", "keys_card.js", "sheet.js", "pictures.js", "picture_bytes.js", "gifenc.js", "write.js", "write_cost.js", "write.css"}
ONE_OF = {"meshes", "lessons", "course", "demos", "write"}  # folders of which not all is loaded
PACKED_ALREADY = {".png"}


def transfer(path):
    plain = path.read_bytes()
    return len(plain) if path.suffix in PACKED_ALREADY else len(gzip.compress(plain, 6))


site = pathlib.Path(sys.argv[1])
sizes = {path.relative_to(site).as_posix(): transfer(path) for path in sorted(site.rglob("*")) if path.is_file()}
for name, size in sizes.items():
    print(f"{size:9,}  {name}{' (later)' if name in LATER else ''}")

always = sum(size for name, size in sizes.items() if name not in LATER and name.split("/")[0] not in ONE_OF)
one_of = [max(size for name, size in sizes.items() if name.startswith(folder) and name not in LATER) for folder in ("lessons/", "meshes/")]
total = always + sum(one_of)
print(f"{total:9,}  of {BUDGET:,} bytes: the first view, with the largest lesson and the largest mesh")
sys.exit(total > BUDGET)
