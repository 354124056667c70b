"""The lessons of a folder while they are being written: what serve.py serves of them."""

import json
import os
import pathlib
import subprocess

from describe_site import course_of, demos_in, slides_in, words_of
from tables import ask, read_demos, tables_of

COURSE = "course.toml"
TYPESET = pathlib.Path(__file__).resolve().parent.parent / "assets/formulas.mjs"


class Drafts:
    def __init__(self, folder: str, site: str):
        self.folder = pathlib.Path(folder)
        self.meshes = pathlib.Path(site) / "meshes"
        self.program = pathlib.Path(site).resolve().parent / "snug_check.js"
        self.told = {}  # by the file's name: its stamp, and what the program reads of it
        self.entries = {}  # the same with what the course's page shows of it
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
        return name in ("course.json", "formulas.json", "preview.json") or name.startswith(("lessons/", "demos/", "checks/"))

    def read(self, name: str) -> bytes:
        """OSError: there is no such file."""
        if name == "preview.json":
            return json.dumps(self.stamps()).encode()
        if name == "course.json":
            return json.dumps(self.course()).encode()
        if name == "formulas.json":
            return json.dumps(self.formulas()).encode()
        if name.startswith("demos/"):
            return self.demo(name.removeprefix("demos/").removesuffix(".json"))
        if name.startswith("checks/"):
            return json.dumps(self.check(name.removeprefix("checks/").removesuffix(".json") + ".toml")).encode()
        name = name.removeprefix("lessons/")
        if name not in self.stamps():
            raise FileNotFoundError(name)
        return (self.folder / name).read_bytes()

    def demo(self, name: str) -> bytes:
        path = self.folder / "demos" / f"{name}.toml"
        if path.parent != self.folder / "demos":
            raise FileNotFoundError(name)
        try:
            return json.dumps(read_demos(self.program, [path])[0]).encode()
        except ValueError as error:  # `snug demo check` says more
            raise FileNotFoundError(name) from error

    def demos(self) -> dict:
        try:
            return demos_in(read_demos(self.program, sorted((self.folder / "demos").glob("*.toml"))))
        except ValueError:
            return {}

    def course(self) -> dict:
        """As its own file says or, where there is none or it has a mistake, all lessons by name."""
        stamps = self.stamps()
        told = self.read_files(stamps)
        lessons = {pathlib.Path(name).stem: self.entry(name, stamp, told.get(name, {})) for name, stamp in stamps.items() if name != COURSE}
        course = {"chapters": [{"title": self.folder.resolve().name, "lessons": list(lessons.values())}]}
        mistake = None
        if COURSE in stamps:
            try:
                course = course_of(self.folder / COURSE, self.course_tables(), lessons)
            except Exception as error:  # whatever is in it
                mistake = str(error) or type(error).__name__
        return course | self.demos() | {"preview": {"files": stamps, "mistake": mistake}}

    def read_files(self, stamps: dict[str, str]) -> dict[str, dict]:
        """What the program reads of each file: {tables} or {mistake}. It is asked once for all that have changed."""
        changed = [name for name, stamp in stamps.items() if self.told.get(name, (None, None))[0] != stamp]
        told = ask(self.program, "read", *(self.folder / name for name in changed)) if changed else {}
        for name in changed:
            self.told[name] = (stamps[name], told[str(self.folder / name)])
        return {name: self.told[name][1] for name in stamps}

    def course_tables(self) -> dict:
        """ValueError: the course's file is no TOML."""
        return tables_of(self.read_files(self.stamps())[COURSE])

    def check(self, name: str) -> dict:
        """What is wrong with a lesson: {heading, lines}. OSError: there is no such file."""
        if name not in self.lessons():
            raise FileNotFoundError(name)
        try:
            ideas = slides_in(self.course_tables()) if COURSE in self.stamps() else {}
        except Exception:  # that file's mistake is told by itself
            ideas = {}
        beside = [pathlib.Path(lesson).stem for lesson in self.lessons()]
        return ask(self.program, "check", self.folder / name, self.meshes, ",".join(beside), ",".join(ideas))

    def entry(self, name: str, stamp: str, told: dict) -> dict:
        """As far as the file says; while it cannot be read at all, as it said before."""
        before, entry = self.entries.get(name, (None, None))
        if before != stamp:
            entry = read_entry(name, told["tables"]) if "tables" in told else entry or draft_entry(name, {})
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


def read_entry(name: str, lesson: dict) -> dict:
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
