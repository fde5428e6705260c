"""Case files from dictionaries, and from paths or text."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

Source: TypeAlias = str | os.PathLike[str]


def read(source: Source) -> str:
    """The text of a file; a string with a line break is the text itself."""
    if isinstance(source, str) and "\n" in source:
        return source
    return Path(source).read_text(encoding="utf-8")


def text_of(source: Source | Mapping[str, Any]) -> str:
    """As read; a mapping of sections is written first."""
    return dumps(source) if isinstance(source, Mapping) else read(source)


def dumps(sections: Mapping[str, Any]) -> str:
    """TOML of sections; what is None is left out."""
    lines = []
    for name, section in sections.items():
        if not isinstance(section, Mapping):
            raise TypeError(f"section {name!r} must be a mapping, not {type(section).__name__}")
        lines.append(f"[{_key(name)}]")
        for key, value in section.items():
            if value is not None:
                lines.append(f"{_key(key)} = {_value(f'[{name}] {key}', value)}")
    return "\n".join(lines) + "\n"


def _key(name: object) -> str:
    if not isinstance(name, str):
        raise TypeError(f"a key must be a word, not {name!r}")
    return json.dumps(name)


def _value(place: str, value: object) -> str:
    if np.ma.is_masked(value):
        raise TypeError(f"{place} must not have masked elements: leave them out")
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, str):
        return json.dumps(value).replace("\x7f", "\\u007f")
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        if not -(2**63) <= value < 2**63:
            raise OverflowError(f"{place} = {value} is beyond the whole numbers of a case file")
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, Mapping):
        pairs = ", ".join(f"{_key(k)} = {_value(place, v)}" for k, v in value.items())
        return f"{{ {pairs} }}"
    if isinstance(value, (Sequence, np.ndarray)):
        return "[" + ", ".join(_value(place, item) for item in value) + "]"
    raise TypeError(f"{place} must be a number, a word or a list, not {type(value).__name__}")
