"""Charts of the theories, drawn from what the command prints.

    errors(NAME)   error of the force over the creepage in two cases, NAME in colour: `theories/NAME/error.svg`
    times()        error against time of all theories: `theories/theories.svg`; the README has a copy
"""

import csv
import functools
import io
import math
from tables import ROOT, known, printed

WIDTH, HEIGHT = 760, 400
INK, FAINT, GREY, STRONG = "#10243a", "#d5dbe2", "#a9b4bf", "#c62828"
SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
CASES = [
    ("driven wheel", "examples/wheel-on-rail.toml", "longitudinal", -6e-3, 0.0),
    ("wheel in a curve", "examples/wheel-in-curve.toml", "lateral", -6e-3, 6e-3),
]
# What an error below this is called: that of the reference itself.
LEAST = 0.03


@functools.cache
def curves(case):
    """Errors of the force in per cent of mu N over the creepage, by theory."""
    _, file, vary, start, end = case
    names = ",".join(known())
    text = printed("curve", str(ROOT / file), "--theory", names, "--vary", vary,
                   f"--from={start}", f"--to={end}", "--points", "61")
    rows = list(csv.DictReader(io.StringIO(text)))
    forces = {}
    for row in rows:
        forces.setdefault(row["theory"], []).append([float(row[key]) for key in (vary, "fx", "fy")])
    exact = forces.pop("exact")
    return {
        name: [(x, 100 * math.hypot(fx - e[1], fy - e[2])) for (x, fx, fy), e in zip(points, exact)]
        for name, points in forces.items()
    }


class Chart:
    """A panel with axes of which either may be logarithmic, from a corner of the sheet."""

    def __init__(self, box, x, y, logarithmic=(False, False)):
        self.left, self.top, self.right, self.bottom = box
        self.ranges, self.logarithmic, self.parts = (x, y), logarithmic, []

    def at(self, x, y):
        across, up = (self.share(k, value) for k, value in enumerate((x, y)))
        return self.left + across * (self.right - self.left), self.bottom - up * (self.bottom - self.top)

    def share(self, k, value):
        low, high = self.ranges[k]
        if self.logarithmic[k]:
            low, high, value = math.log10(low), math.log10(high), math.log10(max(value, low))
        return min(max((value - low) / (high - low), 0.0), 1.0)

    def ticks(self, k, values, words):
        for value, word in zip(values, words):
            if k == 0:
                x, _ = self.at(value, self.ranges[1][0])
                self.parts.append(f'<path d="M{x:.1f} {self.top}V{self.bottom}" stroke="{FAINT}"/>')
                self.text(x, self.bottom + 20, word, "middle")
            else:
                _, y = self.at(self.ranges[0][0], value)
                self.parts.append(f'<path d="M{self.left} {y:.1f}H{self.right}" stroke="{FAINT}"/>')
                self.text(self.left - 8, y + 5, word, "end")

    def text(self, x, y, words, anchor="start", colour=INK, size=14):
        self.parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}" font-size="{size}">{words}</text>'
        )

    def line(self, points, colour, width):
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in (self.at(*point) for point in points))
        self.parts.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="{width}"/>')

    def dot(self, x, y, colour):
        x, y = self.at(x, y)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{colour}"/>')
        return x, y


def sheet(title, parts):
    body = "\n".join(parts)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
        f'font-family="DejaVu Sans, sans-serif">\n<title>{title}</title>\n'
        f'<rect width="100%" height="100%" fill="#fff"/>\n{body}\n</svg>\n'
    )


def errors(name):
    """Of one theory beside the others; of `exact`, its error bar is meant, and the others are shown."""
    parts = []
    for k, case in enumerate(CASES):
        title, _, vary, start, end = case
        left = 64 + 370 * k
        chart = Chart((left, 44, left + 300, 330), (start, end), (LEAST, 300), (False, True))
        chart.ticks(0, [start, (start + end) / 2, end], [f"{1e3 * x:g}" for x in (start, (start + end) / 2, end)])
        chart.ticks(1, [0.1, 1, 10, 100], ["0.1", "1", "10", "100"])
        for other, points in curves(case).items():
            if other != name:
                chart.line(points, GREY, 1)
        if name in curves(case):
            chart.line(curves(case)[name], STRONG, 2.6)
        chart.text(left, 30, title, size=15)
        chart.text(left + 150, 368, f"{vary} creepage, in thousandths", "middle")
        parts += chart.parts
    others = "in grey the other theories" if name != "exact" else "of the other theories against exact"
    parts.append(f'<text x="64" y="392" font-size="13" fill="{INK}">error of the force in per cent of µN; {others}</text>')
    return sheet(f"Error of the force by {name} over the creepage", parts)


def seconds(cost):
    number, unit = cost.split()
    return float(number) * SECONDS[unit]


def label(chart, name, x, y, taken):
    """Writes a name beside its dot: to the right, above, or below to the left, where there is room."""
    wide = 7.6 * len(name)
    for left, low in [(x + 10, y + 5), (x - wide / 2, y - 11), (x - 4 - wide, y + 20), (x - wide / 2, y + 22)]:
        box = (left, low - 13, left + wide, low + 3)
        if box[2] < WIDTH and all(apart(box, other) for other in taken):
            break
    taken.append(box)
    chart.text(left, low, name)


def apart(one, other):
    return one[2] < other[0] or other[2] < one[0] or one[3] < other[1] or other[3] < one[1]


def times():
    """Error against time of all theories."""
    chart = Chart((70, 24, 730, 330), (1e-9, 1e-2), (0.05, 1000), (True, True))
    chart.ticks(0, [1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2], ["10 ns", "100 ns", "1 µs", "10 µs", "100 µs", "1 ms", "10 ms"])
    chart.ticks(1, [0.1, 1, 10, 100, 1000], ["0.1 %", "1 %", "10 %", "100 %", "1000 %"])
    dots = {
        name: chart.dot(seconds(theory["cost"]), theory["error_percent"], STRONG if name == "exact" else INK)
        for name, theory in known().items()
    }
    taken = [(x - 6, y - 6, x + 6, y + 6) for x, y in dots.values()]
    for name, (x, y) in dots.items():
        label(chart, name, x, y, taken)
    chart.text(400, 368, "time of one force, on one core", "middle")
    chart.text(70, 392, "rms error of the force in per cent of µN, over 132 cases of the full theory", size=13)
    return sheet("Error of the force against the time of one force, all theories", chart.parts)
