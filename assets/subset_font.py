"""subset_font.py FONT [--code] OUT: keep the characters that Snug writes.

One file serves the page, which uses kerning and tabular figures, and Dear ImGui, whose rasterizer reads
outlines alone: two would be fetched twice.
"""

import sys

from fontTools import subset

ACCENTED = (
    "".join(map(chr, [*range(0xC0, 0xD7), *range(0xD8, 0xF7), *range(0xF8, 0x100)]))
    + "ĀāČčĆćĐđĚěĞğİıŁłŃńŇňŐőŒœŘřŚśŞşŠšŤťŮůŰűŸŹźŻżŽž"
)
# Code and figures, and what Inter lacks.
CODE = (
    "".join(map(chr, range(0x20, 0x7F))) + "\u00a0°±²³µ·¹×÷–—’“”…′″✓✔✕✗✘"
    + "ΓΔΘΛΞΠΣΦΨΩαβγδεζηθικλμνξπρσςτυφχψω"
    + "⁰⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿ₀₁₂₃₄₅₆₇₈₉₊₋"
    + "←↑→↓↔↕↦⇒⇔∀∂∃∅∆∇∈∉∏∑−∓∙√∞∥∩∪∫≈≠≡≤≥⊂⊆⊕⊥⋅⌈⌉⌊⌋⟂⟨⟩‖"
)
WORDS = (
    CODE + ACCENTED + "".join(map(chr, range(0xA0, 0xC0)))
    + "‐‑‒―‘‚„†‡•‰‹›⁄ \u2009\u200a\u202f€™■□▲△▶▷▼◀◁◆◇○●◦★⏎"
)


def main(font_path: str, *flags: str) -> None:
    out_path = flags[-1]
    options = subset.Options(
        layout_features=["kern", "tnum"],
        hinting=False,  # neither browsers at these sizes nor stb_truetype run it
        desubroutinize=True,  # compressed, outlines without subroutines are smaller
        notdef_outline=True,
        name_IDs=[0, 1, 2, 13, 14],  # who made it and its licence stay inside
    )
    font = subset.load_font(font_path, options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=CODE if "--code" in flags else WORDS)
    subsetter.subset(font)
    subset.save_font(font, out_path, options)


main(*sys.argv[1:])
