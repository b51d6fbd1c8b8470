"""Reading command files: time and memory over their length, with a peer on the same files.

    python bench/reading.py [--sizes 0.1 1 10 100] [--repeat 3] [--peer-up-to 10] [--out out/reading.json]

Files hold parts, markers and beams, each with a name of its own (`big_cmd.py`). Times are CPU seconds of
the whole process (user and system, the best of a few runs). Memory is its peak; of short files it is not
told, as a process counts what this interpreter held when it was started. Times differ between machines;
read the exponents and the ratios.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

import big_cmd

HERE = Path(__file__).parent
FLEXURE = HERE.parent / "target" / "release" / "flexure"
EXAMPLE = HERE.parent / "examples" / "rotor" / "rotor.cmd"
SHORT_FILES = 60  # runs of a process that takes milliseconds
BEAMS = 10_000
MODIFICATIONS = 200
# A session of so many lines, an object in each, and ends of half-typed commands: a keyword, a parameter,
# objects of many by their bare and by their full names, a word.
LINES = 10_000
SESSION = "model create model_name = m\npart create rigid_body name_and_position part_name = p\n"
HALF_TYPED = [
    "",
    "forc",
    "force modify element_like ",
    "marker modify marker_name = ",
    "marker modify marker_name = .m.p.mar",
    "force create element_like beam beam_name = b i_marker_name = marker_1",
    "force create element_like beam beam_name = b formulation = ",
]


def measured(command: list[str]) -> dict[str, float]:
    """Runs a command and says what it took."""
    began = time.perf_counter()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    wall = time.perf_counter() - began
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise SystemExit(f"{' '.join(command)} ended with status {process.returncode}")
    return {"cpu_s": used.ru_utime + used.ru_stime, "wall_s": wall, "peak_bytes": used.ru_maxrss * 1024}


def least(runs: Sequence[dict[str, float]]) -> dict[str, float]:
    return {key: min(run[key] for run in runs) for key in runs[0]}


def best(command: list[str], repeat: int) -> dict[str, float]:
    return least([measured(command) for _ in range(repeat)])


def exponent(points: list[tuple[float, float]]) -> float:
    """Slope of log(cost) over log(length), least squares."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def peer(file: Path) -> dict[str, float] | None:
    """What the linter of adams_vscode takes for a file; none if it is not installed."""
    done = subprocess.run(
        [sys.executable, str(HERE / "peer_linter.py"), str(file)], capture_output=True, text=True, check=False
    )
    return json.loads(done.stdout.splitlines()[-1]) if done.returncode == 0 else None


def shown(row: dict[str, float], verb: str) -> str:
    """Memory for each byte of input, where it is known."""
    known = row.get(f"{verb}_bytes_per_byte")
    return "-" if known is None else f"{known:.1f}"


def ratio(row: dict[str, float], above: str, below: str) -> str:
    return f"{row[above] / row[below]:.1f}x" if above in row and below in row else "-"


def over_length(folder: Path, options: argparse.Namespace) -> list[dict[str, float]]:
    """Checks and runs files of all sizes; prints a line for each."""
    empty = folder / "empty.cmd"
    empty.write_text("! no command\n", encoding="utf-8")
    fixed = best([str(FLEXURE), "check", str(empty)], SHORT_FILES)
    print(f"fixed cost of a process: {1e3 * fixed['cpu_s']:.1f} ms of CPU, {fixed['peak_bytes'] / 1e6:.1f} MB")
    print("net: without the fixed cost")
    print(
        f"{'MB':>7} {'check s':>8} {'MB/s':>6} {'net':>6} {'B/B':>5} {'run s':>8} {'MB/s':>6} {'net':>6} {'B/B':>5}"
        f" {'peer s':>8} {'time':>7} {'memory':>7}"
    )
    rows = []
    for size in options.sizes:
        file = folder / f"{size:g}.cmd"
        with file.open("w", encoding="utf-8") as out:
            big_cmd.write(out, round(size * 1e6))
        length = file.stat().st_size
        row: dict[str, float] = {"bytes": length}
        # What takes milliseconds is measured more often: the best of few says more about the machine.
        repeat = options.repeat if size > 1.0 else max(options.repeat, SHORT_FILES)
        verbs = ("check", "run")
        # By turns: what disturbs the machine for a moment does not meet one of them alone.
        rounds = [[measured([str(FLEXURE), verb, str(file)]) for verb in verbs] for _ in range(repeat)]
        for verb, runs in zip(verbs, zip(*rounds, strict=True), strict=True):
            took = least(runs)
            row[f"{verb}_s"] = took["cpu_s"]
            row[f"{verb}_net_s"] = max(took["cpu_s"] - fixed["cpu_s"], 1e-6)
            row[f"{verb}_wall_s"] = took["wall_s"]
            if took["peak_bytes"] > 1.1 * fixed["peak_bytes"]:
                row[f"{verb}_bytes_per_byte"] = took["peak_bytes"] / length
        other = peer(file) if size <= options.peer_up_to else None
        tail = f"{'-':>8} {'-':>7} {'-':>7}"
        if other:
            row["peer_s"], row["peer_bytes_per_byte"] = other["cpu_s"], other["peak_bytes"] / length
            times = other["cpu_s"] / row["check_s"]
            memory = ratio(row, "peer_bytes_per_byte", "check_bytes_per_byte")
            tail = f"{other['cpu_s']:8.2f} {times:6.0f}x {memory:>7}"
        print(
            f"{size:7g} {row['check_s']:8.4f} {length / 1e6 / row['check_s']:6.1f} {length / 1e6 / row['check_net_s']:6.1f}"
            f" {shown(row, 'check'):>5} {row['run_s']:8.4f} {length / 1e6 / row['run_s']:6.1f}"
            f" {length / 1e6 / row['run_net_s']:6.1f} {shown(row, 'run'):>5} {tail}"
        )
        rows.append(row)
        file.unlink()
    if not any("peer_s" in row for row in rows):
        print("peer not installed: put the folder adams-cmd-lsp of the repository adams_vscode on PYTHONPATH")
    return rows


def modification(folder: Path) -> dict[str, float]:
    """One parameter of one beam of many, and back: seconds of each, and whether undo is exact."""
    import flexure as fx  # not before: a child process counts its parent's memory

    model = fx.Model()
    model.execute(big_cmd.tower(BEAMS))
    before, after = folder / "before.cmd", folder / "after.cmd"
    model.write(before)
    times = {"modify": 0.0, "undo": 0.0}
    for i in range(MODIFICATIONS):
        beam = f".tower.column_{1 + (i * 7919) % BEAMS}"
        command = f"force modify element_like beam beam_name = {beam} youngs_modulus = {2.0e5 + i}"
        for name, act in (("modify", lambda: model.execute(command)), ("undo", model.undo)):
            began = time.perf_counter()
            act()
            times[name] += time.perf_counter() - began
    model.write(after)
    exact = before.read_bytes() == after.read_bytes()
    return {"modify_s": times["modify"] / MODIFICATIONS, "undo_s": times["undo"] / MODIFICATIONS, "undo_exact": exact}


def completion() -> float:
    """The longest that Tab takes at any of several places of a session of many lines: the best of a few."""
    import flexure as fx

    markers = (f"marker create marker_name = .m.p.marker_{k} location = {k}, 0, 0\n" for k in range(LINES))
    model = fx.Model()
    model.execute(SESSION + "".join(markers))
    longest = 0.0
    for text in HALF_TYPED:
        times = []
        for _ in range(5):
            began = time.perf_counter()
            # The engine alone, as the window asks it: `Model.complete` makes objects of its answer.
            _, found = model._native.complete(text)
            times.append(time.perf_counter() - began)
        assert found, text
        longest = max(longest, min(times))
    return longest


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", type=float, nargs="+", default=[0.1, 1.0, 10.0, 100.0], help="megabytes")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--peer-up-to", type=float, default=1.0, help="megabytes; the peer takes half a minute for 10")
    parser.add_argument("--out", type=Path, default=None)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rows = over_length(folder, options)
        summary: dict[str, float] = {}
        # Short files are dominated by the start of the process, long ones by memory that is touched for
        # the first time: what a page costs differs with what else the machine does.
        for verb in ("check", "run"):
            long = [row for row in rows if row["bytes"] >= 0.9e6]
            for sizes, key, taken in (("over all sizes", "", rows), ("from 1 MB on", "_from_1_MB", long)):
                if len(taken) > 1:
                    slope = exponent([(row["bytes"], row[f"{verb}_s"]) for row in taken])
                    summary[f"exponent_of_{verb}{key}"] = slope
                    print(f"exponent of {verb} {sizes}: {slope:.3f}")
        example = best([str(FLEXURE), "check", str(EXAMPLE)], SHORT_FILES)
        summary["example_ms"] = 1e3 * example["wall_s"]
        print(f"{EXAMPLE.name}, {EXAMPLE.stat().st_size} bytes: checked {1e3 * example['wall_s']:.1f} ms after process start")
        try:
            summary |= modification(folder)
            summary["completion_s"] = completion()
        except ImportError:
            print("the Python package is not installed: modify and undo are not measured")
        else:
            print(
                f"one parameter of one of {BEAMS} beams: modify {1e3 * summary['modify_s']:.3f} ms,"
                f" undo {1e3 * summary['undo_s']:.3f} ms, {'exact' if summary['undo_exact'] else 'NOT EXACT'}"
            )
            print(f"Tab in a session of {LINES} lines: {1e3 * summary['completion_s']:.1f} ms at most")
    out = options.out or Path(tempfile.gettempdir()) / "flexure-reading.json"
    out.write_text(json.dumps({"rows": rows, **summary}, indent=1))
    print(out)


if __name__ == "__main__":
    main()
