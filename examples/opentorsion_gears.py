"""The pair of a case as a torsional model of openTorsion, from the tables that `snakemake handover` writes.

Run as `python examples/opentorsion_gears.py results/with/handover`.
"""

import sys
from pathlib import Path

import pandas as pd
from opentorsion.assembly import Assembly
from opentorsion.elements.disk_element import Disk
from opentorsion.elements.elastic_gear_element import ElasticGear


def assembly(folder: Path, cycle: int) -> Assembly:
    """Return the free pair at a wear cycle: two inertias and the mesh between them.

    openTorsion wants the stiffness of a mesh as torque over the angle of the first gear: k r_b1^2. It counts the nodes
    of shafts and disks only, so the inertias are disks. For a drive train add shafts, with more nodes.
    """
    gears = pd.read_csv(folder / "gears.csv", index_col="gear")
    states = pd.read_csv(folder / "states.csv", index_col="wear_cycle")
    stiffness, radius = states.at[cycle, "mean_stiffness [N m-1]"], gears["base_radius [m]"]
    disks = [Disk(node, inertia) for node, inertia in enumerate(gears["moment_of_inertia [kg m2]"])]
    pinion = ElasticGear(0, 0.0, radius["pinion"])
    gear = ElasticGear(1, 0.0, radius["gear"], k=stiffness * radius["pinion"] ** 2, c=0.0, parent=pinion)
    return Assembly([], disks, elastic_gear_elements=[pinion, gear])


def natural_frequency(folder: Path, cycle: int) -> float:
    """Return the natural frequency of the mesh, rad/s; the other mode is the free rotation."""
    return float(max(assembly(folder, cycle).modal_analysis()[0]))


if __name__ == "__main__":
    case = Path(sys.argv[1])
    frequencies = pd.read_csv(case / "states.csv", index_col="wear_cycle")["natural_frequency [rad s-1]"]
    for cycle, ours in frequencies.iloc[[0, -1]].items():
        theirs = natural_frequency(case, cycle)
        print(f"wear cycle {cycle}: here {ours:.3f} rad/s, openTorsion {theirs:.3f} rad/s, {theirs / ours - 1:+.1e}")
