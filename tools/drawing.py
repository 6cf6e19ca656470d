"""Lines, words and colors of the drawings of docs/: SVG that is read on a light and on a dark page."""

import look

WIDTH = 640
# class: the name of a color in apps/draw/look.h, and of the one for lines and words where that is too pale for them.
CLASSES = {"card": ("paper",), "rim": ("line",), "ink": ("ink",), "faint": ("faint",), "a": ("body-a",),
           "b": ("body-b", "part"), "both": ("contact",)}


def style():
    def rules(dark):
        made = []
        for name, colors in CLASSES.items():
            fill, line_color = (look.colors()[color][dark] for color in (colors[0], colors[-1]))
            made.append(f".{name}{{fill:{fill}}}.{name}-line{{stroke:{line_color}}}")
            if fill != line_color:
                made.append(f"text.{name}{{fill:{line_color}}}")
        return "".join(made)
    return (f"<style>text{{font-family:Helvetica,Arial,sans-serif;font-size:15px}}"
            f".mono{{font-family:Menlo,Consolas,monospace;font-size:13px}}.strong{{font-weight:bold}}"
            f".line{{fill:none;stroke-width:2;stroke-linejoin:round}}.thick{{stroke-width:5;"
            f"stroke-linecap:round}}.dashed{{stroke-dasharray:5 4}}.pale{{fill-opacity:.3}}"
            f".solid{{fill-opacity:.55}}{rules(0)}"
            f"@media(prefers-color-scheme:dark){{{rules(1)}}}</style>")


def number(x):
    text = f"{x:.1f}"
    return text[:-2] if text.endswith(".0") else text


def points(path):
    return " ".join(f"{number(x)},{number(y)}" for x, y in path)


def polygon(path, classes):
    return f'<polygon points="{points(path)}" class="{classes}"/>'


def line(path, classes):
    return f'<polyline points="{points(path)}" class="line {classes}"/>'


def dot(place, classes, radius=5):
    return f'<circle cx="{number(place[0])}" cy="{number(place[1])}" r="{radius}" class="{classes}"/>'


def box(x, y, width, height, classes, radius=0):
    return (f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" '
            f'height="{number(height)}" rx="{radius}" class="{classes}"/>')


def words(x, y, text, classes="ink", anchor="middle"):
    return f'<text x="{number(x)}" y="{number(y)}" class="{classes}" text-anchor="{anchor}">{text}</text>'


def arrow(start, end, classes):
    (x, y), (u, v) = start, end
    length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
    dx, dy = (u - x) / length, (v - y) / length
    back = [(u - 9 * dx + 4.5 * s * dy, v - 9 * dy - 4.5 * s * dx) for s in (1, -1)]
    return line([start, (u - 8 * dx, v - 8 * dy)], f"{classes}-line") + polygon([end, *back], classes)


def drawing(title, height, parts):
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
        f'height="{height}">', f"<title>{title}</title>", style(),
        box(0.5, 0.5, WIDTH - 1, height - 1, "card rim-line", 8), *parts, "</svg>", ""])
