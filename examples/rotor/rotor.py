"""The rotor from Python: stiffer blades, another run, both compared. Usage: rotor.py OUT_FOLDER"""

import sys
from pathlib import Path

import flexure as fx

out = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
model = fx.read(Path(__file__).with_name("rotor.cmd"))
before = model.simulate(end=2.0, steps=400)
for name, beam in model.beams.items():
    if "blade_1" in name:
        beam.youngs_modulus = 2 * beam.youngs_modulus
after = model.simulate(end=2.0, steps=400)
for title, run in (("as given", before), ("blade 1 twice as stiff", after)):
    tip = run["TIP_1.MAG"]
    print(f"{title}: tip of blade 1 at {tip[-1]:.6f} {tip.unit}, {run.statistics['steps']} steps")
after.to_parquet(out / "rotor_stiffer.parquet")
