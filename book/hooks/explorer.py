"""Puts the library, compiled for a browser, beside the explorers' pages as `engine-wasm.js`.

The files are in the folder CREEPAGE_WASM; without it the pages say that the explorer was left out.
"""

import base64
import gzip
import os
from pathlib import Path

from mkdocs.structure.files import File

# Of each page: the file, and how long its packed bytes may be as text. A script, for a page that is opened as a file may
# not fetch one.
ENGINES = {"explorer": ("creepage_web.wasm", 1_000_000), "wheelset-explorer": ("creepage_web_wheelset.wasm", 1_500_000)}
PAGE_WITHOUT_ENGINE = """# {title}

This copy of the guide was built without the explorer: the compiler's target `wasm32-unknown-unknown` was not at hand.
"""


def on_files(files, config):
    folder = os.environ.get("CREEPAGE_WASM")
    for page, (name, largest) in ENGINES.items():
        if not folder:
            file = files.get_file_from_path(f"{page}.md")
            title = file.content_string.split("# ", 1)[1].split("\n", 1)[0]
            file.content_string = PAGE_WITHOUT_ENGINE.format(title=title)
            continue
        text = base64.b64encode(gzip.compress((Path(folder) / name).read_bytes(), 9, mtime=0)).decode()
        assert len(text) < largest, f"the engine of {page} has {len(text)} bytes"
        script = f'"use strict";\nconst ENGINE_WASM = "{text}";\n'
        files.append(File.generated(config, f"{page}/engine-wasm.js", content=script))
    return files
