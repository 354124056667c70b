"""course_pictures.py: the pictures of the lessons on the course's first page, assets/course/ID.png and ID-dark.png, and
the README's, assets/screenshots/lesson.png.

  course_pictures.py SNUG   draws those that are stale with that program, which needs a display (./run pictures brings one)
  course_pictures.py        says which are stale, and needs neither program nor display: exit status 1 if any is

A picture is stale if what it was drawn from has changed: the lesson, but for its words, which are not in the picture, or
how it is drawn (assets/course/recipe.toml and this file's numbers). The README's shows words, and is stale when they
change as well. What each was drawn from stands as a hash in assets/course/drawn.json.
"""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURES = ROOT / "assets/course"
SIZE = "480x300"
COLOURS = 48
THEMES = {"": "light", "-dark": "dark"}
MOST_BYTES = 15_000
README = {"lesson": "sphere-ritter", "step": "18", "size": "1280x800", "picture": "assets/screenshots/lesson.png"}
# Keys of a lesson that are words, or are asked: the picture shows the stage alone.
WORDS = {"version", "title", "summary", "minutes", "covers", "section", "question", "task", "pseudocode", "meshes", "generators"}


def lessons() -> list[str]:
    course = tomllib.loads((ROOT / "lessons/course.toml").read_text(encoding="utf-8"))
    return [lesson for chapter in course["chapter"] for lesson in chapter["lessons"]]


def recipes() -> dict[str, dict]:
    return tomllib.loads((PICTURES / "recipe.toml").read_text(encoding="utf-8"))


def hash_of(lesson: str, recipe: dict) -> str:
    text = (ROOT / f"lessons/{lesson}.toml").read_text(encoding="utf-8")
    drawn = {key: value for key, value in tomllib.loads(text).items() if key not in WORDS}
    made_of = json.dumps([drawn, recipe, SIZE, COLOURS], sort_keys=True)
    return hashlib.sha256(made_of.encode()).hexdigest()[:16]


def hash_of_readme() -> str:
    text = (ROOT / f"lessons/{README['lesson']}.toml").read_text(encoding="utf-8")
    return hashlib.sha256(json.dumps([text, README], sort_keys=True).encode()).hexdigest()[:16]


def hashes() -> dict[str, str]:
    recipe = recipes()
    return {lesson: hash_of(lesson, recipe[lesson]) for lesson in lessons()} | {"README": hash_of_readme()}


def stale() -> list[str]:
    recipe = recipes()
    if unknown := set(recipe) ^ set(lessons()):
        sys.exit(f"assets/course/recipe.toml and lessons/course.toml differ in {', '.join(sorted(unknown))}")
    kept = PICTURES / "drawn.json"
    drawn = json.loads(kept.read_text()) if kept.exists() else {}
    there = lambda name: name == "README" or all((PICTURES / f"{name}{theme}.png").exists() for theme in THEMES)
    return [name for name, made_of in hashes().items() if not there(name) or drawn.get(name) != made_of]


def draw(snug: str, lesson: str, recipe: dict) -> None:
    for suffix, theme in THEMES.items():
        with tempfile.NamedTemporaryFile(suffix=".png") as large:
            place = ["--step", str(recipe["step"])]
            if "algorithm" in recipe:
                place += ["--algorithm", recipe["algorithm"]]
            subprocess.run([snug, "render", lesson, "--stage", *place, "--size", SIZE, "-o", large.name],
                           check=True, env={**os.environ, "SNUG_THEME": theme})
            small = PICTURES / f"{lesson}{suffix}.png"
            for colours in (COLOURS, COLOURS // 2, COLOURS // 4):
                subprocess.run(["convert", large.name, "+dither", "-colors", str(colours), "-strip", "-define", "png:compression-level=9", f"PNG8:{small}"], check=True)
                if small.stat().st_size <= MOST_BYTES:
                    break


def draw_readme(snug: str) -> None:
    subprocess.run([snug, "render", README["lesson"], "--step", README["step"], "--size", README["size"], "-o", ROOT / README["picture"]],
                   check=True, env={**os.environ, "SNUG_THEME": "light"})


def main(snug: str | None) -> int:
    missing = stale()
    if snug is None:
        for lesson in missing:
            print(f"the picture of {lesson} is stale: ./run pictures draws it anew")
        return 1 if missing else 0
    recipe = recipes()
    for name in missing:
        draw_readme(snug) if name == "README" else draw(snug, name, recipe[name])
        print(f"drawn: {name}")
    drawn = hashes()
    (PICTURES / "drawn.json").write_text(json.dumps(drawn, indent=1) + "\n")
    for picture in PICTURES.glob("*.png"):
        if picture.stem.removesuffix("-dark") not in drawn:
            picture.unlink()
    return 0


sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else None))
