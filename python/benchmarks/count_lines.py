"""Counts the Rust of the crates: code lines without documentation, comments, blank lines and tests; files.

python python/benchmarks/count_lines.py [ROOT]
"""

import re
import sys
from pathlib import Path

SHORT = 60


def count(text: str) -> int:
    """Code lines of a file; a module `#[cfg(test)] mod tests { ... }` at its end does not count."""
    body = re.split(r"^#\[cfg\(test\)\]\n(?:#\[[^\n]*\]\n)*mod \w+ \{", text, maxsplit=1, flags=re.MULTILINE)[0]
    lines = (line.strip() for line in body.splitlines())
    return sum(1 for line in lines if line and not line.startswith("//"))


def is_test(path: Path) -> bool:
    """A file of tests inside `src`, and what only tests use."""
    return path.stem in {"tests", "testing", "fuzz"} or "tests" in path.parts


def main(root: Path) -> None:
    rows: list[tuple[str, int, int, int]] = []
    for crate in sorted((root / "crates").iterdir()):
        files = [path for path in (crate / "src").rglob("*.rs") if not is_test(path.relative_to(crate))]
        texts = [path.read_text(encoding="utf-8") for path in files]
        short = sum(1 for text in texts if len(text.splitlines()) < SHORT)
        rows.append((crate.name, len(files), sum(map(count, texts)), short))
    rows.append(("all", sum(row[1] for row in rows), sum(row[2] for row in rows), sum(row[3] for row in rows)))
    print(f"{'crate':<24}{'files':>8}{'code':>10}{f'< {SHORT} lines':>14}")
    for name, count_of_files, code, few in rows:
        print(f"{name:<24}{count_of_files:>8}{code:>10,}{few:>14}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
