"""Everything the page of the beam shows: numbers, charts and tables, computed by the program and held
against closed forms."""

from __future__ import annotations

import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import numpy as np

from . import elastica, markers, tables
from .charts import Look, Panel, figure
from .mechanisms import Case, case
from .page import Material, written
from .program import ROOT, Program, Refused

COUNTS = [1, 2, 4, 8, 16, 32]
ROOT_SIDE = Look("LINEAR, J at the root", "c1", "o")
TIP_SIDE = Look("LINEAR, J at the tip", "c2", "v", "--")
STRING = Look("STRING", "c3", "s")
NONLINEAR = Look("NONLINEAR", "c4", "D")
EXACT = Look("exact", "ink", "")
# The stretch that every chain of the elastica tables has, EA L^2 / EI.
EA = 1e6


@dataclass
class Workshop:
    """The program, and what the page is made of."""

    program: Program
    material: Material = field(default_factory=lambda: Material(prefix="B."))

    def many(self, tasks: list) -> list:
        """Results of calls without arguments; two at a time, in order."""
        with ThreadPoolExecutor(2) as pool:
            return list(pool.map(lambda task: task(), tasks))


def material(program: Program) -> Material:
    shop = Workshop(program)
    for part in (_markers, _tables, _limits, _signs, _inside, _elastica, _shapes):
        part(shop)
    for part in (_roll_up, _buckling, _princeton, _frequencies):
        part(shop)
    return shop.material


def order(counts: list[int], errors: list[float]) -> float:
    """Slope of log error over log 1/N through the last three points."""
    tail = slice(-3, None)
    slope, _ = np.polyfit(np.log(np.array(counts, float)[tail]), np.log(np.abs(np.array(errors))[tail]), 1)
    return -float(slope)


def _markers(shop: Workshop) -> None:
    shop.material.figures["markers"] = f'<div class="charts">{markers.displacement()}{markers.loads()}</div>'


def _tables(shop: Workshop) -> None:
    shown = shop.material.tables
    for verb in ("create", "modify"):
        reference = shop.program.command("force", verb, "element_like", "beam")
        shown[verb] = tables.parameters(reference)
        if reference["rules"]:
            shown[f"{verb}.rules"] = tables.rules(reference)
    shown["damping"] = tables.triangle()
    shown["shear"] = tables.shear(shop.program)
    flat = shop.program.section("rectangle", "--width", "1", "--height", "4")
    shop.material.number("polar.flat", (flat["iyy"] + flat["izz"]) / flat["ixx"], ".1f")
    shop.material.number("angles.ten", math.radians(10.0) * 10.0 / 2.0, ".1f")


def _signs(shop: Workshop) -> None:
    """Both ends of one beam under tip loads of 1, 2 and 3 N along x, y and z."""
    length, pull = 2.0, (1.0, 2.0, 3.0)
    models = [ROOT / "mechanisms" / "beams" / "beams.cmd"]
    at = {"I": 0, "J": 1}
    components = {"FX": 2, "FY": 3, "FZ": 4, "TX": 6, "TY": 7, "TZ": 8}
    requests = [
        f"output_control create request request_name=.chain.{end} "
        + " ".join(f'f{c}="BEAM(.chain.beam_1,{flag},{c},0)"' for c in components.values())
        for end, flag in at.items()
    ]
    names = (".chain.part_1.node_1", ".chain.ground.node_0")
    requests += [
        f"output_control create request request_name=.chain.R{end} output_type=force "
        f"i_marker_name={i} j_marker_name={j} r_marker_name=.chain.ground.node_0"
        for end, (i, j) in {"I": names, "J": names[::-1]}.items()
    ]
    force = "tip force " + " ".join(f"{axis}={size:g}" for axis, size in zip("xyz", pull))
    chain = f"chain n=1 length={length:g} ea=1e5 ei_y=200 ei_z=100 gj=100"
    last = shop.program.run(models, [chain, force, *requests, "simulation single_run equilibrium model_name=.chain"])
    rows, series = [], dict(zip(components, ("X", "Y", "Z", "R1", "R2", "R3")))
    for name, c in components.items():
        values = [last[f"{end}.F{c}"] for end in at]
        requested = [last[f"R{end}.{series[name]}"] for end in at]
        if not np.allclose(values, requested, rtol=1e-12, atol=1e-12):
            raise AssertionError(f"BEAM and the force request differ in {name}: {values}, {requested}")
        rows.append([name, *values])
        for end, value in zip(at, values):
            shop.material.number(f"signs.{end}.{name}", value, ".4f")
    arm = np.array([last["TIP.X"], last["TIP.Y"], last["TIP.Z"]])
    load_i, load_j = (np.array([last[f"{end}.F{c}"] for c in components.values()]) for end in at)
    left = np.abs(load_j[3:] + load_i[3:] + np.cross(arm, load_i[:3])).max() / np.abs(load_j).max()
    shop.material.number("signs.imbalance", left)
    shop.material.tables["signs"] = tables.signs(rows)


def _tip_cases() -> dict[int, dict[Look, Case]]:
    def of(word: str, alpha: int) -> Case:
        return case("elastica", f"{word}, J at the root side, alpha = {alpha}")

    words = {ROOT_SIDE: "LINEAR", STRING: "STRING", NONLINEAR: "NONLINEAR"}
    cases = {alpha: {look: of(word, alpha) for look, word in words.items()} for alpha in (1, 10)}
    cases[1][TIP_SIDE] = case("elastica", "LINEAR, J at the tip side, alpha = 1")
    # The same commands under the larger load.
    cases[10][TIP_SIDE] = cases[1][TIP_SIDE]
    return cases


KEYS = {ROOT_SIDE: "root", TIP_SIDE: "tip", STRING: "string", NONLINEAR: "nonlinear"}


def _elastica(shop: Workshop) -> None:
    cases = _tip_cases()
    counts = COUNTS
    for alpha in (1, 10):
        bent, classic = elastica.tip_force(alpha), elastica.by_elliptic_integrals(alpha)
        if not np.allclose((bent.u, bent.v), classic, rtol=0, atol=1e-11):
            raise AssertionError(f"quadrature {bent.u, bent.v} and elliptic integrals {classic} differ")
        shop.material.number(f"elastica.{alpha}.u", bent.u, ".8f")
        shop.material.number(f"elastica.{alpha}.v", bent.v, ".8f")
        shop.material.number(f"elastica.{alpha}.slope", math.degrees(bent.slope), ".1f")
    panels, rows = [], []
    for alpha in (1, 10):
        truth = elastica.tip_force(alpha, EA)
        errors: dict[Look, dict[int, tuple[float, float]]] = {}
        for look in KEYS:
            expected = {int(i["n"]): (i, e) for i, e in cases[alpha][look].rows() if i["alpha"] == alpha}
            found = shop.many([_tip_task(shop, cases[alpha][look], alpha, n, expected.get(n)) for n in counts])
            errors[look] = {n: (abs(f["u"] - truth.u), abs(f["v"] - truth.v)) for n, f in zip(counts, found) if f}
        for k in range(2):
            panel = Panel(
                f"α = {alpha}: {'shortening u' if k == 0 else 'deflection v'}", "number of beams N", "error / L"
            )
            panel.log = panel.counts = True
            for look in KEYS:
                drawn = {n: e[k] for n, e in errors[look].items() if e[k] > 0.0}
                panel.add(look, drawn.keys(), drawn.values())
            panels.append(panel)
        for look, key in KEYS.items():
            orders = [order(list(errors[look]), [e[k] for e in errors[look].values()]) for k in (0, 1)]
            for symbol, value in zip("uv", orders):
                shop.material.number(f"order.{key}.{alpha}.{symbol}", value, ".2f")
            for n, both in errors[look].items():
                for symbol, value in zip("uv", both):
                    shop.material.number(f"error.{key}.{alpha}.{n}.{symbol}", 100.0 * value, ".2g")
            rows.append([look.label, f"α\u00a0=\u00a0{alpha}", *orders, *errors[look][counts[-1]]])
    shop.material.figures["elastica"] = figure(panels, "Error of a cantilever of N beams under a tip load.", list(KEYS))
    shop.material.tables["orders"] = tables.plain(
        ["formulation", "load", "order in u", "order in v", f"error of u, N = {counts[-1]}", "error of v"],
        [[r[0], r[1], *(written(x, ".2f") for x in r[2:4]), *(written(x, ".1e") for x in r[4:])] for r in rows],
    )


def _tip_task(shop: Workshop, of: Case, alpha: int, n: int, expected):
    def task():
        if expected is not None:
            return of.compared(shop.program, *expected)
        if (alpha, n) == (10, 1) and of.data["name"].startswith("STRING"):
            # The table has a case of its own for it.
            return None
        try:
            found = of.values(shop.program, {"alpha": alpha, "n": n})
        except Refused:
            return None
        # An equilibrium far from the elastica is one of the chain, not an approximation.
        return found if abs(found["v"] - elastica.tip_force(alpha).v) < 0.5 else None

    return task


def _shapes(shop: Workshop) -> None:
    of, n = case("elastica", "NONLINEAR, J at the root side, alpha = 1"), 4
    loads = [1, 2, 4, 10]
    panel = Panel(
        "", "x / L", "y / L", size=(5.0, 4.4), equal=True, limits={"xlim": (-0.02, 1.05), "ylim": (-0.02, 0.88)}
    )
    curve, nodes = Look("elastica", "ink", ""), Look(f"chain of {n} NONLINEAR beams", "c4", "D", "")
    largest = 0.0
    found = shop.many([lambda a=a: of.shape(shop.program, {"alpha": a, "n": n}, n) for a in loads])
    for alpha, (x, y) in zip(loads, found):
        exact = elastica.tip_force(alpha)
        panel.add(curve, exact.x, exact.y, linewidth=1.3)
        panel.add(nodes, x, y)
        largest = max(largest, math.hypot(x[-1] - exact.x[0], y[-1] - exact.y[0]))
    shop.material.number("shapes.n", n, "d")
    shop.material.number("shapes.largest", 100.0 * largest, ".2g")
    linear = case("elastica", "LINEAR, J at the root side, alpha = 1")
    other = Panel("", "x / L", "y / L", size=(5.0, 4.4), equal=True, limits=panel.limits)
    plain = Look(f"chain of {n} LINEAR beams", "c1", "o", "")
    panel.title, other.title = "NONLINEAR, α = 1, 2, 4, 10", "LINEAR, α = 1, 2, 4, 10"
    found = shop.many([lambda a=a: linear.shape(shop.program, {"alpha": a, "n": n}, n) for a in loads])
    largest = 0.0
    for alpha, (x, y) in zip(loads, found):
        exact = elastica.tip_force(alpha)
        other.add(curve, exact.x, exact.y, linewidth=1.3)
        other.add(plain, x, y)
        largest = max(largest, math.hypot(x[-1] - exact.x[0], y[-1] - exact.y[0]))
    shop.material.number("shapes.largest.linear", 100.0 * largest, ".2g")
    shop.material.figures["shapes"] = figure([panel, other], "Nodes of chains on the elastica.", [curve, nodes, plain])


def _inside(shop: Workshop) -> None:
    """Moment and axial force along chains, and of the elastica."""
    alpha, n = 4, 4
    exact = elastica.tip_force(alpha)
    moment = Panel("bending moment", "s / L", "M / PL", size=(5.0, 3.9))
    axial = Panel("axial force", "s / L", "N / P", size=(5.0, 3.9))
    curve = Look("elastica", "ink", "")
    moment.add(curve, exact.s, exact.moment / alpha, linewidth=1.3)
    axial.add(curve, exact.s, np.sin(exact.angle), linewidth=1.3)
    looks = {"nonlinear": Look("NONLINEAR", "c4", "D"), "linear": Look("LINEAR, J at the root", "c1", "o")}
    shop.material.number("inside.n", n, "d")
    for key, look in looks.items():
        of = case("elastica", f"{key.upper()}, J at the root side, alpha = 1")
        last = of.series(shop.program, {"alpha": alpha, "n": n}, "--beam-loads")
        ends = [[last[f"beam_{k}.MZ_{end}"] / alpha for end in "JI"] for k in range(1, n + 1)]
        stations = [[(k - 1) / n, k / n] for k in range(1, n + 1)]
        moment.add(look, sum(stations, []), sum(ends, []))
        pulls = [[last[f"beam_{k}.N"] / alpha] * 2 for k in range(1, n + 1)]
        axial.add(look, sum(stations, []), sum(pulls, []), markersize=3.5)
        known = np.interp(sum(stations, []), exact.s[::-1], exact.moment[::-1] / alpha)
        shop.material.number(f"inside.moment.{key}", 100.0 * float(np.abs(known - sum(ends, [])).max()), ".2g")
    shop.material.figures["inside"] = figure(
        [moment, axial], "What goes through a bent cantilever.", [curve, *looks.values()]
    )


def _roll_up(shop: Workshop) -> None:
    half = {
        "LINEAR": case("roll_up", "LINEAR: half a circle"),
        "NONLINEAR": case("roll_up", "NONLINEAR: half a circle"),
    }
    for name, of in half.items():
        for inputs, expected in of.rows():
            found = of.compared(shop.program, inputs, expected)
            error = math.hypot(found["x"], found["y"] - 2.0 / math.pi)
            shop.material.number(f"half.{name.lower()}.{int(inputs['n'])}", 100.0 * error, ".2g")
    curve = Look("circle", "ink", "")
    panels, n = [], 8
    for look, name in ((Look("NONLINEAR", "c4", "D", ""), "NONLINEAR"), (Look("LINEAR", "c1", "o", ""), "LINEAR")):
        of = half[name]
        data = {**of.data, "commands": [c.replace("3.141592653589793", "{m}") for c in of.data["commands"]]}
        turned = Case(of.folder, of.models, data)
        limits = {"xlim": (-0.3, 1.05), "ylim": (-0.05, 0.85)}
        panel = Panel(f"{name}, {n} beams", "x / L", "y / L", size=(5.0, 3.9), equal=True, limits=limits)
        for share in (0.25, 0.5, 0.75, 1.0):
            moment = 2.0 * math.pi * share
            x, y = turned.shape(shop.program, {"n": n, "m": moment}, n)
            panel.add(curve, *elastica.circle(moment), linewidth=1.3)
            panel.add(look, x, y)
            if share == 1.0:
                shop.material.number(f"closed.{name.lower()}", math.hypot(x[-1], y[-1]))
        panels.append(panel)
    legend = [curve, Look("NONLINEAR", "c4", "D", ""), Look("LINEAR", "c1", "o", "")]
    shop.material.figures["roll-up"] = figure(panels, "A chain rolled up by an end moment.", legend)


def _buckling(shop: Workshop) -> None:
    names = {ROOT_SIDE: "LINEAR, J at the root side", TIP_SIDE: "LINEAR, J at the tip side"}
    names |= {STRING: "STRING, J at the root side", NONLINEAR: "NONLINEAR, J at the root side"}
    error = Panel("above Euler's load", "number of beams N", "P / Euler’s load − 1", log=True, counts=True)
    ratio = Panel("buckling load", "number of beams N", "P / Euler’s load", counts=True, level=1.0)
    for look, name in names.items():
        of = case("buckling", name)
        rows = of.rows()
        found = shop.many([lambda r=r: of.compared(shop.program, *r)["ratio"] for r in rows])
        counts = [int(i["n"]) for i, _ in rows]
        # What is left of a converged NONLINEAR chain is the rounding of the search.
        kept = [(n, v - 1.0) for n, v in zip(counts, found) if v - 1.0 > 1e-6]
        error.add(look, *zip(*kept))
        ratio.add(look, counts, found)
        for n, value in zip(counts, found):
            shop.material.number(f"buckling.{KEYS[look]}.{n}", value, ".4f")
            shop.material.number(f"buckling.error.{KEYS[look]}.{n}", 100.0 * (value - 1.0), ".2g")
        shop.material.number(f"buckling.order.{KEYS[look]}", order(*map(list, zip(*kept))), ".2f")
    shop.material.figures["buckling"] = figure([ratio, error], "Buckling load of a cantilever of N beams.", list(names))


def _princeton(shop: Workshop) -> None:
    exact_case = case("princeton", "geometrically exact beam")
    exact = next(e["twist"] for i, e in exact_case.rows() if i == {"p": 13.345, "angle": 45})
    shop.material.number("princeton.exact", exact, ".4f")
    vector_root = Look("LINEAR, J at the root", "c1", "o")
    vector_tip = Look("LINEAR, J at the tip", "c2", "v", "--")
    names = {
        vector_root: "LINEAR, rotation vector, J at the root side",
        vector_tip: "LINEAR, rotation vector, J at the tip side",
        NONLINEAR: "NONLINEAR with shear, J at the root side",
    }
    twist = Panel("twist of the tip, degrees", "number of beams N", "degrees", counts=True, level=exact)
    error = Panel("error of the twist", "number of beams N", "error / exact", log=True, counts=True)
    sums: dict[int, list[float]] = {}
    for look, name in names.items():
        of = case("princeton", name)
        rows = of.rows()
        found = shop.many([lambda r=r: of.compared(shop.program, *r)["twist"] for r in rows])
        counts = [int(i["n"]) for i, _ in rows]
        twist.add(look, counts, found)
        errors = [abs(v / exact - 1.0) for v in found]
        error.add(look, counts, errors)
        key = {vector_root: "root", vector_tip: "tip", NONLINEAR: "nonlinear"}[look]
        for n, value, off in zip(counts, found, errors):
            shop.material.number(f"princeton.{key}.{n}", value, ".3f")
            shop.material.number(f"princeton.error.{key}.{n}", 100.0 * off, ".2g")
            if look is not NONLINEAR:
                sums.setdefault(n, []).append(value)
        # Finer NONLINEAR chains are as good as the reference is printed.
        shop.material.number(f"princeton.first.{key}", math.log2(errors[0] / errors[1]), ".2f")
        shop.material.number(f"princeton.order.{key}", order(counts, errors), ".2f")
    # STRING measures in the axes of J like LINEAR, and errs alike.
    linear = case("princeton", names[vector_root])
    commands = [c.replace("formulation=linear", "formulation=string") for c in linear.data["commands"]]
    string = Case(linear.folder, linear.models, {**linear.data, "commands": commands})
    counts = [4, 8, 16, 32]
    found = shop.many([lambda n=n: string.values(shop.program, {"n": n})["twist"] for n in counts])
    shop.material.number("princeton.order.string", order(counts, [v / exact - 1.0 for v in found]), ".2f")
    mean = Look("mean of the two", "c5", "^", ":")
    both = {n: abs(sum(pair) / 2.0 / exact - 1.0) for n, pair in sums.items()}
    error.add(mean, both.keys(), both.values())
    for n, off in both.items():
        shop.material.number(f"princeton.error.mean.{n}", 100.0 * off, ".2g")
    shop.material.figures["princeton"] = figure([twist, error], "Twist of the Princeton beam.", [*names, mean])


def _frequencies(shop: Workshop) -> None:
    looks = [Look("first bending mode", "c1", "o"), Look("second", "c3", "s"), Look("third", "c4", "D")]
    panels = []
    for layout, title in (("nodes", "masses at the nodes"), ("segments", "rigid segments")):
        of = case("frequencies", f"{layout}, LINEAR")
        rows = of.rows()
        found = shop.many([lambda r=r: of.compared(shop.program, *r) for r in rows])
        counts = [int(i["n"]) for i, _ in rows]
        panel = Panel(title, "number of beams N", "|ω / ω exact − 1|", log=True, counts=True)
        for k, look in enumerate(looks, 1):
            errors = [abs(f[f"w{k}"] - 1.0) for f in found]
            panel.add(look, counts, errors)
            for n, off in zip(counts, errors):
                shop.material.number(f"frequency.{layout}.{n}.{k}", 100.0 * off, ".2g")
            shop.material.number(f"frequency.order.{layout}.{k}", order(counts, errors), ".2f")
        panels.append(panel)
    shop.material.figures["frequencies"] = figure(panels, "Error of the bending frequencies of a cantilever.", looks)
    of = case("frequencies", "damping in proportion to stiffness")
    inputs, expected = of.rows()[-1]
    found = of.compared(shop.program, inputs, expected)
    shop.material.number("zeta.ratio", inputs["ratio"], "g")
    shop.material.number("zeta.1", found["zeta1"], ".6g")


def _limits(shop: Workshop) -> None:
    """Numbers that the code states, read where it states them."""
    element = (ROOT / "crates/elements/src/forces/beam/element.rs").read_text()
    for name, constant in (("small", "SMALL_ANGLE"), ("large", "LARGE_ANGLE")):
        part = element.split(f"pub const {constant}: f64 = std::f64::consts::PI / ")[1].split(";")[0]
        shop.material.number(f"limit.{name}", 180.0 / float(part), "g")
