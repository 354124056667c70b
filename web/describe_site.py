"""describe_site.py VERSION INDEX.html SITE COURSE.toml LESSON.toml...: writes what the page must know of its own files, which a
static host does not tell.

index.html: the page, which asks for all its modules at once: each names the next ones, and to follow them takes a round trip
a level.

cases.json: the same of the named cases, in the folder cases beside the course: the id, title and summary of each, and where a
program failed on it.
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
import tomllib
import urllib.parse

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


def lesson_entry(path: pathlib.Path, slides_of: dict[str, str]) -> dict:
    lesson = tomllib.loads(path.read_text(encoding="utf-8"))
    shown = {key: lesson[key] for key in ("title", "summary", "minutes")}
    asked = {"questions": len(lesson.get("question", [])), "task": "task" in lesson}
    return {"id": path.stem} | shown | asked | {"words": words_of(lesson, slides_of)}


def case_entry(path: pathlib.Path) -> dict:
    lesson = tomllib.loads(path.read_text(encoding="utf-8"))
    return {"id": path.stem, "title": lesson["title"], "summary": lesson["summary"], "source": lesson.get("source", "")}


def exercise_entry(path: pathlib.Path) -> dict:
    exercise = tomllib.loads(path.read_text(encoding="utf-8"))
    shown = {key: exercise[key] for key in ("title", "summary", "minutes")}
    return {"id": path.stem} | shown | {"lesson": exercise["exercise"]["lesson"]}


def sets_of(folder: pathlib.Path) -> dict:
    """The exercises, and the sets that they stand in."""
    exercises = {path.stem: exercise_entry(path) for path in sorted(folder.glob("*.toml")) if path.name != "sets.toml"}
    sets = tomllib.loads((folder / "sets.toml").read_text(encoding="utf-8"))["set"] if exercises else []
    filled = [one | {"exercises": [exercises[name] for name in one["exercises"]]} for one in sets]
    return {"sets": filled, "exercises": list(exercises.values())}


ADDRESS_KEYS = {"lesson": "lesson", "step": "step", "seed": "seed", "situation": "situation", "algorithm": "a", "compare": "b", "scalar": "scalar", "from": "from", "sliders": "slide", "moved": "moved", "rows": "rows"}


def demo_state(state: dict) -> dict:
    """What the page needs of it: its address as a lesson, and what is said and shown."""
    place = {"step": 0} | state
    address = urllib.parse.urlencode({name: place[key] for key, name in ADDRESS_KEYS.items() if key in place}, safe=",;:")
    return {"address": "?" + address, "shows": state.get("shows", ["caption"]), "reveal": state.get("reveal", []), "slide": state["slide"], "notes": " ".join(state["notes"].split()), "hash": state.get("hash", "")}


def demo_of(path: pathlib.Path) -> dict:
    demo = tomllib.loads(path.read_text(encoding="utf-8"))
    return {"id": path.stem, "title": demo["title"], "lecture": demo["lecture"], "states": [demo_state(state) for state in demo["state"]]}


def slides_in(course: pathlib.Path) -> dict[str, str]:
    """The slide of each idea that the course lists."""
    return {idea["id"]: idea["slide"] for idea in tomllib.loads(course.read_text(encoding="utf-8")).get("idea", [])}


def course_of(path: pathlib.Path, lessons: dict[str, dict]) -> dict:
    course = tomllib.loads(path.read_text(encoding="utf-8"))
    chapters = course["chapter"]
    named = [lesson for chapter in chapters for lesson in chapter["lessons"]]
    if sorted(named) != sorted(lessons):
        raise ValueError(f"{path} does not name each lesson once: `snug lesson check {path}` says more")
    return {"playground": course.get("playground", ""), "chapters": [{"title": chapter["title"], "lessons": [lessons[lesson] for lesson in chapter["lessons"]]} for chapter in chapters]}


def write(path: pathlib.Path, what: dict) -> None:
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


def main(version: str, first_page: pathlib.Path, site: pathlib.Path, course: pathlib.Path, lesson_files: list[pathlib.Path]) -> None:
    try:
        cases = course.parent / "cases"
        write(site / "cases.json", course_of(cases / course.name, {path.stem: case_entry(path) for path in cases.glob("*.toml") if path.name != course.name}))
        lessons = {path.stem: lesson_entry(path, slides_in(course)) for path in lesson_files}
        exercises = sets_of(course.parent / "exercises")
        (site / "demos").mkdir(exist_ok=True)
        for demo in (course.parent / "demos").glob("*.toml"):
            write(site / "demos" / f"{demo.stem}.json", demo_of(demo))
        write(site / "course.json", course_of(course, lessons) | exercises | {"version": version})
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
    main(sys.argv[1], *(pathlib.Path(name) for name in sys.argv[2:5]), [pathlib.Path(name) for name in sys.argv[5:]])
