"""The thesis, figure by figure: what the page's own command `creepage reproduce all --out thesis`
computed and drew, in place of the mark `<!-- thesis -->`.

Titles and captions are in its `items.json`; the comparisons are in `agreement.csv`.
"""

import csv
import html
import json
import re
from collections import Counter

MADE = "thesis"


def gallery(directory, beside):
    compared = comparisons(directory)
    parts = [summary(compared)]
    for items in directory.glob("items.json"):
        for made in json.loads(items.read_text(encoding="utf-8")):
            mine = [line for line in compared if line["item"] == made["name"]]
            parts += [*item(directory, beside, **made), table(mine)]
    return "\n\n".join(part for part in parts if part)


def comparisons(directory):
    """The lines of the table of agreement."""
    lines = []
    for path in directory.glob("agreement.csv"):
        with path.open(encoding="utf-8", newline="") as file:
            lines += csv.DictReader(file)
    return lines


def summary(compared):
    counts = Counter(line["verdict"] for line in compared)
    verdicts = ", ".join(f"*{verdict}* {count}" for verdict, count in counts.most_common())
    return f"Of {len(compared)} comparisons with the print: {verdicts}." if compared else ""


def item(directory, beside, name, title, caption):
    """Heading, picture, caption, and the table in words, folded."""
    yield f"## {html.escape(title, quote=False)} {{#{name}}}"
    if (directory / f"{name}.svg").exists():
        yield f"![{title}]({beside}/{name}.svg)"
    yield html.escape(caption, quote=False)
    for words in directory.glob(f"{name}.txt"):
        text = f"```text\n{words.read_text(encoding='utf-8').rstrip()}\n```"
        yield f"<details markdown><summary>In words</summary>\n\n{text}\n\n</details>"


def table(lines):
    """What of one item was compared."""
    heads = ["quantity", "printed", "ours", "difference", "verdict", "note"]
    rows = [heads, ["---"] * len(heads), *([line[head] for head in heads] for line in lines)]
    cells = [[cell(text) for text in row] for row in rows]
    return "\n".join("| " + " | ".join(row) + " |" for row in cells) if lines else ""


def cell(text):
    return re.sub(r"([|*_\\])", r"\\\1", html.escape(text, quote=False))
