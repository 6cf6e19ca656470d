#!/usr/bin/env python3
"""The colors of apps/draw/look.h, by name, for drawings and pages that no C++ writes: look.py css prints style rules.

    tools/look.py css > web/demo/colors.css
"""
import pathlib
import re
import sys

TABLE = pathlib.Path(__file__).resolve().parents[1] / "apps" / "draw" / "look.h"


def colors():
    """By the name that CSS has: (light, dark), as #rrggbb."""
    text = TABLE.read_text(encoding="utf-8")
    tones = {name: (f"#{light}", f"#{dark}") for name, light, dark in re.findall(
        r"constexpr Tone (k\w+)\{rgb\(0x([0-9a-f]{6})\),\s*rgb\(0x([0-9a-f]{6})\)\};", text)}
    named = re.findall(r'Named\{"([a-z-]+)", (k\w+)\}', text)
    if not named or {tone for _, tone in named} - set(tones):
        sys.exit(f"{TABLE}: the table of colors has another form than this script knows")
    return {name: tones[tone] for name, tone in named}


def css():
    """As `css_colors` of that header writes them, a line a scheme."""
    light, dark = ("".join(f"--{name}:{tone[scheme]};" for name, tone in colors().items()) for scheme in (0, 1))
    return (f":root{{color-scheme:light dark;{light}}}\n"
            f"@media screen and (prefers-color-scheme:dark){{:root{{{dark}}}}}\n")


if __name__ == "__main__":
    if sys.argv[1:] != ["css"]:
        sys.exit(__doc__)
    sys.stdout.write(css())
