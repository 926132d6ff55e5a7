# SPDX-License-Identifier: Apache-2.0
"""Gallery of the examples: one card and one page for each, with its scene or its report.

The commands of `gallery.yaml` write a page, which the page of the example shows. Where Chromium is installed
`make docs` takes the picture of the card from it; otherwise those of `docs/images/gallery` are used.
``python docs/make_gallery.py docs/images/gallery`` renews these.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from ruamel.yaml import YAML

HERE = Path(__file__).parent
EXAMPLES = HERE.parent / "examples"
KEPT = HERE / "images" / "gallery"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
WINDOW = (1200, 750)
PICTURE = (720, 450)
LARGEST = 60_000  # bytes
SHOWN = {".yaml": "yaml", ".py": "python"}
LONGEST = 130  # lines of a file that is shown on the page


def cards() -> dict[str, dict[str, Any]]:
    """Entries of `gallery.yaml` by the name of the example; there must be one for every folder."""
    found = YAML(typ="safe").load((HERE / "gallery.yaml").read_text(encoding="utf-8"))
    folders = {path.parent.name for path in EXAMPLES.glob("*/README.md")}
    if folders != set(found):
        raise SystemExit(f"docs/gallery.yaml and examples/ differ in {sorted(folders ^ set(found))}")
    return found


def browser() -> str | None:
    """Chromium, if there is one."""
    return next((path for path in map(shutil.which, BROWSERS) if path), None)


def write_page(name: str, card: dict[str, Any], page: Path) -> None:
    """Run the commands of a card in a copy of its folder and keep the page.html that they write."""
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder) / name
        shutil.copytree(EXAMPLES / name, work)
        for command in card["commands"]:
            call = [sys.executable, "-m", "pitchpoint", *command.split()]
            done = subprocess.run(call, cwd=work, capture_output=True, text=True)
            if done.returncode:
                raise SystemExit(f"docs/gallery.yaml: {name}: {command}\n{done.stderr}")
        page.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(work / "page.html", page)


def take_picture(page: Path, target: Path) -> bool:
    """Take a picture of a page.

    Parameters
    ----------
    page
        HTML file.
    target
        WEBP file to write.

    Returns
    -------
    bool
        Whether there is a picture; without a browser there is none.
    """
    program = browser()
    if program is None:
        return False
    with tempfile.TemporaryDirectory() as folder:
        shot = Path(folder) / "page.png"
        # software rendering: machines that build pages have no GPU
        flags = [
            "--headless",
            "--no-sandbox",
            "--hide-scrollbars",
            "--use-gl=angle",
            "--use-angle=swiftshader",
        ]
        flags += [
            "--enable-unsafe-swiftshader",
            "--virtual-time-budget=15000",
            f"--user-data-dir={folder}/user",
        ]
        flags += [f"--screenshot={shot}", f"--window-size={WINDOW[0]},{WINDOW[1]}"]
        subprocess.run([program, *flags, page.resolve().as_uri()], capture_output=True, timeout=180)
        if not shot.exists():
            print(f"gallery: the browser made no picture of {page.name}")
            return False
        shrink(shot, target)
    return True


def shrink(shot: Path, target: Path) -> None:
    """Write a picture in the size of a card, as good as fits into `LARGEST` bytes."""
    from PIL import Image

    target.parent.mkdir(parents=True, exist_ok=True)
    picture = Image.open(shot).convert("RGB").resize(PICTURE, Image.Resampling.LANCZOS)
    for quality in (85, 75, 65, 50, 35):
        picture.save(target, "WEBP", quality=quality, method=6)
        if target.stat().st_size <= LARGEST:
            return


def state_of(name: str, card: dict[str, Any]) -> str:
    """What a picture depends on: the example, its commands, the package with its viewer."""
    mark = hashlib.sha256(str(card).encode())
    files = sorted(path for path in (EXAMPLES / name).rglob("*") if path.is_file() and path.suffix != ".pyc")
    package = HERE.parent / "src/pitchpoint"
    for path in [*files, *sorted(package.rglob("*.py")), package / "viz/assets/viewer.js"]:
        mark.update(path.read_bytes())
    return mark.hexdigest()


def write_pictures(pages: Path, target: Path, found: dict[str, dict[str, Any]]) -> None:
    """Write live pages of all cards and bring their pictures, new ones where they can be made."""
    target.mkdir(parents=True, exist_ok=True)

    def bring(name: str) -> None:
        card, page, picture = found[name], pages / f"{name}.html", target / f"{name}.webp"
        mark = picture.with_suffix(".state")
        if page.exists() and mark.exists() and mark.read_text() == state_of(name, card):
            return
        write_page(name, card, page)
        if not take_picture(page, picture):
            shutil.copyfile(KEPT / picture.name, picture)
        mark.write_text(state_of(name, card))

    with ThreadPoolExecutor(2) as pool:
        list(pool.map(bring, found))


def card_text(name: str, card: dict[str, Any]) -> str:
    """One card of the overview."""
    title = title_of(name)
    return (
        f":::{{grid-item-card}} {title}\n:link: {name}/index\n:link-type: doc\n"
        f":img-top: /gallery/pictures/{name}.webp\n:img-alt: {title}\n\n{card['sentence']}\n:::\n"
    )


def title_of(name: str) -> str:
    """First heading of the page of an example."""
    return (EXAMPLES / name / "README.md").read_text(encoding="utf-8").splitlines()[0].removeprefix("# ")


def example_page(name: str) -> str:
    """Page of an example: its README, the picture, the files."""
    readme = (EXAMPLES / name / "README.md").read_text(encoding="utf-8").replace("](../../docs/", "](../../")
    title, text = readme.split("\n", 1)
    address = f"../../scenes/{name}.html"
    frame = f'<iframe class="pp-scene" src="{address}" title="{title[2:]}" loading="lazy"></iframe>'
    parts = [title, "", "```{raw} html", frame, "```", ""]
    parts += [text.strip(), "", "## Files", "", f"`pitchpoint examples copy {name}` copies the folder.", ""]
    for path in sorted((EXAMPLES / name).iterdir()):
        if path.suffix not in SHOWN:
            continue
        parts.append(f":::{{dropdown}} {path.name}")
        if len(path.read_text(encoding="utf-8").splitlines()) <= LONGEST:
            parts += [f"```{{literalinclude}} {path.name}", f":language: {SHOWN[path.suffix]}", "```"]
        else:
            parts.append(f"[{path.name}]({path.name}), to download")
        parts += [":::", ""]
    return "\n".join(parts)


def overview(found: dict[str, dict[str, Any]]) -> str:
    """Page of all cards by group, with the tree of contents."""
    lines = [
        "# Gallery",
        "",
        "Every example is a folder with a model and a page; a test asserts its numbers.",
        "",
    ]
    for group in dict.fromkeys(card["group"] for card in found.values()):
        lines += [f"## {group}", "", "::::{grid} 1 2 2 3", ":gutter: 3", ""]
        lines += [card_text(name, card) for name, card in found.items() if card["group"] == group]
        lines += ["::::", ""]
    lines += ["```{toctree}", ":hidden:", "", *[f"{name}/index" for name in found], "```", ""]
    return "\n".join(lines)


def write_gallery(target: Path) -> None:
    """Write overview, pages and pictures below the folder `gallery` of the source of the site."""
    found = cards()
    folder = target / "gallery"
    shutil.copytree(
        EXAMPLES, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__", "*.h5")
    )
    for name in found:
        (folder / name / "index.md").write_text(example_page(name), encoding="utf-8")
    (folder / "index.md").write_text(overview(found), encoding="utf-8")
    write_pictures(target / "_extra" / "scenes", folder / "pictures", found)


if __name__ == "__main__":
    place = Path(sys.argv[1] if len(sys.argv) > 1 else KEPT)
    with tempfile.TemporaryDirectory() as scenes:
        write_pictures(Path(scenes), place, cards())
    for left in place.glob("*.state"):
        left.unlink()
