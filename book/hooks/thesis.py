"""The thesis, figure by figure: what `creepage reproduce all` computes and draws.

On the page with the mark `<!-- thesis -->`: the table of agreement, then every figure by its
number, then every table of the thesis with its entries as printed and as computed.
"""

import csv
import os
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

from mkdocs.structure.files import File

MARK = "<!-- thesis -->"
AGREEMENT = "agreement.csv"


def on_files(files, config):
    for page in files.documentation_pages():
        if MARK in page.content_string:
            directory = reproduced()
            for picture in pictures(directory):
                uri = Path(page.src_uri).with_suffix("") / picture.name
                files.append(File.generated(config, uri.as_posix(), abs_src_path=str(picture)))
            content = gallery(directory, Path(page.src_uri).stem)
            page.content_string = page.content_string.replace(MARK, content)
    return files


def reproduced():
    """The directory with everything, made afresh."""
    command = Path(os.environ["CREEPAGE"])
    directory = command.parents[1] / "book-run" / "reproduced"
    subprocess.run([command, "reproduce", "all", "--out", directory], capture_output=True, check=True)
    return directory


def pictures(directory):
    return sorted(directory.rglob("*.svg"), key=lambda path: in_order(path.stem))


def in_order(name):
    """Sorts `figure9` before `figure10`."""
    return [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


def gallery(directory, beside):
    parts = [agreement(directory)]
    parts += [figure(picture, beside) for picture in pictures(directory)]
    tables = sorted(directory.rglob("table*.csv"), key=lambda path: in_order(path.stem))
    parts += [entries(path) for path in tables]
    return "\n\n".join(part for part in parts if part)


def agreement(directory):
    path = directory / AGREEMENT
    return "## Agreement\n\n" + rows(path) if path.exists() else ""


def figure(path, beside):
    title = ElementTree.parse(path).findtext("{http://www.w3.org/2000/svg}title") or path.stem
    return f"## {title}\n\n![{title}]({beside}/{path.name})"


def entries(path):
    """A table of the thesis, folded: it is long."""
    body = rows(path).replace("\n", "\n    ")
    name = re.sub(r"(?<=[a-z])(?=\d)", " ", path.stem).capitalize()
    return f'??? note "{name}, entry by entry"\n\n    {body}'


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        heads, *body = csv.reader(file)
    lines = [heads, ["---"] * len(heads), *body]
    return "\n".join("| " + " | ".join(cell.replace("|", "\\|") for cell in line) + " |" for line in lines)
