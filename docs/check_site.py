# SPDX-License-Identifier: Apache-2.0
"""The built site must work without a network: nothing that a page loads by itself may come from elsewhere.

Usage: ``python docs/check_site.py build/docs/html``. Links that a reader may follow are allowed to lead away;
those that stay on the site must lead to a file. Exit code 1 and one line each if something is wrong.
"""

from __future__ import annotations

import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# attributes whose address a browser loads without being asked; of links only some kinds are loaded
LOADED = {"src", "srcset", "poster", "data", "background"}
LOADED_LINKS = {
    "stylesheet",
    "icon",
    "preload",
    "modulepreload",
    "prefetch",
    "preconnect",
    "dns-prefetch",
    "manifest",
}
IN_CSS = re.compile(r"(?:url\(|@import)\s*['\"]?([^'\")\s;]+)")
# namespaces of SVG and MathML are names, not addresses
AWAY = re.compile(r"(?:https?:)?//")


class Addresses(HTMLParser):
    """Addresses of one page: what it loads, and where its links lead."""

    def __init__(self) -> None:
        super().__init__()
        self.loaded: list[str] = []
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take the addresses of one element."""
        values = {name: value or "" for name, value in attrs}
        if tag == "link" and LOADED_LINKS & set(values.get("rel", "").split()):
            self.loaded.append(values.get("href", ""))
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        self.loaded += [
            value.split()[0] for name, value in values.items() if name in LOADED and value.strip()
        ]
        self.loaded += IN_CSS.findall(values.get("style", ""))


def problems(site: Path) -> list[str]:
    """What is wrong with a built site, one line each."""
    found = []
    for page in sorted(path for path in site.rglob("*.html") if "_static" not in path.parts):
        text = page.read_text(encoding="utf-8")
        addresses = Addresses()
        addresses.feed(text)
        name = page.relative_to(site)
        for style in re.findall(r"<style[^>]*>(.*?)</style>", text, re.DOTALL):
            addresses.loaded += IN_CSS.findall(style)
        for address in addresses.loaded:
            if AWAY.match(address):
                found.append(f"{name}: loads {address}")
            elif not address.startswith(("data:", "blob:", "#")) and not there(page, address):
                found.append(f"{name}: loads {address}, which is not there")
        for address in addresses.links:
            if not urlsplit(address).scheme and not there(page, address):
                found.append(f"{name}: links to {address}, which is not there")
    for sheet in sorted(site.rglob("*.css")):
        text = sheet.read_text(encoding="utf-8")
        found += [f"{sheet.relative_to(site)}: loads {a}" for a in IN_CSS.findall(text) if AWAY.match(a)]
    return found


def there(page: Path, address: str) -> bool:
    """Whether an address without a host leads to a file."""
    path = unquote(urlsplit(address).path)
    return not path or (page.parent / path).exists()


if __name__ == "__main__":
    wrong = problems(Path(sys.argv[1]))
    print("\n".join(wrong) or "every asset of the site is its own, every link leads somewhere")
    sys.exit(1 if wrong else 0)
