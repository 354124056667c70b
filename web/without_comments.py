"""without_comments.py FROM TO: a script of the page as it is served, without its whole lines of comments and without what
they tell tsc of types: a fifth of its bytes on the wire. tests/page/served.test.mjs sees that nothing else goes."""

import pathlib
import re
import sys


def served(text: str) -> str:
    text = re.sub(r"^ *//.*\n", "", text, flags=re.MULTILINE)
    text = re.sub(r"^ */\*\*(?:(?!\*/).)*\*/\n", "", text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"/\*\* @.*?\*/ ?", "", text)


if __name__ == "__main__":
    read, write = map(pathlib.Path, sys.argv[1:])
    write.write_text(served(read.read_text(encoding="utf-8")), encoding="utf-8")
