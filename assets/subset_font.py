"""subset_font.py FONT OUT: keep the characters that Snug writes.

OUT ending in .woff2 is for the page and keeps kerning and tabular figures. Anything else is for
Dear ImGui, whose rasterizer reads outlines and no layout tables.
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
    for_page = out_path.endswith(".woff2")
    options = subset.Options(
        flavor="woff2" if for_page else None,
        layout_features=["kern", "mark", "ccmp", "tnum", "case"] if for_page else [],
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
