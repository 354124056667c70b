"""describe_site.py SITE LESSON.toml...: writes what the page must know of its own files, which a static host does not tell.

lessons/index.json: each lesson's id, group, title, summary and order, in the order of the menu.
sizes.json: how many bytes each file has, for a loading bar that is true when the transfer is packed.
"""

import json
import pathlib
import sys
import tomllib

SHOWN = ("group", "title", "summary", "order")


def lesson_entry(path: pathlib.Path) -> dict:
    lesson = tomllib.loads(path.read_text(encoding="utf-8"))
    return {"id": path.stem} | {key: lesson[key] for key in SHOWN if key in lesson}


def main(site: pathlib.Path, lesson_files: list[pathlib.Path]) -> None:
    lessons = [lesson_entry(path) for path in lesson_files]
    lessons.sort(key=lambda lesson: (lesson.get("order", 0), lesson["id"]))
    (site / "lessons").mkdir(exist_ok=True)
    (site / "lessons/index.json").write_text(json.dumps(lessons, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    files = (path for path in sorted(site.rglob("*")) if path.is_file() and path.name != "sizes.json")
    sizes = {path.relative_to(site).as_posix(): path.stat().st_size for path in files}
    (site / "sizes.json").write_text(json.dumps(sizes, indent=1) + "\n", encoding="utf-8")


main(pathlib.Path(sys.argv[1]), [pathlib.Path(name) for name in sys.argv[2:]])
