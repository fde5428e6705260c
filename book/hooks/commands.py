"""Runs the commands of every page, and shows what they print and draw.

A command stands on a line `$ ...` of a `console` block, or in a comment `<!-- $ ... -->` where the
reader need not see it. A line `...` after it is replaced by what it printed. Each page runs in a
directory of its own, with the `examples` in it; pictures that appear there belong to the page, as
`PAGE/PATH` beside it.
"""

import os
import re
import shlex
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

# The gallery of the thesis as its test has just made it, where `./test` says so.
GALLERY = os.environ.get("CREEPAGE_GALLERY")
# The only picture that is no SVG.
ANIMATION = "rolling.png"
MAKES_GALLERY = ["creepage", "reproduce", "all", "--out"]
ROOT = Path(__file__).resolve().parents[2]
CREEPAGE = Path(os.environ["CREEPAGE"])
COMMAND = re.compile(r"^(?:<!-- )?\$ (.*?)(?: -->)?$")


def on_files(files, config):
    """Runs all pages and adds their pictures to the site."""
    pages = list(files.documentation_pages())
    with ThreadPoolExecutor() as pool:
        outputs = list(pool.map(run, pages))
    for page, printed in zip(pages, outputs):
        place = room(page)
        page.content_string = show(page.content_string, printed)
        for picture in sorted([*place.rglob("*.svg"), *place.rglob(ANIMATION)]):
            uri = Path(page.src_uri).with_suffix("") / picture.relative_to(place)
            files.append(File.generated(config, uri.as_posix(), abs_src_path=str(picture)))
    return files


def room(page):
    """Where the page's commands run."""
    return CREEPAGE.parents[1] / "book-run" / Path(page.src_uri).with_suffix("")


def run(page):
    """What each command of the page printed."""
    place = room(page)
    shutil.rmtree(place, ignore_errors=True)
    commands = [found[1] for found in map(COMMAND.match, page.content_string.splitlines()) if found]
    if not commands:
        return []
    place.mkdir(parents=True)
    (place / "examples").symlink_to(ROOT / "examples")
    return [output(command, place) for command in commands]


def output(command, place):
    words = shlex.split(command)
    if GALLERY and words[:4] == MAKES_GALLERY and (Path(GALLERY) / "items.json").exists():
        shutil.copytree(GALLERY, place / words[4])
        return ""
    path = f"{CREEPAGE.parent}{os.pathsep}{os.environ['PATH']}"
    ran = subprocess.run(
        command, shell=True, cwd=place, env=os.environ | {"PATH": path}, capture_output=True, text=True
    )
    if ran.returncode != 0:
        raise PluginError(f"{place.name}: `{command}` ended with {ran.returncode}\n{ran.stderr}")
    return ran.stdout.rstrip("\n")


def show(text, printed):
    """The page with `...` after a command replaced by what it printed."""
    printed, last, lines = iter(printed), "", []
    for line in text.splitlines():
        if COMMAND.match(line):
            last = next(printed)
        lines.append(last if line == "..." else line)
    return "\n".join(line for line in lines if not line.startswith("<!-- $"))
