"""Charts as drawings in the page, which take their colours from the style sheet, so that they follow
it from light to dark. A figure is made of panels that stand side by side where there is room."""

from __future__ import annotations

import html
import io
import re
import zlib
from dataclasses import dataclass, field

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt
from matplotlib import font_manager
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter, NullLocator

from .fonts import CHART_FONT

font_manager.fontManager.addfont(CHART_FONT)

# Colours that stand for those of the style sheet.
_INK, _MUTED, _GRID = "#010203", "#010204", "#010205"
_HUES = {f"c{n}": f"#0a0b0{n}" for n in range(1, 6)}
_COLOURS = {"ink": _INK, "muted": _MUTED, "grid": _GRID, **_HUES}
_NAMES = {colour: name for name, colour in _COLOURS.items()}

plt.rcParams.update(
    {
        "font.family": "Source Sans Pro",
        "font.size": 12,
        "mathtext.fontset": "stix",
        "svg.fonttype": "none",
        "svg.hashsalt": "flexure",
        "axes.edgecolor": _MUTED,
        "axes.labelcolor": _INK,
        "axes.linewidth": 0.8,
        "axes.titlesize": 12.5,
        "axes.titlecolor": _INK,
        "text.color": _INK,
        "xtick.color": _MUTED,
        "ytick.color": _MUTED,
        "xtick.labelcolor": _INK,
        "ytick.labelcolor": _INK,
        "grid.color": _GRID,
        "grid.linewidth": 0.7,
        "axes.spines.top": False,
        "axes.spines.right": False,
    }
)


@dataclass(frozen=True)
class Look:
    """How a series is drawn everywhere in the manual; shape and dash tell as much as colour."""

    label: str
    hue: str
    marker: str = "o"
    dash: str = "-"


@dataclass
class Panel:
    """One chart."""

    title: str
    across: str
    up: str
    size: tuple[float, float] = (5.0, 3.9)
    curves: list[tuple] = field(default_factory=list)
    log: bool = False
    counts: bool = False
    equal: bool = False
    limits: dict = field(default_factory=dict)
    level: float | None = None

    def add(self, look: Look, x, y, **more) -> None:
        self.curves.append((look, list(x), list(y), more))


def figure(panels: list[Panel], describe: str, legend: list[Look] | None = None) -> str:
    """Panels with one legend. `describe` is what a reader who cannot see it should know."""
    drawn = "".join(_panel(panel, describe) for panel in panels)
    return f'<div class="charts">{drawn}</div>{_legend(legend or [])}'


_SHAPES = {"o": "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0z", "s": "M-3.6,-3.6h7.2v7.2h-7.2z", "^": "M0,-4.6L4.4,3.4H-4.4z"}
_SHAPES |= {"D": "M0,-4.8L4.8,0L0,4.8L-4.8,0z", "v": "M0,4.6L4.4,-3.4H-4.4z", "": ""}
_DASHES = {"-": "none", "--": "6 3", ":": "2 2.5", "": "0 99"}


def _legend(looks: list[Look]) -> str:
    items = []
    for look in looks:
        line = f'<line x1="2" y1="7" x2="30" y2="7" stroke-width="2" stroke-dasharray="{_DASHES[look.dash]}"/>'
        mark = f'<path d="{_SHAPES[look.marker]}" transform="translate(16 7)" fill="currentColor" stroke="none"/>'
        items.append(
            f'<li><svg viewBox="0 0 32 14" width="32" height="14" aria-hidden="true" style="color:var(--{look.hue})" '
            f'stroke="currentColor">{line}{mark}</svg>{html.escape(look.label)}</li>'
        )
    return f'<ul class="legend">{"".join(items)}</ul>' if items else ""


def _panel(panel: Panel, describe: str) -> str:
    figure, axes = plt.subplots(figsize=panel.size, layout="constrained")
    for look, x, y, more in panel.curves:
        style = {"color": _COLOURS[look.hue], "linewidth": 1.7, "markersize": 5.5} | more
        axes.plot(x, y, linestyle=look.dash or "none", marker=look.marker or None, **style)
    if panel.log:
        axes.set_yscale("log")
    if panel.counts:
        _count_axis(axes, sorted({x for _, xs, _, _ in panel.curves for x in xs}))
    if panel.level is not None:
        axes.axhline(panel.level, color=_MUTED, linewidth=1.0, dashes=(5, 3), zorder=1)
    if panel.equal:
        axes.set_aspect("equal")
    axes.set(**panel.limits)
    axes.set_title(panel.title, loc="left", pad=8)
    axes.set_xlabel(panel.across)
    axes.set_ylabel(panel.up)
    axes.grid(True, which="major")
    axes.set_axisbelow(True)
    out = io.StringIO()
    figure.savefig(out, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    plt.close(figure)
    return _themed(out.getvalue(), f"{describe} {panel.title}")


def _count_axis(axes, counts: list[float]) -> None:
    """Numbers of beams on a logarithmic axis."""
    axes.set_xscale("log", base=2)
    axes.xaxis.set_major_locator(FixedLocator(counts))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda n, _: f"{n:g}"))


def _themed(text: str, describe: str) -> str:
    """The drawing without its header, its names made unique in the page, its colours from the sheet."""
    svg = text[text.index("<svg") :]
    svg = re.sub(r"<metadata>.*?</metadata>", "", svg, flags=re.S)
    svg = re.sub(r"<!--.*?-->\s*", "", svg, flags=re.S)
    view = re.search(r'viewBox="([^"]*)"', svg).group(1)
    inner = svg[svg.index(">") + 1 :]
    own = f"g{zlib.crc32(inner.encode()):08x}-"
    wanted = set(re.findall(r'(?:href="#|url\(#)([^")]+)', inner))
    inner = re.sub(r' id="([^"]*)"', lambda m: f' id="{own}{m[1]}"' if m[1] in wanted else "", inner)
    inner = re.sub(r'(href="#|url\(#)', rf"\1{own}", inner)
    for colour, name in _NAMES.items():
        inner = inner.replace(colour, f"var(--{name})")
    inner = inner.replace("'Source Sans Pro'", "var(--sans)")
    inner = re.sub(r'<style type="text/css">[^<]*</style>', "", inner)
    return f'<svg class="chart" role="img" aria-label="{html.escape(describe)}" viewBox="{view}">{inner}'
