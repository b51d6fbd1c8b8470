"""Tables: parameters as the program's own tables have them, damping terms, signs."""

from __future__ import annotations

import html

from .page import written
from .program import Program


def plain(head: list[str], rows: list[list[str]]) -> str:
    """A table of finished texts; the first column is words, the others numbers where they look so."""
    top = "".join(f"<th>{_raised(h)}</th>" for h in head)
    return _table("plain", top, ["<tr>" + "".join(_cell(c) for c in row) + "</tr>" for row in rows])


def _table(kind: str, head: str, rows: list[str]) -> str:
    top = f"<thead><tr>{head}</tr></thead>" if head else ""
    return f'<div class="wide"><table class="{kind}">{top}<tbody>{"".join(rows)}</tbody></table></div>'


def _cell(text: str) -> str:
    numeric = text[:1].isdigit() or text[:1] == "−"
    return f"<td{' class=number' if numeric else ''}>{_raised(text)}</td>"


def _raised(text: str) -> str:
    """`10^3^` as a power."""
    parts = html.escape(text).split("^")
    return "".join(f"<sup>{p}</sup>" if n % 2 else p for n, p in enumerate(parts))


def parameters(reference: dict) -> str:
    """All parameters of a command with type, dimension, default and meaning."""
    rows, verb = [], reference["command"].split()[1]
    for p in reference["parameters"]:
        name, short = p["name"], p["shortest"]
        shown = f"<b>{short}</b>{name[len(short) :]}"
        kind = " | ".join(f"<code>{w}</code>" for w in p["words"]) if p["words"] else html.escape(p["type"])
        if p["dimension"]:
            kind += f", {p['dimension'].replace('_', ' ')}"
        if p["most"] is None:
            kind += ", one or more" if p["least"] <= 1 else f", {p['least']} or more"
        elif p["most"] > 1:
            kind += f", {p['least']} values" if p["least"] == p["most"] else f", {p['least']} to {p['most']} values"
        if p["must_be"]:
            kind += f'<span class="bound">{html.escape(p["must_be"])}</span>'
        without = "required" if p["required"] else "unchanged" if verb == "modify" else "–"
        default = html.escape(p["default"] or without)
        if p["default"] and p["role"] == "value" and not p["default"].startswith("the "):
            default = f"<code>{default}</code>"
        keyword = f'<span class="keyword">{p["keyword"]}</span>' if p["keyword"] else ""
        rows.append(
            f'<tr id="{verb}.{name}"><td><code class="name">{shown}</code>{keyword}</td>'
            f"<td>{kind}</td><td>{default}</td><td>{html.escape(p['doc'])}</td></tr>"
        )
    head = "".join(f"<th>{h}</th>" for h in ("parameter", "type, dimension", "if omitted", "meaning"))
    return _table("parameters", head, rows)


def rules(reference: dict) -> str:
    """Conditions over several parameters; what excludes and is required at once is one line."""
    conditions = reference["rules"]
    needed = [c["names"] for c in conditions if c["rule"] == "at_least_one"]
    lines = []
    for c in conditions:
        if c["rule"] == "one_of":
            sets = [" with ".join(f"<code>{n}</code>" for n in s) for s in c["sets"]]
            lines.append(("exactly one of these sets", "; or ".join(sets)))
        elif c["rule"] == "at_most_one":
            word = "exactly one of" if c["names"] in needed else "at most one of"
            lines.append((word, ", ".join(f"<code>{n}</code>" for n in c["names"])))
        elif c["names"] not in [o.get("names") for o in conditions if o["rule"] == "at_most_one"]:
            lines.append(("at least one of", ", ".join(f"<code>{n}</code>" for n in c["names"])))
    return _table("rules", "", [f"<tr><td>{word}</td><td>{names}</td></tr>" for word, names in lines])


def triangle() -> str:
    """Places of the 21 damping terms: the lower triangle of a symmetric matrix by columns."""
    order = {place: n for n, place in enumerate(((r, c) for c in range(6) for r in range(c, 6)), 1)}
    force, rate = (
        ("F<sub>x</sub>", "F<sub>y</sub>", "F<sub>z</sub>"),
        ("V<sub>x</sub>", "V<sub>y</sub>", "V<sub>z</sub>"),
    )
    force += ("T<sub>x</sub>", "T<sub>y</sub>", "T<sub>z</sub>")
    rate += ("W<sub>x</sub>", "W<sub>y</sub>", "W<sub>z</sub>")
    head = "<th></th>" + "".join(f"<th>{r}</th>" for r in rate)
    rows = []
    for row in range(6):
        cells = []
        for column in range(6):
            n = order[(max(row, column), min(row, column))]
            style = "" if row >= column else ' class="mirrored"'
            cells.append(f"<td{style}>r<sub>{n}</sub></td>")
        rows.append(f"<tr><th>{force[row]}</th>{''.join(cells)}</tr>")
    return _table("matrix", head, rows)


def signs(rows: list[list]) -> str:
    head = ["component", "on I: BEAM(id, 0, …)", "on J: BEAM(id, 1, …)"]
    # Rounding of the solver is no sign.
    shown = [[name, *(0.0 if abs(v) < 5e-7 else v for v in values)] for name, *values in rows]
    return plain(head, [[name, *(written(v, ".4f") for v in values)] for name, *values in shown])


def shear(program: Program) -> str:
    """Shear ratios along y by both theories."""
    sizes = {
        "rectangle": ["rectangle", "--width", "2", "--height", "1"],
        "circle": ["circle", "--diameter", "1"],
        "thin round tube": ["tube", "--diameter", "1", "--thickness", "0.01"],
    }
    rows = [["", "energy", "Cowper"]]
    for name, words in sizes.items():
        values = [program.section(*words, "--theory", theory)["y_shear_area_ratio"] for theory in ("energy", "cowper")]
        rows.append([name, *(written(v, ".4f") for v in values)])
    return plain(rows[0], rows[1:])
