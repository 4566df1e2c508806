"""Every figure of tiny synthetic results: both files, the words on them, the same bytes twice."""

import xml.etree.ElementTree as ElementTree
from itertools import combinations
from pathlib import Path

import matplotlib.style
import numpy as np
import pytest
import xarray as xr
import yaml
from matplotlib.figure import Figure
from matplotlib.text import Text

from gearwear.figures import (
    basin_panels,
    bifurcation,
    excitations,
    exponents,
    flanks,
    history,
    mesh_force,
    portraits,
    sheet,
    study_panels,
)
from gearwear.studies.gathering import gathered
from gearwear.studies.outcome import impossible

ROOT = Path(__file__).resolve().parents[2]
STYLE = str(ROOT / "workflow" / "report" / "gearwear.mplstyle")
CASES = ("without", "with")
START, SINGLE, PITCH, DOUBLE, END = 2e-3, 8e-3, 10e-3, 11e-3, 17e-3
STATES = [
    {"case": "without", "cycle": 0, "bulk_temperature": 20.0, "running_cycles": 0, "flash": False},
    {"case": "with", "cycle": 21, "bulk_temperature": 100.0, "running_cycles": 2.1e9, "flash": True},
]
WORN = {**STATES[1], "cycle": 1, "place": 1}  # at the end of a life of one wear cycle
SWEPT = {
    "mesh_frequency": {"cases": ["without", "with"], "first": 0.1, "last": 1.7, "points": 9},
    "ste": {"cases": ["with"], "first": 0.1, "last": 3.0, "points": 9, "mesh_frequency": 1.0},
    "backlash": {
        "cases": ["with"],
        "first": 0.1,
        "last": 1.5,
        "points": 9,
        "mesh_frequency": 1.0,
        "reading": "rescale",
    },
}
CLASSES = {
    "restart": [1, 1, 2, 4, 8, 3, 0, 101, 101],
    "up": [1, 1, 2, 4, 8, 3, 0, 101, 101],
    "down": [1, 2, 2, 4, 8, 3, 0, 101, 101],
}


HEAT, AGE = "cases.with.bulk_temperature", "cases.with.running_cycles"


@pytest.fixture(scope="module")
def results():
    """Return the datasets of two states, three sweeps, their portraits and a study, by name."""
    found = {}

    def add(name, variables, coordinates):
        found[name] = xr.Dataset(variables, coordinates, {"lineage": f"made of {name}"})

    zones = ((START, SINGLE, 7), (SINGLE, DOUBLE, 4), (DOUBLE, END, 7))
    path = np.concatenate([np.linspace(low, high, count) for low, high, count in zones])
    single = np.repeat([0.0, 1.0, 0.0], [count for *_, count in zones])
    phase = (np.arange(10) + 0.5) / 10
    of_phase = {"mesh_phase": phase}
    of_gears = {"gear": ["pinion", "gear"], "path": path}
    points = {
        "start_of_contact": START,
        "lowest_single_contact": SINGLE,
        "pitch_point": PITCH,
        "highest_single_contact": DOUBLE,
        "end_of_contact": END,
        "contact_ratio": 1.6,
        "leaving": ("mesh_phase", np.where(phase < 0.6, 0, -1)),
        "entering": ("mesh_phase", np.arange(1, 11)),
        "mesh_phase_width": ("mesh_phase", np.full(10, 0.1)),
        "partner": ("path", np.concatenate([np.arange(11, 18), np.full(4, -1), np.arange(7)])),
    }
    add("geometry", points, of_gears | of_phase)
    along, mesh = ("gear", "path"), np.where(phase < 0.6, 3.5e8, 2e8)
    for i, case in enumerate(CASES):
        wear = i * 1e-6 * (1 + single) * np.abs(path - PITCH) / PITCH
        growth = i * np.stack([5e-6 - path / 1e4, 3e-6 + path / 1e4])
        worn = {"wear_depth": (along, np.stack([3 * wear, wear])), "running_cycles": i * 2.1e9}
        add(f"{case}_wear", worn, of_gears)
        add(f"{case}_deformation", {"thermal_growth": (along, growth)}, of_gears)
        springs = {"pair_stiffness": ("path", np.full(18, 2e8)), "pair_coupling": ("path", np.zeros(18))}
        stiffness = {"mesh_stiffness": ("mesh_phase", mesh * (1 - 0.03 * i))} | springs
        add(f"{case}_mesh_stiffness", stiffness, of_phase | {"path": path})
        error = {
            "transmission_error": ("mesh_phase", 4e3 / mesh * (1 + 0.1 * i)),
            "effective_stiffness": ("mesh_phase", mesh * (1 - 0.1 * i)),
            "elastic_deflection": ("path", 1e-5 * (1 + single)),
            "load_share_path": ("path", (1 + single) / 2),
            "sharing_error": ("path", np.linspace(1e-6 * i, 0, 18)),
        }
        add(f"{case}_transmission_error", error, of_phase | {"path": path})
        clearance = {"backlash_path": ("path", 7e-5 - 5e-6 * i + 3e-6 * single), "initial_half_backlash": 6.5e-5}
        add(f"{case}_backlash", clearance, {"path": path})
        contact = {
            "flash_temperature": 90 * i * np.abs(path - PITCH) / PITCH,
            "friction_coefficient": 0.06 - 0.01 * single,
            "film_ratio": 0.3 + path * 20,
        }
        contact["contact_temperature"] = 20 + 80 * i + contact["flash_temperature"]
        add(f"{case}_temperature", {name: ("path", values) for name, values in contact.items()}, {"path": path})
        time = np.arange(1 + i)[:, None] + np.append(phase, phase[:8])
        force = 4000 + 800 * np.cos(2 * np.pi * time) + 100 * i * np.cos(np.pi * time)
        moving = {"mesh_frequency_ratio": 0.28, "mean_force": 4000.0, "motion_class": 1 + i}
        add(f"{case}_response", moving | {"mesh_force_path": (("response_period", "path"), force)}, {"path": path})
        for sweep, settings in SWEPT.items():
            swept = np.linspace(settings["first"], settings["last"], settings["points"])
            for order, classes in CLASSES.items():
                add(f"{case}_{sweep}_{order}", motion(classes), {sweep: ("point", swept)})
            add(f"{case}_{sweep}_branches", branches(), {sweep: ("node", swept[[0, 3, 5, 5, 8]])})
            time = np.linspace(0, 2 * np.pi, 65)
            orbit = {
                "orbit_displacement": (("point", "time"), np.tile(np.cos(time), (3, 1))),
                "orbit_velocity": (("point", "time"), np.tile(np.sin(time), (3, 1))),
            }
            add(f"{case}_{sweep}_basins", *basins(sweep, swept[[1, 3, 5, 7]]))
            add(f"{case}_{sweep}_portraits", motion([1, 0, 101]) | orbit, {sweep: ("point", swept[[1, 3, 7]])})
    return found | {"study": life()}


def life():
    """Return a study of seven temperatures and eight ages, whose motions leave period 1 ever earlier."""
    members = []
    for place in range(56):
        one = impossible({"first": 0.1, "last": 1.7, "points": 9}, "").copy()
        later = np.arange(9) > 6 - place % 8 / 4
        one["motion_class"][:] = np.where(later, 101, [1, 1, 1, 2, 2, 4, 8, 6, 0])
        one["contact_loss_share"][:] = np.where(np.arange(9) > 2, 0.1, 0.0)
        one["force_max"][:] = 1.0 + 0.8 * np.arange(9)
        one["pinion_speed"][:] = (11000.0 - 200 * (place // 8)) * one["mesh_frequency"].values
        members.append(one.assign(running_speed=3400.0))
    axes = {HEAT: [20, 40, 60, 80, 100, 120, 140], AGE: [3e8 * i for i in range(8)]}
    return gathered(axes, [f"member_{i:04d}" for i in range(56)], members)


def branches():
    """Return a branch of period 1 that doubles, and the branch of period 2 from there."""
    upper, lower = [0.0, 0.3, 0.5, 0.5, 0.9], [np.nan, np.nan, np.nan, 0.5, -0.9]
    return {
        "branch_index": ("node", [0, 0, 0, 1, 1]),
        "branch_displacement": (("node", "iterate"), np.transpose([upper, lower])),
        "stable": ("node", [1, 1, 0, 0, 0]),
        "special_point": ("node", [0, 0, 2, 0, 0]),
        "branch_period": ("branch", [1, 2]),
    }


def basins(sweep, values):
    """Return variables and coordinates: period 1 twice and chaos everywhere, undecided cells at the last point."""
    points, cells = len(values), 6
    found = {
        name: (("point", "attractor", *dims[1:]), np.stack([array] * points))
        for name, (dims, array) in motion([1, 1, 101]).items()
        for dims in [dims if isinstance(dims, tuple) else (dims,)]
    }
    index = np.arange(points * cells * cells).reshape(points, cells, cells) % 3
    index[-1, :2] = -1
    centres = np.linspace(-1.5, 1.5, cells)
    found |= {
        "basin": (("point", "displacement_cell", "velocity_cell"), index),
        "attractors": ("point", [3] * points),
        "share": (("point", "attractor"), [[0.25, 0.35, 0.4]] * points),
        "share_error": (("point", "attractor"), [[0.01, 0.02, 0.03]] * points),
        "undecided_share": ("point", [0.0] * (points - 1) + [1 / 3]),
    }
    coordinates = {
        sweep: ("point", values),
        "initial_displacement": ("displacement_cell", centres),
        "initial_velocity": ("velocity_cell", centres),
    }
    return found, coordinates


def motion(classes):
    """Return section, class, period and exponent of points of the classes given."""
    classes = np.array(classes)
    period = np.where(classes < 100, classes, 0)
    sample = np.arange(20)
    section = np.sin(1.3 * np.stack([sample % one if one else sample for one in period]))
    exponent = np.where(classes == 101, 0.05, -0.08)
    return {
        "section_displacement": (("point", "sample"), section),
        "section_velocity": (("point", "sample"), 0.5 * section),
        "motion_class": ("point", classes),
        "conflict": ("point", np.where(classes == 2, 1, 0)),
        "period": ("point", period),
        "lyapunov_exponent": ("point", np.where(classes == 0, np.nan, exponent)),
    }


STATED = {"states": STATES}
PANELS = [
    {"sweep": sweep, "swept": settings, "state": state}
    for sweep, settings in SWEPT.items()
    for state in STATES
    if state["case"] in settings["cases"]
]
MESH = ("mesh_stiffness", "transmission_error")

# draw function; inputs that are of both states; settings
FIGURES = {
    6: (flanks.draw_wear, ("wear",), STATED),
    7: (flanks.draw_growth, ("deformation",), STATED),
    8: (excitations.draw_stiffness, MESH, STATED),
    9: (excitations.draw_transmission_error, ("transmission_error",), STATED),
    10: (excitations.draw_lengths, ("deformation", "transmission_error", "wear"), STATED),
    11: (excitations.draw_backlash, ("backlash",), STATED),
    "contact temperature": (flanks.draw_contact_temperature, ("temperature",), STATED),
    "load sharing": (flanks.draw_load_sharing, (*MESH, "response"), STATED),
    "mesh force": (mesh_force.draw, ("response",), STATED),
    "wear history": (history.draw, ("wear", "transmission_error"), {"states": [WORN]}),
}
OF_SWEEPS = {
    12: (bifurcation.draw, "mesh_frequency"),
    13: (portraits.draw, "mesh_frequency"),
    14: (portraits.draw, "mesh_frequency"),
    15: (bifurcation.draw, "ste"),
    16: (portraits.draw, "ste"),
    17: (bifurcation.draw, "backlash"),
    18: (portraits.draw, "backlash"),
    "basins": (basin_panels.draw, "backlash"),
}


def inputs_of(results, name):
    """Return draw function, named inputs and settings of a figure, by its number or name."""
    if name in FIGURES:
        draw, names, cfg = FIGURES[name]
        files = {one: [results[f"{case}_{one}"] for case in CASES] for one in names}
        return draw, {"geometry": results["geometry"]} | files, cfg
    if name == "study":
        cfg = {"axes": [HEAT, AGE], "units": {HEAT: "degC", AGE: "1"}, "order": "restart"}
        return study_panels.draw, {"study": results["study"]}, cfg
    if name == "exponents":
        sweeps = [results[f"{one['state']['case']}_{one['sweep']}_restart"] for one in PANELS]
        return exponents.draw, {"sweeps": sweeps}, {"panels": PANELS}
    draw, sweep = OF_SWEEPS[name]
    cfg = {"sweep": sweep, "swept": SWEPT[sweep]}
    if draw is bifurcation.draw:
        states = [state for state in STATES if state["case"] in SWEPT[sweep]["cases"]]
        files = {
            kind: [results[f"{state['case']}_{sweep}_{kind}"] for state in states] for kind in (*CLASSES, "branches")
        }
        claims = [ROOT / "config" / "paper_claims.yaml"]
        return draw, files | {"claims": claims}, cfg | {"states": states, "order": "restart"}
    state = STATES[0 if name == 13 else 1]
    kind = "basins" if name == "basins" else "portraits"
    return draw, {kind: results[f"{state['case']}_{sweep}_{kind}"]}, cfg | {"state": state}


def write(results, folder, name):
    """Draw and write a figure; return the paths of SVG and PNG."""
    draw, files, cfg = inputs_of(results, name)
    folder.mkdir(exist_ok=True)
    svg, png = folder / "figure.svg", folder / "figure.png"
    draw.write(files | {"cfg": cfg}, STYLE, svg, png)
    return svg, png


def words_of(svg):
    """Return all text of an SVG, without spaces."""
    texts = ElementTree.parse(svg).getroot().iter("{http://www.w3.org/2000/svg}text")
    return "|".join("".join("".join(text.itertext()).split()) for text in texts)


WORDS = {
    6: ["Weardepth(µm)", "(a)Pinion", "(d)Gear,enlarged", "dedendum", "pitchpoint"],
    7: ["Thermalgrowthofoneflank(µm)", "(a)Pinion", "(b)Gear", "addendum"],
    8: ["Meshstiffness(10⁸N/m)", "nominal", "effective"],
    9: ["Statictransmissionerror(µm)", "onepairincontact"],
    10: ["growthofthefourflanks", "elasticdeflection", "wearofbothflanks", "16.0", "12.0", "0.0"],
    11: ["Halfbacklash(µm)", "initial,65µm"],
    12: [
        "Meshfrequencyovernaturalfrequency",
        "CH,chaotic",
        "?,notdecided",
        "QP,quasi-periodic",
        "(b)Case“with”",
        "unstableorbits",
        "section,fromrest",
        "upanddowndiffer",
        "evidencedisagrees",
    ],
    13: ["(a)0.3", "P1,−0.080", "?,noexponent", "CH,+0.050", "Displacementoverinitialhalfbacklash", "Case“without”"],
    14: ["(a)0.3", "sectionatpairentry"],
    15: ["Meanstatictransmissionerror", "downwards", "paper", "exponent", "perioddoubling"],
    16: ["meshfrequency/naturalfrequency=1"],
    17: ["Meanbacklashoveritsinitialvalue", "swepthalfbacklash"],
    18: ["Displacementoverswepthalfbacklash"],
    "basins": [
        "(d)1.325",
        "P1:25.0±1.0%",
        "P1:35.0±2.0%",
        "CH:40.0±3.0%",
        "undecided:33.3%",
        "Initialdisplacementoverswepthalfbacklash",
        "timesnaturalfrequency",
    ],
    "wear history": ["(a)Pinion", "Greatestweardepth(µm)", "Revolutionsofthepinion(10⁹)", "with,100°C"],
    "contact temperature": [
        "Flashtemperaturerise(K)",
        "Coefficientoffriction(1)",
        "(d)Filmthicknessoverroughness",
        "pitchpoint",
    ],
    "load sharing": ["(a)Staticmeshforce", "(b)Dynamicmeshforce", "Loadofthepair|overmeanmeshforce"],
    "mesh force": ["Dynamicmeshforce(kN)", "Amplitude(N)", "Orderofthemeshfrequency", "(c)100°C,2.1×10⁹cycles:P2"],
    "study": [
        "(a)20°C",
        "(g)140°C",
        "(h)endofperiod1,",
        "ofcontact(dashed)",
        "Pinionspeed,10³rpm",
        "contactislostbeyond",
        "Revolutions,10⁹",
    ],
    "exponents": ["(a)Case“without”", "(d)Case“with”", "LargestLyapunovexponent(perunitofdimensionlesstime)"],
}


def texts_of(figure):
    """Yield what is written on a figure, the labels of ticks beyond the limits left out, and the box of each."""
    for text in figure.findobj(Text):
        if text.get_text().strip() and text.get_visible():
            yield text, text.get_window_extent()


def hidden_labels(figure):
    """Return the labels of ticks that are not drawn."""
    ticks = [
        (axis, tick) for axes in figure.axes for axis in (axes.xaxis, axes.yaxis) for tick in axis.get_major_ticks()
    ]
    return {
        label
        for axis, tick in ticks
        for label in (tick.label1, tick.label2)
        if not min(axis.get_view_interval()) <= tick.get_loc() <= max(axis.get_view_interval())
    }


def assert_readable(figure):
    """Assert that no text is too small, runs off the sheet or stands on another."""
    with matplotlib.style.context(STYLE, after_reset=True):
        figure.set_dpi(400)  # as it is written: letters are wider on a coarse grid
        figure.draw_without_rendering()
        hidden = hidden_labels(figure)
        written = [(text, box) for text, box in texts_of(figure) if text not in hidden]
    assert len(written) > 10
    assert min(text.get_fontsize() for text, _ in written) >= 6
    left, bottom, right, top = figure.bbox.extents
    inside = [left <= box.x0 <= box.x1 <= right and bottom <= box.y0 <= box.y1 <= top for _, box in written]
    assert [text.get_text() for (text, _), whole in zip(written, inside, strict=True) if not whole] == []
    over = [(a.get_text(), b.get_text()) for (a, one), (b, other) in combinations(written, 2) if one.overlaps(other)]
    assert over == []


@pytest.mark.parametrize("name", WORDS)
def test_figure_is_written_with_its_words_legible_and_the_same_bytes_twice(results, tmp_path, monkeypatch, name):
    sheets = []
    monkeypatch.setattr(sheet, "Figure", lambda **settings: sheets.append(Figure(**settings)) or sheets[-1])
    svg, png = write(results, tmp_path / "first", name)
    again = write(results, tmp_path / "second", name)
    assert [svg.read_bytes(), png.read_bytes()] == [path.read_bytes() for path in again]
    assert png.read_bytes().startswith(b"\x89PNG")
    words = words_of(svg)
    missing = [word for word in [*WORDS[name], "°C"] if word not in words]
    assert missing == []
    assert sorted(path.name for path in svg.parent.iterdir()) == ["figure.png", "figure.svg"]
    assert_readable(sheets[0])


def test_every_state_of_the_diagonal_is_named_with_temperature_and_cycles(results, tmp_path):
    words = words_of(write(results, tmp_path, 6)[0])
    assert "20°C,unworn" in words
    assert "100°C,2.1×10⁹cycles" in words


def test_pictures_name_their_results_but_no_date_or_software(results, tmp_path):
    svg, png = write(results, tmp_path, 7)
    for path in (svg, png):
        content = path.read_bytes()
        assert b"gearwear made of with_deformation made of without_deformation made of geometry" in content
        assert b"Matplotlib v" not in content
        assert b"<dc:date>" not in content


def test_no_file_is_left_when_a_figure_fails(results, tmp_path):
    broken = results | {"with_backlash": xr.Dataset()}
    with pytest.raises(KeyError):
        write(broken, tmp_path, 11)
    assert list(tmp_path.iterdir()) == []


def test_windows_of_the_paper_are_those_of_the_case():
    windows = bifurcation.windows
    claims = yaml.safe_load((ROOT / "config" / "paper_claims.yaml").read_text())["claims"]
    of_frequency = [list(windows(claims, "mesh_frequency", case)) for case in CASES]
    assert of_frequency[0] == of_frequency[1]
    assert (1.05, 1.18, "P2") in of_frequency[0]
    one = {"kind": "window", "case": "without", "sweep": "ste", "range": [0, 1], "class": ["P1"]}
    assert [list(windows([one], "ste", case)) for case in CASES] == [[(0, 1, "P1")], []]
    assert list(windows(claims, "ste", "without")) == []
    assert (0.51, 1.11, "QP") in list(windows(claims, "ste", "with"))


def test_a_figure_without_portraits_is_refused_with_the_key_to_fill():
    one = xr.Dataset(motion([1]), {"ste": ("point", [0.5])})
    empty = one.isel(point=[])
    assert portraits.height(empty) == portraits.height(one)
    with pytest.raises(ValueError, match="portraits.ste"):
        portraits.draw(None, empty, {"sweep": "ste"})


def test_load_of_a_pair_is_its_share_of_every_period_and_nothing_where_the_mesh_is_open():
    geometry = xr.Dataset({"partner": ("path", [1, 0, -1])})
    stiffness = {"pair_stiffness": [3e8, 1e8, 2e8], "pair_coupling": [0.0, 0.0, 0.0]}
    transmission = {"sharing_error": [0.0, 0.0, 0.0], "load_share_path": [0.75, 0.25, 1.0]}
    made = [xr.Dataset({name: ("path", values) for name, values in one.items()}) for one in (stiffness, transmission)]
    force = ("response_period", "path"), [[4e3, 4e3, 6e3], [-8e3, 4e3, 2e3]]
    response = xr.Dataset({"mesh_force_path": force, "mean_force": 4e3})
    assert flanks.dynamic_load(geometry, *made, response).values == pytest.approx([0.375, 0.25, 1.0])


def test_the_spectrum_is_summed_over_cells_whose_edges_meet(states):
    geometry = states("without")["geometry"]
    nodes, phase, weight = mesh_force.cells(geometry)
    assert geometry["path_phase"].values[nodes] == pytest.approx(phase, abs=1e-12)
    assert weight.sum() == pytest.approx(1)
    assert phase[2:-1:3] == pytest.approx(phase[3::3])
    assert (phase[0], phase[-1]) == pytest.approx((0, 1), abs=1e-12)
