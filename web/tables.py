"""The tables of TOML files, as the program reads them: there is no second reader."""

import json
import pathlib
import subprocess


def ask(program: pathlib.Path, *words: str | pathlib.Path) -> dict:
    """Returns the answer of web/check/main.cpp. Raises OSError, ValueError or subprocess.SubprocessError if there is none."""
    # Emscripten 3.1.6 mistakes Node for a browser when it finds fetch.
    command = ["node", "--no-experimental-fetch", program, *words]
    return json.loads(subprocess.run(command, capture_output=True, check=True, timeout=60).stdout)


def tables_of(told: dict) -> dict:
    """ValueError: the file is no TOML; it says where."""
    if "mistake" in told:
        raise ValueError(told["mistake"])
    return told["tables"]


def read_tables(program: pathlib.Path, paths: list[pathlib.Path]) -> dict[pathlib.Path, dict]:
    """ValueError: one of the files is no TOML; it says which and where."""
    told = ask(program, "read", *paths) if paths else {}
    return {path: tables_of(told[str(path)]) for path in paths}


def read_demos(program: pathlib.Path, paths: list[pathlib.Path]) -> list[dict]:
    """What the page needs of each: of a state its address as a lesson, what is shown, and the notes. ValueError: one of
    the files has a mistake; it says which and where."""
    told = ask(program, "demos", *paths) if paths else {}
    for path in paths:
        if "mistake" in told[str(path)]:
            raise ValueError(told[str(path)]["mistake"])
    return [told[str(path)] for path in paths]
