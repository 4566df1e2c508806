"""The pair of a case as two rotors of ROSS with its gear element, from the tables that `snakemake handover` writes.

Run as `python examples/ross_gears.py results/with/handover`.
"""

import sys
from pathlib import Path

import numpy as np
import pandas as pd
import ross

BEARING = 1e13  # N/m, nearly rigid: two in series with the mesh lower its frequency by k_m / BEARING
SHAFT = ross.Material("light_steel", rho=1.0, E=2.1e11, G_s=8e10)  # no inertia but that of the gears
STEEL = 7850.0  # kg/m3; the mass of a gear body moves nothing while its bearings are rigid


def rotor(gear: pd.Series) -> ross.Rotor:
    """Return one gear on a short shaft, held at the gear and at both ends."""
    width, bore = gear["face_width [m]"], gear["bore_radius [m]"]
    inertia = gear["moment_of_inertia [kg m2]"]
    mass = STEEL * np.pi * width * (gear["reference_radius [m]"] ** 2 - bore**2)
    element = ross.GearElement(
        n=1,
        m=mass,
        Id=inertia / 2 + mass * width**2 / 12,
        Ip=inertia,
        n_teeth=int(gear["teeth"]),
        base_diameter=2 * gear["base_radius [m]"],
        pr_angle=gear["working_pressure_angle [rad]"],
    )
    shaft = [ross.ShaftElement(L=width, idl=0.0, odl=2 * bore, material=SHAFT) for _ in range(2)]
    bearings = [ross.BearingElement(n=node, kxx=BEARING, kyy=BEARING, kzz=BEARING, cxx=0.0) for node in range(3)]
    return ross.Rotor(shaft, [element], bearings)


def pair(folder: Path, cycle: int) -> ross.MultiRotor:
    """Return both rotors with the mean mesh stiffness of a wear cycle between their gears."""
    gears = pd.read_csv(folder / "gears.csv", index_col="gear")
    states = pd.read_csv(folder / "states.csv", index_col="wear_cycle")
    return ross.MultiRotor(
        rotor(gears.loc["pinion"]),
        rotor(gears.loc["gear"]),
        coupled_nodes=(1, 1),
        gear_mesh_stiffness=states.at[cycle, "mean_stiffness [N m-1]"],
    )


def natural_frequency(folder: Path, cycle: int) -> float:
    """Return the lowest natural frequency in torsion, rad/s: that of the mesh; ROSS leaves out the free rotation."""
    modal = pair(folder, cycle).run_modal(speed=0, num_modes=24)
    return min(w for w, shape in zip(modal.wn, modal.shapes, strict=True) if shape.mode_type == "Torsional")


if __name__ == "__main__":
    case = Path(sys.argv[1])
    frequencies = pd.read_csv(case / "states.csv", index_col="wear_cycle")["natural_frequency [rad s-1]"]
    for cycle, ours in frequencies.iloc[[0, -1]].items():
        theirs = natural_frequency(case, cycle)
        print(f"wear cycle {cycle}: here {ours:.3f} rad/s, ROSS {theirs:.3f} rad/s, {theirs / ours - 1:+.1e}")
