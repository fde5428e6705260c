"""The README's pictures and numbers are those of today, or the build ends and says what to do.

Its pictures are `docs/theories.svg`, see `charts.py`, and `docs/wheel-on-rail.png`.
"""

import tempfile
from pathlib import Path

from charts import times
from tables import ROOT, known, percent, printed, units


def check():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    for name, theory in known().items():
        rows = [line for line in text.splitlines() if line.startswith(f"| `{name}` |")]
        cells = [f"| {percent(theory['error_percent'] / 100)} | ", units(theory["cost"]).replace("130 µs", "0.13 ms")]
        if len(rows) != 1 or not all(cell in rows[0] for cell in cells):
            raise ValueError(f"README.md: the row of `{name}` lacks {' or '.join(cells)}")
    same("theories.svg", times().encode())
    with tempfile.TemporaryDirectory() as place:
        printed("solve", str(ROOT / "examples" / "wheel-on-rail.toml"), "--out", place)
        same("wheel-on-rail.png", (Path(place) / "contact.png").read_bytes())


def same(name, made):
    kept = ROOT / "docs" / name
    if kept.exists() and kept.read_bytes() == made:
        return
    fresh = Path(tempfile.mkdtemp()) / name
    fresh.write_bytes(made)
    raise ValueError(f"docs/{name} is not what it would be today: cp {fresh} docs/")
