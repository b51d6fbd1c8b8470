"""Cost over the length of a chain, and peers on the same work in the same run.

    python bench/bench.py [--lengths 100 300 1000 3000] [--repeat 3] [--out out/bench.json]

Times are CPU seconds of one process and differ between machines; read the ratios and exponents.
Peers are compared where they are installed (`pip install -r bench/requirements.txt`).
"""

import argparse
import json
import math
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import flexure as fx
from chain import chain

HERE = Path(__file__).parent
END, OUTPUTS = 1.0, 500


def swing(segments: int) -> dict[str, float]:
    """Reads the chain, swings it for a second, and says what it took."""
    model = fx.Model()
    began = time.process_time()
    model.execute(chain(segments))
    read = time.process_time()
    run = model.simulate(end=END, steps=OUTPUTS)
    done = time.process_time()
    work = run.statistics
    return {
        "segments": segments,
        "reading_s": read - began,
        "simulation_s": done - read,
        "us_per_part_and_step": 1e6 * (done - read) / segments / work["steps"],
        "tip_z": float(run["TIP.Z"][-1]),
        **{name: work[name] for name in ("steps", "newton_iterations", "jacobians", "factorisations")},
    }


def exponent(rows: list[dict[str, float]], column: str) -> float:
    """Slope of log(cost) over log(length), least squares."""
    points = [(math.log(r["segments"]), math.log(r[column])) for r in rows]
    mean_x = sum(x for x, _ in points) / len(points)
    mean_y = sum(y for _, y in points) / len(points)
    return sum((x - mean_x) * (y - mean_y) for x, y in points) / sum((x - mean_x) ** 2 for x, _ in points)


def peer(segments: int) -> float | None:
    """CPU seconds of Exudyn on the same chain, output interval and second; none if not installed."""
    command = [sys.executable, str(HERE / "peer_exudyn.py"), str(segments), str(END), str(OUTPUTS)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return json.loads(done.stdout.splitlines()[-1])["solve_s"] if done.returncode == 0 else None


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lengths", type=int, nargs="+", default=[100, 300, 1000, 3000])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--out", type=Path, default=None)
    options = parser.parse_args()
    rows = []
    print(f"{'N':>6} {'read s':>8} {'run s':>8} {'us/part/step':>13} {'steps':>6} {'Newton':>7} {'factor':>7} {'peer s':>8} {'peer/us':>8}")
    for segments in options.lengths:
        row = min((swing(segments) for _ in range(options.repeat)), key=lambda r: r["simulation_s"])
        row["peer_s"] = peer(segments)
        ratio = row["peer_s"] / row["simulation_s"] if row["peer_s"] else None
        rows.append(row)
        tail = f"{row['peer_s']:8.3f} {ratio:8.2f}" if ratio else f"{'-':>8} {'-':>8}"
        print(
            f"{segments:6d} {row['reading_s']:8.3f} {row['simulation_s']:8.3f} {row['us_per_part_and_step']:13.2f}"
            f" {row['steps']:6d} {row['newton_iterations']:7d} {row['factorisations']:7d} {tail}"
        )
    summary = {"exponent_of_run": exponent(rows, "simulation_s"), "exponent_of_reading": exponent(rows, "reading_s")}
    print(f"exponent of the run over N: {summary['exponent_of_run']:.3f}; of reading: {summary['exponent_of_reading']:.3f}")
    if rows[0]["peer_s"] is None:
        print("no peer installed; see bench/requirements.txt")
    out = options.out or Path(tempfile.gettempdir()) / "flexure-bench.json"
    out.write_text(json.dumps({"rows": rows, **summary}, indent=1))
    print(out)


if __name__ == "__main__":
    main()
