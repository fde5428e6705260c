"""Runs the commands of a page, in a directory of its own with the `examples` in it, and writes what they print."""

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path

from tables import CREEPAGE, ROOT

# The gallery of the thesis as its test has just made it, where `./test` says so.
GALLERY = os.environ.get("CREEPAGE_GALLERY")
MAKES_GALLERY = ["creepage", "reproduce", "all", "--out"]
HIDDEN = re.compile(r"^<!-- \$ (.*?) -->$", re.MULTILINE)


def run(text, place, console):
    """The page with the output of every command that shows it."""
    if not (HIDDEN.search(text) or console.search(text)):
        return text
    place.mkdir(parents=True)
    (place / "examples").symlink_to(ROOT / "examples")
    either = re.compile(f"{HIDDEN.pattern}|{console.pattern}", re.MULTILINE | re.DOTALL)

    def ran(found):
        if found[1] is not None:
            output(found[1], place)
            return found[0]
        return "```console\n" + "".join(shown(found[2], place)) + "```"

    return either.sub(ran, text)


def shown(block, place):
    """Lines of a `console` block: each command, and what it prints where anything stood after it."""
    for part in re.split(r"^(?=\$ )", block, flags=re.MULTILINE):
        command, _, before = part.partition("\n")
        if not command.startswith("$ "):
            yield part
            continue
        printed = output(command[2:], place)
        yield f"{command}\n"
        if before.strip() and printed:
            yield f"{printed}\n"
        if before.endswith("\n\n"):
            yield "\n"


def output(command, place):
    words = shlex.split(command)
    if GALLERY and words[:4] == MAKES_GALLERY and (Path(GALLERY) / "items.json").exists():
        shutil.copytree(GALLERY, place / words[4])
        return ""
    path = f"{Path(CREEPAGE).parent}{os.pathsep}{os.environ['PATH']}"
    ran = subprocess.run(
        command, shell=True, cwd=place, env=os.environ | {"PATH": path}, capture_output=True, text=True
    )
    if ran.returncode != 0:
        raise ValueError(f"{place.name}: `{command}` ended with {ran.returncode}\n{ran.stderr}")
    return ran.stdout.rstrip("\n")
