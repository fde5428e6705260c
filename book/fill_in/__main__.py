"""Writes into the guide's pages what commands print and draw, so that they read whole on any forge and in any editor.

    CREEPAGE=target/debug/creepage python3 book/fill_in            write
    CREEPAGE=target/debug/creepage python3 book/fill_in --check    end with 1 where a page is not what it would be

A page has marks, each followed by what it stands for and `<!-- end -->`:

    <!-- facts NAME -->                     a theory's year, assumption, cost and range
    <!-- accuracy -->, <!-- accuracy NAME -->   measured errors, of all theories or of one
    <!-- theories -->                       the list of theories, with links to their pages
    <!-- file PATH -->, <!-- file PATH: HEADING -->   a file of the repository, or one part of it
    <!-- schema NAME -->                    sections and keys of a file
    <!-- help -->, <!-- python -->, <!-- thesis -->   help of all commands, Python's reference, the gallery

and commands: a line `$ ...` of a `console` block, whose output follows where anything follows, or a comment
`<!-- $ ... -->`. Pictures that commands draw are kept beside the page where it shows them.
"""

import os
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path, PurePosixPath

import charts
import commands
import python_reference
import readme
import schema
import tables
import thesis

PAGES = tables.ROOT / "book" / "pages"
MARK = re.compile(
    r"^<!-- (facts|accuracy|theories|file|schema|help|python|thesis)(?: ([^:\n]*?))?(?:: ([^\n]*?))? -->\n"
    r"(?:(?:(?!<!-- (?:facts|accuracy|theories|file|schema|help|python|thesis)\b)[^\n]*\n)*?<!-- end -->\n)?",
    re.MULTILINE,
)
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+\.(?:svg|png))\)")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
# By how much numbers may differ from one processor to another: in a picture (px); in a text, in parts of it, and at all.
CLOSE = 0.6
CLOSE_IN_TEXT = (1e-3, 2e-6)


def main():
    readme.check()
    for case in charts.CASES:  # once, for all pages that show it
        charts.curves(case)
    with tempfile.TemporaryDirectory() as place, ThreadPoolExecutor() as pool:
        pages = sorted(PAGES.rglob("*.md"))
        made = list(pool.map(lambda page: filled(page, Path(place)), pages))
        if sys.argv[1:] == ["--check"]:
            stale = [fault for page, (text, pictures) in zip(pages, made) for fault in faults(page, text, pictures)]
            for fault in stale:
                print(f"{fault} is not what it would be: book/fill writes it", file=sys.stderr)
            sys.exit(bool(stale))
        for page, (text, pictures) in zip(pages, made):
            write(page, text, pictures)


def filled(page, place):
    """The page's text, and its pictures by their path beside it."""
    name = page.relative_to(PAGES)
    room = place / name.with_suffix("")
    text = commands.run(page.read_text(encoding="utf-8"), room, CONSOLE)
    text = MARK.sub(lambda found: marked(found, name, room), text)
    return text, pictures(text, name, room)


def marked(found, name, room):
    maker, what, more = found.groups()
    makers = {
        "facts": tables.facts,
        "accuracy": tables.accuracy,
        "file": tables.part,
        "theories": lambda: tables.theories(PurePosixPath(name.as_posix()).parent),
        "schema": schema.sections,
        "help": schema.commands,
        "python": python_reference.reference,
        "thesis": lambda: thesis.gallery(room / thesis.MADE, beside=f"{name.stem}/{thesis.MADE}"),
    }
    made = makers[maker](*(word for word in (what, more) if word))
    mark = found[0].split("\n", 1)[0]
    return f"{mark}\n\n{made}\n\n<!-- end -->\n"


def pictures(text, name, room):
    """What the page shows of what its commands drew, and its charts."""
    found = {}
    for path in dict.fromkeys(PICTURE.findall(text)):
        if path == f"{name.stem}/error.svg":
            found[path] = charts.errors(name.stem).encode()
        elif path == "theories.svg":
            found[path] = charts.times().encode()
        elif (room.parent / path).exists():
            found[path] = (room.parent / path).read_bytes()
    return found


def faults(page, text, pictures):
    if not alike(page.read_text(encoding="utf-8"), text, CLOSE_IN_TEXT):
        yield page.relative_to(tables.ROOT)
    for path, content in pictures.items():
        kept = page.parent / path
        if not kept.exists() or not alike_pictures(kept.read_bytes(), content):
            yield kept.relative_to(tables.ROOT)


def alike_pictures(one, other):
    return one == other or alike(one.decode("latin-1"), other.decode("latin-1"), (0.0, CLOSE))


def alike(one, other, close):
    """Whether two texts are the same but for rounding of their numbers."""
    if one == other:
        return True
    if skeleton(one) != skeleton(other):
        return False
    part, least = close
    pairs = ((float(a), float(b)) for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)))
    return all(abs(a - b) <= part * max(abs(a), abs(b)) + least for a, b in pairs)


def skeleton(text):
    """A text without its numbers and their columns."""
    return re.sub(r" +", " ", NUMBER.sub("#", text))


def write(page, text, pictures):
    if not alike(page.read_text(encoding="utf-8"), text, CLOSE_IN_TEXT):
        page.write_text(text, encoding="utf-8")
    beside = page.with_suffix("")
    for old in [*beside.rglob("*.svg"), *beside.rglob("*.png")]:
        if old.relative_to(page.parent).as_posix() not in pictures:
            old.unlink()
    for path, content in pictures.items():
        kept = page.parent / path
        kept.parent.mkdir(parents=True, exist_ok=True)
        if not kept.exists() or not alike_pictures(kept.read_bytes(), content):
            kept.write_bytes(content)


if __name__ == "__main__":
    os.chdir(tables.ROOT)
    main()
