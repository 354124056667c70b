"""describe_site.py PROGRAM.js VERSION INDEX.html SITE COURSE.toml LESSON.toml...: writes what the page must know of its own
files, which a static host does not tell. PROGRAM.js: that of web/check, which reads TOML.

index.html: the page, which asks for all its modules at once: each names the next ones, and to follow them takes a round trip
a level.

cases.json: the same of the named cases, in the folder cases beside the course: the id, title and summary of each, and where a
program failed on it.
write/ID.json: an exercise in which a function is written.
demos/ID.json: a lecturer's demo: its states, each with the address of its place in a lesson, what is shown, and the notes.
course.json: the chapters with their lessons, each with its id, title, summary, minutes, how many predictions it asks for,
whether it has a task, and the words that a search finds it by; the exercises and their sets; and the program's version.
sizes.json: how many bytes each file has, for a loading bar that is true when the transfer is packed; and under "build" what
index.html says as well, for a page that finds itself with another's program.
sw.js: what keeps the page for use without a network, with the hash of each file.
"""

import hashlib
import json
import pathlib
import re
import sys

from tables import read_demos, read_tables
from without_comments import served


def words_of(lesson: dict, slides_of: dict[str, str]) -> str:
    """Slides, headings, terms and algorithms, each once. slides_of: the slide of each idea."""
    slides = [slides_of[idea] for idea in lesson.get("covers", []) if idea in slides_of]
    sections = lesson.get("section", [])
    texts = [re.sub(r"\[([^\]]+)\]\(\w+:[^)]+\)", r"\1", section["text"]) for section in sections]  # a link's words alone
    terms = [term for text in texts for term in re.findall(r"\*\*(.+?)\*\*", text, re.DOTALL) if not re.search(r"[${]", term)]
    algorithms = [name.replace("_", " ") for name in lesson["algorithms"]]
    found = [*slides, *(section["title"] for section in sections), *terms, *algorithms]
    return " · ".join(dict.fromkeys(" ".join(words.split()) for words in found))


def lesson_entry(path: pathlib.Path, lesson: dict, slides_of: dict[str, str]) -> dict:
    shown = {key: lesson[key] for key in ("title", "summary", "minutes")}
    asked = {"questions": len(lesson.get("question", [])), "task": "task" in lesson}
    return {"id": path.stem} | shown | asked | {"words": words_of(lesson, slides_of)}


def case_entry(path: pathlib.Path, lesson: dict) -> dict:
    return {"id": path.stem, "title": lesson["title"], "summary": lesson["summary"], "source": lesson.get("source", "")}


def exercise_entry(path: pathlib.Path, exercise: dict) -> dict:
    shown = {key: exercise[key] for key in ("title", "summary", "minutes")}
    return {"id": path.stem} | shown | {"lesson": exercise["exercise"]["lesson"]}


def sets_of(files: dict[pathlib.Path, dict], written: list[dict]) -> dict:
    """The exercises, and the sets that they stand in. files: those of their folder; written: those in which a function is
    written, which are a set of their own as well."""
    listed = [{"id": f"write:{one['id']}"} | {key: one[key] for key in ("title", "summary", "minutes", "lesson")} for one in written]
    decided = [exercise_entry(path, file) for path, file in sorted(files.items()) if path.name != "sets.toml"]
    exercises = {one["id"]: one for one in [*decided, *listed]}
    sets = [one for path, file in files.items() if path.name == "sets.toml" for one in file["set"]]
    filled = [one | {"exercises": [exercises[name] for name in one["exercises"]]} for one in sets]
    own = {"id": "write", "title": "Write it yourself", "lecture": "", "exercises": listed}
    return {"sets": [*filled, *([own] if listed else [])], "exercises": list(exercises.values())}


def write_of(path: pathlib.Path, file: dict) -> dict:
    """An exercise in which a function is written, without the mistakes that its test tries."""
    shown = {key: file[key] for key in ("title", "summary", "minutes", "lesson", "contract", "stub", "model", "reasons")}
    return {"id": path.stem} | shown | {"methods": [{"title": one["title"], "code": one["code"]} for one in file.get("method", [])]}


def demos_in(demos: list[dict]) -> dict:
    """What the course's page lists of them. demos: as read_demos gives them."""
    return {"demos": [{"id": demo["id"], "title": demo["title"], "states": len(demo["states"])} for demo in demos]}


def slides_in(course: dict) -> dict[str, str]:
    """The slide of each idea that the course lists."""
    return {idea["id"]: idea["slide"] for idea in course.get("idea", [])}


def course_of(path: pathlib.Path, course: dict, lessons: dict[str, dict]) -> dict:
    chapters = course["chapter"]
    named = [lesson for chapter in chapters for lesson in chapter["lessons"]]
    if sorted(named) != sorted(lessons):
        raise ValueError(f"{path} does not name each lesson once: `snug lesson check {path}` says more")
    return {"playground": course.get("playground", ""), "chapters": [{"title": chapter["title"], "lessons": [lessons[lesson] for lesson in chapter["lessons"]]} for chapter in chapters]}


def write(path: pathlib.Path, what) -> None:
    path.write_text(json.dumps(what, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")


def modules_of(page: pathlib.Path, name: str) -> list[str]:
    """The modules that one imports, directly or not, without those that it loads later."""
    found, open_ = [], [name]
    while open_:
        for other in re.findall(r'^import .* from "\./(.+)";$', (page / open_.pop()).read_text(encoding="utf-8"), re.MULTILINE):
            if other not in found:
                found.append(other)
                open_.append(other)
    return sorted(found)


def hash_of(path: pathlib.Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()[:16]


def hashes_of(site: pathlib.Path) -> dict[str, str]:
    """The hash of each file of the site but of the one that lists them."""
    files = sorted(path for path in site.rglob("*") if path.is_file() and path.name != "sw.js")
    return {path.relative_to(site).as_posix(): hash_of(path) for path in files}


def build_of(site: pathlib.Path) -> str:
    """What the program, the scripts and the styles are, in a few letters."""
    parts = sorted(path for path in site.iterdir() if path.suffix in (".js", ".css", ".wasm") and path.name != "sw.js")
    return hashlib.sha256("".join(map(hash_of, parts)).encode()).hexdigest()[:16]


def with_modules(first_page: pathlib.Path, build: str) -> str:
    text = first_page.read_text(encoding="utf-8").replace("</title>\n", f'</title>\n<meta name="snug-build" content="{build}">\n', 1)
    links = "".join(f'<link rel="modulepreload" href="{name}">\n' for name in ["main.js", *modules_of(first_page.parent, "main.js")])
    return text.replace("<script src", links + "<script src", 1)


def main(program: pathlib.Path, version: str, first_page: pathlib.Path, site: pathlib.Path, course: pathlib.Path, lesson_files: list[pathlib.Path]) -> None:
    try:
        folders = {name: sorted((course.parent / name).glob("*.toml")) for name in ("cases", "exercises", "demos", "write")}
        others = [path for name, paths in folders.items() if name != "demos" for path in paths]
        read = read_tables(program, [course, *lesson_files, *others])
        files_of = lambda name: {path: read[path] for path in folders[name]}
        cases = {path.stem: case_entry(path, file) for path, file in files_of("cases").items() if path.name != course.name}
        cases_file = course.parent / "cases" / course.name
        write(site / "cases.json", course_of(cases_file, read[cases_file], cases))
        slides = slides_in(read[course])
        lessons = {path.stem: lesson_entry(path, read[path], slides) for path in lesson_files}
        demos = read_demos(program, folders["demos"])
        (site / "demos").mkdir(exist_ok=True)
        for demo in demos:
            write(site / "demos" / f"{demo['id']}.json", demo)
        written = [write_of(path, file) for path, file in files_of("write").items()]
        (site / "write").mkdir(exist_ok=True)
        for one in written:
            write(site / "write" / f"{one['id']}.json", one)
        parts = sets_of(files_of("exercises"), written) | demos_in(demos) | {"version": version}
        write(site / "course.json", course_of(course, read[course], lessons) | parts)
    except ValueError as error:
        sys.exit(str(error))
    build = build_of(site)
    (site / "index.html").write_text(with_modules(first_page, build), encoding="utf-8")
    files = (path for path in sorted(site.rglob("*")) if path.is_file() and path.name not in ("sizes.json", "sw.js"))
    sizes = {path.relative_to(site).as_posix(): path.stat().st_size for path in files}
    write(site / "sizes.json", {"build": build} | sizes)
    worker = (pathlib.Path(__file__).parent / "sw.js").read_text(encoding="utf-8")
    listed = f"const files = {json.dumps(hashes_of(site))};\n"
    (site / "sw.js").write_text(served(re.sub(r"^const files = .*\n", listed, worker, flags=re.MULTILINE)), encoding="utf-8")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), sys.argv[2], *(pathlib.Path(name) for name in sys.argv[3:6]), [pathlib.Path(name) for name in sys.argv[6:]])
