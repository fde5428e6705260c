"""Puts the library, compiled for a browser, beside the explorer's page as `explorer/engine-wasm.js`.

The file is named by CREEPAGE_WASM; without it the page says that the explorer was left out.
"""

import base64
import os
from pathlib import Path

from mkdocs.structure.files import File

PAGE = "explorer.md"
# A script, for a page that is opened as a file may not fetch one.
SCRIPT = "explorer/engine-wasm.js"
# With all that the page loads, below 2 MB.
LARGEST = 1_900_000
PAGE_WITHOUT_ENGINE = """# Explorer

This copy of the guide was built without the explorer: the compiler's target `wasm32-unknown-unknown` was not at hand.
"""


def on_files(files, config):
    wasm = os.environ.get("CREEPAGE_WASM")
    if not wasm:
        files.get_file_from_path(PAGE).content_string = PAGE_WITHOUT_ENGINE
        return files
    text = base64.b64encode(Path(wasm).read_bytes()).decode()
    assert len(text) < LARGEST, f"the explorer's engine has {len(text)} bytes"
    files.append(File.generated(config, SCRIPT, content=f'"use strict";\nconst ENGINE_WASM = "{text}";\n'))
    return files
