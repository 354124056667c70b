"""subset_font.py FONT OUT: keep the characters that Snug writes.

One file serves the page, which uses kerning and tabular figures, and Dear ImGui, whose rasterizer reads
outlines alone: two would be fetched twice.
"""

import sys

from fontTools import subset

CHARACTERS = (
    "".join(map(chr, [*range(0x20, 0x7F), *range(0xA0, 0x100)]))  # Basic Latin, Latin-1
    + "ĀāČčĆćĐđĚěĞğİıŁłŃńŇňŐőŒœŘřŚśŞşŠšŤťŮůŰűŸŹźŻżŽž"
    + "ΓΔΘΛΞΠΣΦΨΩαβγδεζηθικλμνξπρσςτυφχψω"
    + "‐‑‒–—―‘’‚“”„†‡•…‰′″‹›⁄ \u2009\u200a\u202f"
    + "⁰⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ⁿ₀₁₂₃₄₅₆₇₈₉₊₋€™"
    + "←↑→↓↔↕↦⇒⇔∀∂∃∅∆∇∈∉∏∑−∓∙√∞∥∩∪∫≈≠≡≤≥⊂⊆⊕⊥⋅⌈⌉⌊⌋⟂⟨⟩‖"
    + "■□▲△▶▷▼◀◁◆◇○●◦★✓✔✕✗✘⏎"
)


def main(font_path: str, out_path: str) -> None:
    options = subset.Options(
        layout_features=["kern", "mark", "ccmp", "tnum", "case"],
        hinting=False,  # neither browsers at these sizes nor stb_truetype run it
        notdef_outline=True,
        name_IDs=[0, 1, 2, 13, 14],  # who made it and its licence stay inside
    )
    font = subset.load_font(font_path, options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=CHARACTERS)
    subsetter.subset(font)
    subset.save_font(font, out_path, options)


main(*sys.argv[1:])
