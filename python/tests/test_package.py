"""What the package promises: names, documentation, examples, the guide's page."""

from __future__ import annotations

import ast
import graphlib
import inspect
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import creepage
import pytest
from conftest import ROOT

WHEEL_ON_RAIL = ROOT / "examples" / "wheel-on-rail.toml"
# Data, and aliases of types.
UNDOCUMENTED = {
    "THEORIES",
    "__version__",
    "ExactForceArray",
    "ForceArray",
    "ScalarExactForce",
    "ScalarForce",
}
EXAMPLES = sorted((ROOT / "python" / "examples").glob("*.py"))


def test_every_public_name_is_documented() -> None:
    for name in creepage.__all__:
        if name in UNDOCUMENTED:
            continue
        thing = getattr(creepage, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing) and not issubclass(thing, (int, tuple)):
            for member, value in vars(thing).items():
                if callable(value) and not member.startswith("_"):
                    assert inspect.getdoc(value), f"{name}.{member}"


def test_the_modules_import_one_another_in_no_circle() -> None:
    imports = {}
    for path in (ROOT / "python" / "creepage").glob("*.py*"):
        if path.stem == "__main__":  # which nothing imports
            continue
        nodes = list(ast.walk(ast.parse(path.read_text())))
        froms = [node for node in nodes if isinstance(node, ast.ImportFrom) and node.level == 1]
        named = {node.module or alias.name for node in froms for alias in node.names}
        imports[path.stem] = named
    assert len(imports) > 10
    assert list(graphlib.TopologicalSorter(imports).static_order())[-1] == "__init__"


def test_the_version_is_the_workspaces() -> None:
    manifest = (ROOT / "Cargo.toml").read_text()
    assert re.search(rf'^version = "{re.escape(creepage.__version__)}"$', manifest, re.M)


def run(code: list[str], place: Path) -> str:
    """Runs Python in an empty directory; a warning is an error."""
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    done = subprocess.run(
        [sys.executable, "-W", "error", *code],
        cwd=place,
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_example_runs(path: Path, tmp_path: Path) -> None:
    shutil.copy(WHEEL_ON_RAIL, tmp_path)
    assert run([str(path)], tmp_path)


def test_the_first_example_prints_forces_and_saves_a_picture(tmp_path: Path) -> None:
    path = ROOT / "python" / "examples" / "first_steps.py"
    code = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    assert len(code) == 4
    shutil.copy(WHEEL_ON_RAIL, tmp_path)
    printed = run([str(path)], tmp_path)
    assert re.search(r"longitudinal=-145\d\d\..*'fx_error': 0\.000", printed)
    assert (tmp_path / "out" / "contact.png").read_bytes().startswith(b"\x89PNG")


def test_the_page_of_the_guide_runs(tmp_path: Path) -> None:
    page = (ROOT / "book" / "pages" / "how-to" / "python.md").read_text()
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.M | re.S)
    assert len(blocks) > 3
    shutil.copy(WHEEL_ON_RAIL, tmp_path)
    shutil.copy(ROOT / "examples" / "catalogue" / "figure-12.toml", tmp_path)
    run(["-c", "\n".join(blocks)], tmp_path)


def test_it_imports_without_the_optional_packages(tmp_path: Path) -> None:
    code = """
import sys
for name in ("matplotlib", "pandas", "xarray"):
    sys.modules[name] = None
import creepage
theory = creepage.linear(1.0, 0.28)
assert theory.force([0.1]).fx[0] > 0.0
try:
    theory.field(0.1).plot()
except ImportError as error:
    print(error)
"""
    assert "matplotlib" in run(["-c", code], tmp_path)
