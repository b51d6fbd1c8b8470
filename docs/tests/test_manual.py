"""The manual as it is built: what must hold for every page, read from the finished HTML."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs"))

import build  # noqa: E402
from manual import page  # noqa: E402
from manual.mechanisms import case  # noqa: E402
from manual.program import Program  # noqa: E402

PROGRAM = Path(os.environ.get("FLEXURE", ROOT / "target/debug/flexure"))
# What makes a browser fetch something; links in the text do not.
LOADING = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("use", "href"), ("image", "href")}
EMPTY = {"meta", "link", "br", "hr", "img", "col", "input"}


class Document(HTMLParser):
    """Names, links and what is loaded; complains about tags that do not match."""

    def __init__(self, text: str):
        super().__init__()
        self.names: list[str] = []
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.open: list[str] = []
        self.feed(text)
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        if tag not in EMPTY:
            self.open.append(tag)
        self._note(tag, attributes)

    def handle_startendtag(self, tag, attributes):
        self._note(tag, attributes)

    def _note(self, tag, attributes):
        for key, value in attributes:
            if key == "id":
                self.names.append(value)
            if tag == "a" and key == "href":
                self.links.append(value)
            if (tag, key) in LOADING or (tag, key.removeprefix("xlink:")) in LOADING:
                self.loaded.append(value)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, f"</{tag}> at {self.getpos()}"


@pytest.fixture(scope="session")
def manual(tmp_path_factory):
    out = tmp_path_factory.mktemp("manual")
    return out, build.build(Program(PROGRAM), out)


@pytest.fixture(scope="session")
def documents(manual):
    out, pages = manual
    return {name: Document((out / f"{name}.html").read_text()) for name in pages}


def test_equations_figures_and_tables_count_from_one(manual):
    out, pages = manual
    text = (out / "beam.html").read_text()
    shown = re.findall(r'<a class="number" href="#eq:([\w-]+)">\(B\.(\d+)\)</a>', text)
    assert [int(n) for _, n in shown] == list(range(1, len(shown) + 1))
    assert [name for name, _ in shown] == pages["beam"].equations and len(shown) >= 15
    for word, names in (("Figure", pages["beam"].figures), ("Table", pages["beam"].tables)):
        assert re.findall(rf"<b>{word} (\d+)\.</b>", text) == [str(n) for n in range(1, len(names) + 1)]


def test_every_link_within_the_manual_leads_somewhere(documents):
    for name, document in documents.items():
        assert len(set(document.names)) == len(document.names), name
        for link in document.links:
            if link.startswith("https://doi.org/"):
                continue
            file, _, anchor = link.partition("#")
            target = documents[file.removesuffix(".html") or name]
            assert not anchor or anchor in target.names, f"{name}: {link}"


def test_every_figure_is_drawn(manual):
    out, pages = manual
    text = (out / "beam.html").read_text()
    figures = re.findall(r'<figure class="fig" id="fig:([\w-]+)">(.*?)</figure>', text, re.S)
    assert [name for name, _ in figures] == pages["beam"].figures and len(figures) >= 7
    for name, body in figures:
        drawings = re.findall(r"<svg.*?</svg>", body, re.S)
        assert drawings and all("<path" in d for d in drawings), name
        assert all("nan" not in d.lower() for d in drawings), name


def test_the_tables_have_every_parameter_with_the_sentence_of_help(manual):
    out, _ = manual
    text = re.sub(r"<[^>]*>", "", (out / "beam.html").read_text())
    for verb in ("create", "modify"):
        words = ["force", verb, "element_like", "beam"]
        lines = subprocess.run([PROGRAM, "support", *words], capture_output=True, text=True, check=True).stdout
        rows = [line.strip() for line in lines.splitlines()[1:]]
        assert len(rows) >= 18
        for row in rows:
            assert f'id="{verb}.{row.split()[0]}"' in (out / "beam.html").read_text()
            assert row.split(": ", 1)[1] in page.html.unescape(text), row


def test_nothing_is_loaded_from_outside(manual, documents):
    out, _ = manual
    for name, document in documents.items():
        for target in document.loaded:
            assert target.startswith("#") or (out / target).is_file(), f"{name} loads {target}"
    style = (out / "style.css").read_text()
    assert all(u.startswith("data:") for u in re.findall(r"url\(([^)]*)\)", style)) and "@import" not in style


def test_a_number_that_leaves_its_range_stops_the_build():
    material = page.Material()
    material.number("ratio", 3.9)
    assert "3.9" in page.build("# T\n\n@{ratio ~ 4 +- 0.2}", material, {}).body
    for claim in ("@{ratio ~ 4 +- 0.05}", "@{ratio > 4}", "@{! ratio < 3}", "@{unknown}"):
        with pytest.raises(page.Wrong):
            page.build(f"# T\n\n{claim}", material, {})


def test_references_to_nothing_stop_the_build():
    for text in ("@eq:no", "@fig:no", "@tab:no", "@sec:no", "@test:no", "::: {#fig:no}\nCaption.\n:::"):
        with pytest.raises(page.Wrong):
            page.build(f"# T\n\n{text}", page.Material(), {})


def test_evidence_must_exist_in_the_code():
    evidence = {"a": {"says": "", "file": "docs/tests/test_manual.py", "test": "not_" + "there"}}
    with pytest.raises(page.Wrong, match="no `fn not_there"):
        page.build("# T\n\nTrue@test:a.", page.Material(), evidence)


def test_a_number_that_is_not_that_of_its_mechanism_stops_the_build():
    of = case("elastica", "NONLINEAR, J at the root side, alpha = 1")
    inputs, expected = of.rows()[0]
    assert of.compared(Program(PROGRAM), inputs, expected).keys() == {"u", "v"}
    with pytest.raises(AssertionError, match="u is 0.056"):
        of.compared(Program(PROGRAM), inputs, {**expected, "u": expected["u"] + 2e-5})
