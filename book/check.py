"""Checks a built guide: nothing comes from elsewhere, no link or anchor is dead, every picture says
in words what it shows, no formula is left in the rough.

    python3 book/check.py SITE
"""

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What a link, and only a link, may name outside the site: papers.
ELSEWHERE = "https://doi.org/"


class Page(HTMLParser):
    """What a page defines and what it asks for."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.resources, self.faults = set(), [], [], []
        text = path.read_text(encoding="utf-8")
        self.feed(text)
        if 'class="arithmatex"' in text or 'class="language-math"' in text:
            self.faults.append("a formula is not rendered")

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given[name] for name in ("id", "name") if given.get(name)}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        elif "href" in given:
            self.resources.append(given["href"])
        if "src" in given:
            self.resources.append(given["src"])
        if tag == "img" and not given.get("alt"):
            self.faults.append(f"{given.get('src')} says nothing in words")


class Site:
    """All pages, read when first needed."""

    def __init__(self, root):
        self.root, self.pages = root.resolve(), {}

    def page(self, path):
        if path not in self.pages:
            self.pages[path] = Page(path)
        return self.pages[path]

    def own_pages(self):
        """The guide's pages; `rustdoc` looks after the links of the reference itself."""
        return [path for path in self.root.rglob("*.html") if not self.in_reference(path)]

    def in_reference(self, path):
        return path.is_relative_to(self.root / "reference")

    def faults(self, path):
        page = self.page(path)
        faults = list(page.faults)
        for link in page.links:
            if not link.startswith(ELSEWHERE):
                faults += self.fault(path, link)
        for resource in page.resources:
            if not resource.startswith("data:"):
                faults += self.fault(path, resource)
        return [f"{path.relative_to(self.root)}: {fault}" for fault in faults]

    def fault(self, path, address):
        """What is wrong with an address on the page at `path`: nothing, or one line."""
        parts = urlsplit(address)
        if parts.scheme or parts.netloc:
            return [f"{address} lies elsewhere"]
        goal = (path.parent / unquote(parts.path)).resolve() if parts.path else path
        goal = goal / "index.html" if goal.is_dir() else goal
        if not goal.is_file() or not goal.is_relative_to(self.root):
            return [f"{address} leads nowhere"]
        if parts.fragment and goal.suffix == ".html":
            if unquote(parts.fragment) not in self.page(goal).anchors:
                return [f"{address} names no place on that page"]
        return []

    def style_faults(self, path):
        faults = []
        for address in re.findall(r"""url\(["']?([^"')]+)""", path.read_text(encoding="utf-8")):
            if not address.startswith(("data:", "#")):
                faults += self.fault(path, address)
        return [f"{path.relative_to(self.root)}: {fault}" for fault in faults]


def main(root):
    site = Site(Path(root))
    pages = site.own_pages()
    faults = [fault for path in pages for fault in site.faults(path)]
    for path in site.root.rglob("*.css"):
        if not site.in_reference(path):
            faults += site.style_faults(path)
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{len(pages)} pages, {sum(len(site.page(p).links) for p in pages)} links, {len(faults)} faults")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
