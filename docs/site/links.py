# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""Links of the made site: those within it must lead somewhere, those out of it must be addresses."""
import html.parser
import pathlib
import urllib.parse


class _Page(html.parser.HTMLParser):
    """The links of a page, and the places in it that a link may name."""

    def __init__(self, path):
        super().__init__()
        self.links, self.places = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if value is None:
                continue
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)
            elif (tag, name) in (("a", "href"), ("img", "src"), ("link", "href"), ("script", "src")):
                self.links.append(value)


def _is_address(parts):
    if parts.scheme in ("http", "https"):
        host = parts.hostname or ""
        return "." in host.strip(".") and " " not in parts.geturl()
    return parts.scheme in ("mailto", "data") and bool(parts.path)


def dead_links(site):
    """A sentence for each link that leads nowhere. Nothing is asked of the network."""
    site = pathlib.Path(site)
    pages = {path: _Page(path) for path in sorted(site.rglob("*.html"))
             if "_static" not in path.relative_to(site).parts}
    dead = []
    for path, page in pages.items():
        for link in page.links:
            why = _fault(site, pages, path, link)
            if why:
                dead.append(f"{path.relative_to(site)}: {link}: {why}")
    return dead


def _fault(site, pages, path, link):
    try:
        parts = urllib.parse.urlsplit(link)
    except ValueError:
        return "no address"
    if parts.scheme or parts.netloc:
        return None if _is_address(parts) else "no address"
    target = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
    if target.is_dir():
        target /= "index.html"
    if not target.is_file() or site.resolve() not in target.parents:
        return "no such file"
    place = urllib.parse.unquote(parts.fragment)
    if place and target in pages and place not in pages[target].places:
        return "no such place in it"
    return None
