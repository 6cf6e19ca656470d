"""Lines, words and colors of the drawings of docs/: SVG that is read on a light and on a dark page."""

WIDTH = 640
# class: (light, dark); a fill is also what the words of that color are written in.
COLORS = {
    "card": ("#ffffff", "#161b22"), "rim": ("#c9ced4", "#3d444d"), "ink": ("#1f2328", "#e6e8eb"),
    "faint": ("#656d76", "#9da5ae"), "a": ("#0072b2", "#56b4e9"), "b": ("#b35900", "#f0a34a"),
    "both": ("#c2185b", "#ff7eb6"),
}


def style():
    def rules(dark):
        made = []
        for name, colors in COLORS.items():
            made.append(f".{name}{{fill:{colors[dark]}}}.{name}-line{{stroke:{colors[dark]}}}")
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
