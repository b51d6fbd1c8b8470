"""Builds the manual: `python docs/build.py --program target/release/flexure --out out/docs`."""

from __future__ import annotations

import argparse
import html
import re
import shutil
import sys
import time
import tomllib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from jinja2 import Environment, FileSystemLoader, StrictUndefined  # noqa: E402
from manual import beam, fonts, page  # noqa: E402
from manual.program import ROOT, Program  # noqa: E402

DOCS = ROOT / "docs"
# File, name in the header, and what computes its figures and numbers.
PAGES = [("index", "Start", None), ("beam", "Beam", beam.material)]
BEAM_CODE = ROOT / "crates/elements/src/forces/beam"


def build(program: Program, out: Path) -> dict[str, page.Page]:
    """Writes all pages; gives them by name. Raises where something is wrong."""
    pages = {}
    for name, _, compute in PAGES:
        path = DOCS / "pages" / f"{name}.toml"
        notes = tomllib.loads(path.read_text()) if path.is_file() else {}
        material = compute(program) if compute else page.Material()
        built = page.build((DOCS / "pages" / f"{name}.md").read_text(), material, notes.get("evidence", {}))
        _same_numbers_as_the_code(built, notes.get("equations", []))
        pages[name] = built
    _write(pages, out)
    return pages


def _same_numbers_as_the_code(built: page.Page, wanted: list[str]) -> None:
    """Comments of the code cite equations of `docs.md` by number; the page has them in that order."""
    if not wanted:
        return
    if built.equations[: len(wanted)] != wanted:
        raise page.Wrong(f"equations are not in the order of the code: {built.equations}")
    known = {int(n) for n in re.findall(r"\(B\.(\d+)\)\n", (BEAM_CODE / "docs.md").read_text())}
    if known != set(range(1, len(wanted) + 1)):
        raise page.Wrong(f"docs.md of the beam numbers {sorted(known)}, the page has {len(wanted)} of them")


def _write(pages: dict[str, page.Page], out: Path) -> None:
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    environment = Environment(loader=FileSystemLoader(DOCS / "theme"), undefined=StrictUndefined)
    template = environment.get_template("page.html")
    listed = [{"file": f"{name}.html", "short": short} for name, short, _ in PAGES]
    version = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["version"]
    characters: set[int] = set()
    for name, built in pages.items():
        text = template.render(page=built, file=f"{name}.html", pages=listed, version=version)
        (out / f"{name}.html").write_text(text)
        characters |= set(map(ord, html.unescape(text)))
    style = fonts.style_sheet(characters) + "\n" + (DOCS / "theme" / "style.css").read_text()
    (out / "style.css").write_text(style)
    shutil.copy(DOCS / "theme" / "script.js", out)
    for name, licence in fonts.LICENCES.items():
        shutil.copy(licence, out / name)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", type=Path, required=True, help="the binary flexure")
    parser.add_argument("--out", type=Path, required=True, help="folder of the pages, made anew")
    asked = parser.parse_args()
    begun = time.perf_counter()
    try:
        pages = build(Program(asked.program.resolve()), asked.out)
    except (page.Wrong, AssertionError) as trouble:
        print(f"manual: {trouble}", file=sys.stderr)
        return 1
    for name, built in pages.items():
        counts = f"{len(built.equations)} equations, {len(built.figures)} figures, {len(built.tables)} tables"
        print(f"{asked.out / name}.html: {counts}, {len(built.used_numbers)} computed numbers")
    print(f"{time.perf_counter() - begun:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())
