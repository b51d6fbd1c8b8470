"""A clamped chain of beams as command text: the model every benchmark of this folder swings."""

LENGTH = 10.0  # m
BREADTH, HEIGHT = 0.04, 0.08  # m; breadth along y, height along z
YOUNG, SHEAR, DENSITY = 2.1e11, 8.1e10, 7850.0  # Pa, Pa, kg/m^3
AREA = BREADTH * HEIGHT
IYY = BREADTH * HEIGHT**3 / 12.0
IZZ = HEIGHT * BREADTH**3 / 12.0
IXX = 0.229 * HEIGHT * BREADTH**3  # torsion constant of a 2:1 rectangle
SHEAR_RATIO = 1.2
DAMPING = 1.0e-3  # s
GRAVITY = (0.0, 2.0, -9.81)  # m/s^2


def chain(segments: int, name: str = "chain") -> str:
    """Command text of a steel bar cut into `segments` rigid parts, clamped at its left end."""
    length = LENGTH / segments
    mass = DENSITY * AREA * length
    inertia = (
        mass * (BREADTH**2 + HEIGHT**2) / 12.0,
        mass * (length**2 + HEIGHT**2) / 12.0,
        mass * (length**2 + BREADTH**2) / 12.0,
    )
    lines = [
        "defaults units length=meter angle=deg force=newton mass=kg time=second",
        f"model create model_name={name}",
        f"defaults coordinate_system default_coordinate_system=.{name}.ground",
        f"marker create marker_name=.{name}.ground.root location=0,0,0 orientation=0,0,0",
    ]
    for i in range(1, segments + 1):
        part = f".{name}.p{i}"
        behind = f".{name}.ground.root" if i == 1 else f".{name}.p{i - 1}.cm"
        lines += [
            f"part create rigid_body name_and_position part_name={part} location={i * length!r},0,0",
            f"marker create marker_name={part}.cm location=0,0,0 orientation=0,0,0 relative_to={part}",
            f"part create rigid_body mass_properties part_name={part} mass={mass!r} center_of_mass_marker={part}.cm"
            f" ixx={inertia[0]!r} iyy={inertia[1]!r} izz={inertia[2]!r}",
            f"force create element_like beam beam_name=.{name}.b{i} i_marker_name={part}.cm j_marker_name={behind}"
            f" length={length!r} area_of_cross_section={AREA!r} ixx={IXX!r} iyy={IYY!r} izz={IZZ!r}"
            f" y_shear_area_ratio={SHEAR_RATIO} z_shear_area_ratio={SHEAR_RATIO}"
            f" youngs_modulus={YOUNG!r} shear_modulus={SHEAR!r} damping_ratio={DAMPING!r} formulation=linear",
        ]
    x, y, z = GRAVITY
    lines += [
        f"force create body gravitational gravity_field_name=.{name}.gravity"
        f" x_component_gravity={x} y_component_gravity={y} z_component_gravity={z}",
        f"output_control create request request_name=.{name}.TIP output_type=displacement"
        f" i_marker_name=.{name}.p{segments}.cm j_marker_name=.{name}.ground.root",
    ]
    return "\n".join(lines) + "\n"
