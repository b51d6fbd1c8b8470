"""A page of the manual: Markdown with computed numbers, numbered equations, figures and tables.

@{name}               a computed number
@{name ~ 2 +- 0.1}    the same, which must lie there, or the build fails
@{name < 3}           the same with a bound, `<` or `>`
@{! name < 3}         shows nothing, but must hold: stands beside a claim in words
$$ ... $$ (eq:name)   a numbered equation;  @eq:name refers to it
::: {#fig:name}       a figure with its caption;  @fig:name
::: {#tab:name}       a table with its caption;  @tab:name
@sec:name             a section, a heading with {#name}
@test:name            the test that shows a property, from the page's list of evidence
"""

from __future__ import annotations

import html
import re
from dataclasses import dataclass, field

import pypandoc

from .program import ROOT


class Wrong(Exception):
    """The page says something that is not so, or refers to what is not there."""


@dataclass(frozen=True)
class Number:
    """A computed number and how it is written."""

    value: float
    text: str


@dataclass
class Material:
    """What a page may show."""

    numbers: dict[str, Number] = field(default_factory=dict)
    figures: dict[str, str] = field(default_factory=dict)
    tables: dict[str, str] = field(default_factory=dict)
    prefix: str = ""

    def number(self, name: str, value: float, form: str = ".3g") -> None:
        self.numbers[name] = Number(value, written(value, form))


@dataclass(frozen=True)
class Heading:
    level: int
    name: str
    text: str


@dataclass
class Page:
    title: str
    body: str
    headings: list[Heading]
    equations: list[str]
    figures: list[str]
    tables: list[str]
    used_numbers: set[str]


def written(value: float, form: str) -> str:
    """A number as it stands in a text: a real minus, powers of ten as such."""
    text = format(value, form)
    if "e" in text:
        mantissa, exponent = text.split("e")
        return f"{mantissa} × 10^{int(exponent)}^".replace("-", "−")
    return text.replace("-", "−")


def build(source: str, material: Material, evidence: dict[str, dict]) -> Page:
    """The HTML of a page. Raises [`Wrong`] with everything that is wrong with it."""
    troubles: list[str] = []
    used: set[str] = set()
    text = _fill(source, material, used, troubles)
    body = pypandoc.convert_text(
        text, "html5", "markdown-citations-implicit_figures", ["--mathml", "--syntax-highlighting=none", "--wrap=none"]
    )
    body, title = _title(_formulas(re.sub(r"(?<=\d) %", "\u00a0%", body)))
    body, equations = _equations(body, material.prefix)
    body, figures = _floats(body, "fig", material.figures, troubles)
    body, tables = _floats(body, "tab", material.tables, troubles)
    left = {*material.figures, *material.tables} - {*figures, *tables}
    troubles.extend(f"figure or table `{name}` is not shown" for name in sorted(left))
    body = _wide_tables(body)
    body, headings = _headings(body)
    tests = _tests(body, evidence, troubles)
    labels = {f"eq:{name}": f"({material.prefix}{n})" for n, name in enumerate(equations, 1)}
    labels |= {f"fig:{name}": f"figure {n}" for n, name in enumerate(figures, 1)}
    labels |= {f"tab:{name}": f"table {n}" for n, name in enumerate(tables, 1)}
    labels |= {f"sec:{h.name}": f"“{h.text}”" for h in headings}
    labels |= {f"test:{name}": f"T{n}" for n, name in enumerate(tests, 1)}
    body = body.replace("<p>@evidence</p>", _evidence(tests, evidence))
    body = _references(body, labels, troubles)
    if troubles:
        raise Wrong("\n".join(troubles))
    return Page(title, body, headings, equations, figures, tables, used)


_VALUE = re.compile(r"@\{(!?)\s*([\w.]+)\s*(?:(~|<|>)\s*([^\s}]+)\s*(?:\+-\s*([^\s}]+))?)?\s*\}")


def _fill(source: str, material: Material, used: set[str], troubles: list[str]) -> str:
    def number(match: re.Match[str]) -> str:
        silent, name, sign, bound, room = match.groups()
        known = material.numbers.get(name)
        if known is None:
            troubles.append(f"no number is computed with the name `{name}`")
            return "?"
        used.add(name)
        if sign:
            limit = float(bound)
            holds = {
                "<": known.value < limit,
                ">": known.value > limit,
                "~": abs(known.value - limit) <= float(room or 0.0),
            }[sign]
            if not holds:
                troubles.append(f"`{name}` is {known.value:.6g}; the text says {match.group(0)}")
        return "" if silent else known.text

    return _VALUE.sub(number, source)


def _title(body: str) -> tuple[str, str]:
    match = re.search(r"<h1[^>]*>(.*?)</h1>\s*", body, re.S)
    if match is None:
        raise Wrong("the page has no title")
    return body.replace(match.group(0), "", 1), match.group(1)


def _formulas(body: str) -> str:
    """What browsers draw better: a dot that is a letter of its own, and alignment by attribute alone,
    which the style sheet turns into the words that each browser follows."""
    dotted = r'<mover>(<mi[^>]*>[^<]*</mi>)<mo accent="true">\u0307</mo></mover>'
    body = re.sub(dotted, '<mover accent="true">\\1<mo>\u02d9</mo></mover>', body)
    return re.sub(r' style="text-align: [^"]*"', "", body)


_DISPLAYED = r'<math display="block"(?:(?!</math>).)*</math>'


def _equations(body: str, prefix: str) -> tuple[str, list[str]]:
    names: list[str] = []

    def numbered(match: re.Match[str]) -> str:
        formula, name = match.groups()
        names.append(name)
        return (
            f'<div class="equation" id="eq:{name}"><div class="formula">{formula}</div>'
            f'<a class="number" href="#eq:{name}">({prefix}{len(names)})</a></div>'
        )

    body = re.sub(rf"<p>({_DISPLAYED})\s*\(eq:([\w-]+)\)</p>", numbered, body, flags=re.S)
    return re.sub(
        rf"<p>({_DISPLAYED})</p>", r'<div class="equation"><div class="formula">\1</div></div>', body, flags=re.S
    ), names


def _floats(body: str, kind: str, known: dict[str, str], troubles: list[str]) -> tuple[str, list[str]]:
    names: list[str] = []
    word = {"fig": "Figure", "tab": "Table"}[kind]

    def shown(match: re.Match[str]) -> str:
        name, caption = match.groups()
        names.append(name)
        if name not in known:
            troubles.append(f"there is no {word.lower()} `{name}`")
            return ""
        caption = re.sub(r"^\s*<p>(.*)</p>\s*$", r"\1", caption, flags=re.S)
        caption = f"<figcaption><b>{word} {len(names)}.</b> {caption}</figcaption>"
        parts = (caption, known[name]) if kind == "tab" else (known[name], caption)
        return f'<figure class="{kind}" id="{kind}:{name}">{parts[0]}{parts[1]}</figure>'

    return re.sub(rf'<div id="{kind}:([\w.-]+)">(.*?)</div>', shown, body, flags=re.S), names


def _wide_tables(body: str) -> str:
    """Tables written in the text scroll by themselves where the page is narrow."""
    return re.sub(r"<table>(.*?)</table>", r'<div class="wide"><table>\1</table></div>', body, flags=re.S)


def _headings(body: str) -> tuple[str, list[Heading]]:
    found: list[Heading] = []

    def anchored(match: re.Match[str]) -> str:
        level, name, text = int(match.group(1)), match.group(2), match.group(3)
        found.append(Heading(level, name, re.sub(r"<[^>]*>", "", text)))
        anchor = f'<a class="anchor" href="#{name}" aria-label="link to this section">#</a>'
        return f'<h{level} id="{name}">{text} {anchor}</h{level}>'

    return re.sub(r'<h([23]) id="([^"]*)"[^>]*>(.*?)</h\1>', anchored, body, flags=re.S), found


_REFERENCE = re.compile(r"@((?:eq|fig|tab|sec|test):[\w.-]*\w)")


def _tests(body: str, evidence: dict[str, dict], troubles: list[str]) -> list[str]:
    """Names of evidence in the order of first mention; each must exist in the code."""
    names = list(dict.fromkeys(r[5:] for r in _REFERENCE.findall(body) if r.startswith("test:")))
    for name in names:
        if name not in evidence:
            troubles.append(f"no evidence has the name `{name}`")
    troubles.extend(f"the page does not mention the evidence `{name}`" for name in evidence if name not in names)
    for name, entry in evidence.items():
        path = ROOT / entry["file"]
        wanted = f'name = "{entry["case"]}"' if "case" in entry else f"fn {entry['test']}("
        if not path.is_file() or wanted not in path.read_text():
            troubles.append(f"evidence `{name}`: no `{wanted}` in {entry['file']}")
    return [name for name in names if name in evidence]


def _evidence(names: list[str], evidence: dict[str, dict]) -> str:
    rows = []
    for n, name in enumerate(names, 1):
        entry = evidence[name]
        place = html.escape(entry.get("test") or f"“{entry['case']}”")
        rows.append(
            f'<tr id="test:{name}"><td>T{n}</td><td>{html.escape(entry["says"])}</td>'
            f'<td><code>{place}</code><br><span class="path">{html.escape(entry["file"])}</span></td></tr>'
        )
    head = "<thead><tr><th></th><th>shows that</th><th>test</th></tr></thead>"
    return f'<div class="wide"><table class="evidence">{head}<tbody>{"".join(rows)}</tbody></table></div>'


def _references(body: str, labels: dict[str, str], troubles: list[str]) -> str:
    def link(match: re.Match[str]) -> str:
        target = match.group(1)
        if target not in labels:
            troubles.append(f"`@{target}` refers to nothing")
            return ""
        anchor = target[4:] if target.startswith("sec:") else target
        style = ' class="test"' if target.startswith("test:") else ""
        return f'<a{style} href="#{anchor}">{labels[target]}</a>'

    return _REFERENCE.sub(link, body)
