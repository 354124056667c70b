"""The lessons of a folder while they are being written: what serve.py serves of them."""

import json
import os
import pathlib
import subprocess
import tomllib

from describe_site import course_of, words_of

COURSE = "course.toml"
TYPESET = pathlib.Path(__file__).resolve().parent.parent / "assets/formulas.mjs"


class Drafts:
    def __init__(self, folder: str):
        self.folder = pathlib.Path(folder)
        self.entries = {}  # by the file's name: its stamp, and what the course's page shows of it
        self.typeset = {}  # the same with its formulas

    def wrong(self) -> str | None:
        """Why the folder cannot be served; None if it can."""
        if not self.folder.is_dir():
            return f"{self.folder} is not a folder: --lessons takes the one that your lessons are in."
        if not self.lessons():
            return f"{self.folder} has no lesson: none of its files ends in .toml."
        return None

    def stamps(self) -> dict[str, str]:
        """What changes with each file, by its name. Hidden files are an editor's own."""
        files = {}
        for entry in sorted(os.scandir(self.folder), key=lambda entry: entry.name):
            if entry.name.endswith(".toml") and not entry.name.startswith(".") and os.path.isfile(entry.path):
                status = os.stat(entry.path)
                files[entry.name] = f"{status.st_mtime_ns} {status.st_size}"
        return files

    def lessons(self) -> list[str]:
        return [name for name in self.stamps() if name != COURSE]

    def has(self, name: str) -> bool:
        """Whether a path of the site is answered from the folder, or not at all: the site's own lessons are not there."""
        return name in ("course.json", "formulas.json", "preview.json") or name.startswith("lessons/")

    def read(self, name: str) -> bytes:
        """OSError: there is no such file."""
        if name == "preview.json":
            return json.dumps(self.stamps()).encode()
        if name == "course.json":
            return json.dumps(self.course()).encode()
        if name == "formulas.json":
            return json.dumps(self.formulas()).encode()
        name = name.removeprefix("lessons/")
        if name not in self.stamps():
            raise FileNotFoundError(name)
        return (self.folder / name).read_bytes()

    def course(self) -> dict:
        """As its own file says or, where there is none or it has a mistake, all lessons by name."""
        stamps = self.stamps()
        lessons = {pathlib.Path(name).stem: self.entry(name, stamp) for name, stamp in stamps.items() if name != COURSE}
        course = {"chapters": [{"title": self.folder.resolve().name, "lessons": list(lessons.values())}]}
        mistake, ideas = None, []
        if COURSE in stamps:
            try:
                course = course_of(self.folder / COURSE, lessons)
                ideas = [idea["id"] for idea in tomllib.loads((self.folder / COURSE).read_text(encoding="utf-8")).get("idea", [])]
            except Exception as error:  # whatever is in it
                mistake = str(error) or type(error).__name__
        return course | {"preview": {"files": stamps, "mistake": mistake, "ideas": ideas}}

    def entry(self, name: str, stamp: str) -> dict:
        """As far as the file says; while it cannot be read at all, as it said before."""
        before, entry = self.entries.get(name, (None, None))
        if before != stamp:
            entry = self.read_entry(name) or entry or draft_entry(name, {})
            self.entries[name] = (stamp, entry)
        return entry

    def formulas(self) -> dict[str, str]:
        """Those of all lessons, typeset; of one that has a wrong formula, as they were before."""
        for name, stamp in self.stamps().items():
            before, formulas = self.typeset.get(name, (None, {}))
            if before != stamp:
                self.typeset[name] = (stamp, self.read_formulas(name) or formulas)
        return {tex: math for _, formulas in self.typeset.values() for tex, math in formulas.items()}

    def read_formulas(self, name: str) -> dict[str, str]:
        path = self.folder / name
        try:
            if b"$" not in path.read_bytes():
                return {}
            made = subprocess.run(["node", TYPESET, path, "/dev/stdout"], capture_output=True, check=True, timeout=20)
            return json.loads(made.stdout)
        except (OSError, ValueError, subprocess.SubprocessError):
            return {}  # they stand on one line then

    def read_entry(self, name: str) -> dict | None:
        """None: it cannot be read. The page says what is wrong with it."""
        try:
            lesson = tomllib.loads((self.folder / name).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        try:
            return draft_entry(name, lesson) | {"words": words_of(lesson, {})}
        except Exception:  # a key of it is missing, or is something else
            return draft_entry(name, lesson)


def draft_entry(name: str, lesson: dict) -> dict:
    """What the course's page shows of a lesson that may lack anything."""
    stem = pathlib.Path(name).stem
    told = lambda key, kind, otherwise: lesson[key] if isinstance(lesson.get(key), kind) else otherwise
    shown = {"title": told("title", str, stem), "summary": told("summary", str, ""), "minutes": told("minutes", int, 0)}
    return {"id": stem, "picture": False, "words": "", "questions": len(told("question", list, [])), "task": "task" in lesson} | shown
