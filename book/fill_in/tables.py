"""Fills in what the command or another file of the repository knows, so that no page repeats it.

    <!-- facts NAME -->            a theory's year, assumption, cost and range
    <!-- accuracy -->              the measured error of all theories
    <!-- accuracy NAME -->         that of one theory and its variants
    <!-- theories -->              the list of theories, with links to their pages
    <!-- file PATH -->             a file of the repository
    <!-- file PATH: HEADING -->    one part of it
"""

import functools
import json
import os
import posixpath
import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CREEPAGE = os.environ["CREEPAGE"]
UNITS = "\n\n*In per cent of $\\mu N$ and of $\\mu N c$, over [132 cases](../accuracy.md) of the full theory.*"
MEASURES = ["median", "mean", "rms", "p95", "worst"]


def printed(*arguments):
    """What the command prints."""
    ran = subprocess.run([CREEPAGE, *arguments], capture_output=True, text=True, check=True)
    return ran.stdout


@functools.cache
def known():
    """What the program knows of each theory, by its name."""
    return {theory["name"]: theory for theory in json.loads(printed("theories", "--json"))}


@functools.cache
def measured():
    """The measured errors, a row for each theory and variant."""
    return json.loads(printed("accuracy", "--json"))


def facts(name):
    theory = known()[name]
    cells = [str(theory["year"]), theory["assumes"], units(theory["cost"]), theory["good_for"]]
    return table(["year", "assumes", "one force", "good for"], [cells])


def accuracy(name=None):
    rows = [row for row in measured() if name in (None, row["theory"])]
    if not rows:
        raise ValueError(f"nothing is measured of {name}")
    heads = ["theory", "force: median", "mean", "rms", "95 %", "worst", "moment: rms", "worst"]
    return table(heads, [measures(row) for row in rows], numbers_from=1) + (UNITS if name else "")


def measures(row):
    name = f"`{row['theory']}`" + (f", {row['options']}" if row["options"] else "")
    force = [percent(row["force"][measure]) for measure in MEASURES]
    return [name, *force, *(percent(row["moment"][measure]) for measure in ["rms", "worst"])]


def percent(share):
    return f"{100 * share:.1f}" if share < 0.9995 else f"{100 * share:.0f}"


def theories(directory):
    """All theories, on a page in `directory`."""
    pages = posixpath.relpath("theories", directory)
    rms = {row["theory"]: row["force"]["rms"] for row in measured() if not row["options"]}
    rows = [
        [
            f"[`{name}`]({pages}/{name}.md)",
            str(theory["year"]),
            theory["assumes"],
            units(theory["cost"]),
            percent(rms[name]),
            theory["good_for"],
        ]
        for name, theory in known().items()
    ]
    heads = ["theory", "year", "assumes", "one force", "rms error, %", "good for"]
    return table(heads, rows)


def units(cost):
    return cost.replace("us", "µs")


def table(heads, rows, numbers_from=None):
    first = len(heads) if numbers_from is None else numbers_from
    rule = ["---" if column < first else "--:" for column in range(len(heads))]
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [heads, rule, *rows])


LANGUAGES = {".toml": "toml", ".c": "c", ".cff": "yaml"}


def part(path, heading=None):
    """A file: Markdown without its title, or what stands under a heading of it; other text as a block."""
    body = (ROOT / path).read_text(encoding="utf-8")
    language = LANGUAGES.get(Path(path).suffix)
    if language:
        return f"```{language}\n{body.strip()}\n```"
    body = re.sub(r"\A# .*\n", "", body)
    if heading is None:
        return body.strip()
    found = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", body, re.MULTILINE | re.DOTALL)
    if not found:
        raise ValueError(f"{path} has no part `{heading}`")
    return found[1].strip()
