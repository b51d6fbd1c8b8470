"""A command file of a wanted size, in the layout of an export: a tower of parts joined by beams.

    python bench/big_cmd.py OUT.cmd MEGABYTES
"""

import sys
from collections.abc import Iterator
from itertools import count, islice
from pathlib import Path
from typing import TextIO

HEAD = """\
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
defaults units  &
   coordinate_system_type = cartesian  &
   orientation_type = body313
!
model create  &
   model_name = tower
!
marker create  &
   marker_name = .tower.ground.foot  &
   adams_id = 1  &
   location = 0.0, 0.0, 0.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
"""

# One storey: a part with two markers, its mass, and the beam to the storey below.
STOREY = """\
!---------------------------------- storey_{k} ----------------------------------!
!
defaults coordinate_system  &
   default_coordinate_system = .tower.ground
!
part create rigid_body name_and_position  &
   part_name = .tower.storey_{k}  &
   adams_id = {part_id}  &
   location = 0.0, 0.0, {height:.1f}  &
   orientation = 0.0d, 0.0d, 0.0d
!
defaults coordinate_system  &
   default_coordinate_system = .tower.storey_{k}
!
marker create  &
   marker_name = .tower.storey_{k}.cm  &
   adams_id = {cm_id}  &
   location = 0.0, 0.0, 150.0  &
   orientation = 0.0d, 0.0d, 0.0d
!
marker create  &
   marker_name = .tower.storey_{k}.top  &
   adams_id = {top_id}  &
   location = 0.0, 0.0, 300.0  &
   orientation = 90.0d, 90.0d, 0.0d
!
part create rigid_body mass_properties  &
   part_name = .tower.storey_{k}  &
   mass = 5.6025  &
   center_of_mass_marker = .tower.storey_{k}.cm  &
   ixx = 4.2E+04  &
   iyy = 4.2E+04  &
   izz = 1.8E+04  &
   ixy = 0.0  &
   izx = 0.0  &
   iyz = 0.0
!
defaults coordinate_system  &
   default_coordinate_system = .tower.ground
!
force create element_like beam  &
   beam_name = .tower.column_{k}  &
   adams_id = {k}  &
   i_marker_name = .tower.storey_{k}.top  &
   j_marker_name = {below}  &
   length = 300.0  &
   area_of_cross_section = 2400.0  &
   y_shear_area_ratio = 1.2  &
   z_shear_area_ratio = 1.2  &
   youngs_modulus = 2.07E+05  &
   shear_modulus = 7.95E+04  &
   ixx = 1.1E+06  &
   iyy = 7.2E+05  &
   izz = 3.2E+05  &
   damping_ratio = 2.0E-03
!
"""


def storeys() -> Iterator[str]:
    """The commands of each storey, without end."""
    below = ".tower.ground.foot"
    for k in count(1):
        ids = {"part_id": k + 1, "cm_id": 2 * k, "top_id": 2 * k + 1}
        yield STOREY.format(k=k, height=300.0 * k, below=below, **ids)
        below = f".tower.storey_{k}.top"


def write(out: TextIO, size: int) -> int:
    """Writes whole storeys until the text has `size` bytes; returns their number."""
    written = out.write(HEAD)
    for number, storey in enumerate(storeys(), 1):
        written += out.write(storey)
        if written >= size:
            return number
    return 0


def tower(number: int) -> str:
    """A text of so many storeys."""
    return HEAD + "".join(islice(storeys(), number))


def main() -> None:
    path, megabytes = Path(sys.argv[1]), float(sys.argv[2])
    with path.open("w", encoding="utf-8") as out:
        number = write(out, round(megabytes * 1e6))
    print(f"{path}: {path.stat().st_size} bytes, {number} storeys")


if __name__ == "__main__":
    main()
