"""Runs the program and reads what it writes."""

from __future__ import annotations

import csv
import json
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Refused(Exception):
    """The program found no solution, and said so."""


@dataclass(frozen=True)
class Program:
    """The binary `flexure`."""

    path: Path

    def command(self, *words: str) -> dict:
        """The table of a command."""
        return json.loads(self._output("support", *words, "--format", "json"))

    def section(self, *words: str) -> dict:
        """The properties of a cross section."""
        return json.loads(self._output("section", *words, "--format", "json"))

    def run(self, models: list[Path], commands: list[str], *options: str) -> dict[str, float]:
        """The last row of the last simulation, by the names of its series."""
        with tempfile.TemporaryDirectory() as folder:
            self._output("run", *map(str, models), *_edits(commands), "--out", folder, *options)
            results = sorted(Path(folder).glob("*.csv"))
            if not results:
                raise Refused(f"no results of {commands}")
            with results[-1].open(newline="") as file:
                rows = list(csv.reader(file))
        return dict(zip(rows[0], map(float, rows[-1])))

    def modes(self, models: list[Path], commands: list[str], *options: str) -> list[dict]:
        """Linear modes, the slowest first."""
        # `modes` reads one model; the other files are read by command.
        read = [f'file command read file_name="{path}"' for path in models[1:]]
        return json.loads(self._output("modes", str(models[0]), *_edits(read + commands), "--json", *options))["modes"]

    def _output(self, *arguments: str) -> str:
        done = subprocess.run([self.path, *arguments], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Refused(f"flexure {' '.join(arguments)}\n{done.stderr}")
        return done.stdout


def _edits(commands: list[str]) -> list[str]:
    return [word for command in commands for word in ("-e", command)]
