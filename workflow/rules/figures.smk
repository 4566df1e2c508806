"""Figures: a row each, and one rule made of every row."""

from typing import Any, NamedTuple

from gearwear.config.rules import DRAWN_PORTRAITS

DIAGRAMS = {"mesh_frequency": 12, "ste": 15, "backlash": 17}


def figures():
    """The figures of the paper, numbers 6 to 18; of given oscillators its diagrams alone."""
    numbers = range(6, 19)
    if config["oscillators"]:
        numbers = [number for sweep, number in DIAGRAMS.items() if swept_in(sweep)]
    return [f"results/figures/fig{number:02d}.svg" for number in numbers]


def extra_figures():
    """The figures that the paper does not have."""
    of_pair = ["wear_history", "contact_temperature", "load_sharing", "mesh_force"]
    names = ["exponents"] if config["oscillators"] else [*of_pair, "exponents"]
    return [f"results/figures/{name}.svg" for name in names]


def portrait_figures():
    """The phase portraits that the figures of the paper do not show."""
    return [
        f"results/figures/portraits_{case}_{sweep}.svg"
        for case, sweep in listed(config["portraits"], DRAWN_PORTRAITS)
    ]


def basin_figures():
    """The basins of every case and sweep that the configuration lists values for."""
    return [
        f"results/figures/basins_{case}_{sweep}.svg"
        for case, sweep in listed(config["basins"]["points"])
    ]


def diagonal(pattern):
    """The files of `pattern` for the states of figures 6 to 11, in their order."""
    return [
        pattern.format(case=case, q=last(case))
        for case in config["figures"]["diagonal"]
    ]


def worn_states():
    """The cases that wear, those of figures 6 to 11 first, each with its place in the order of colours."""
    names = dict.fromkeys([*config["figures"]["diagonal"], *config["cases"]])
    placed = [{"place": place, **drawn_state(case)} for place, case in enumerate(names)]
    return [state for state in placed if state["cycle"]] or placed


class Figure(NamedTuple):
    """Name, also of its caption; draw function; input files by name; settings; category and label in the report.

    Without `file`, below results and without suffix, it is figures/NAME.
    """

    name: str
    draw: str
    inputs: dict[str, Any]
    cfg: Any
    category: str
    label: str
    file: str = ""


def of_states(*stages):
    """The geometry and files of the states of figures 6 to 11, by the names of their stages."""
    files = {"geometry": "results/geometry.nc"}
    for stage in stages:
        once = stage in ("temperature", "deformation")
        name = f"{stage}.nc" if once else f"{stage}/q{{q}}.nc"
        files[stage] = diagonal(f"results/{{case}}/{name}")
    return files


def of_history(*stages):
    """The geometry and files of every wear cycle of the cases that wear, by the names of their stages."""
    cycles = [
        (one["case"], q) for one in worn_states() for q in range(one["cycle"] + 1)
    ]
    files = {
        stage: [f"results/{case}/{stage}/q{q:03d}.nc" for case, q in cycles]
        for stage in stages
    }
    return {"geometry": "results/geometry.nc", **files}


def of_sweep(sweep):
    """All that a diagram of a sweep shows; branches of periodic orbits has model torsional alone."""
    cases = swept_in(sweep)
    files = {
        order: [f"results/{case}/sweeps/{order}/{sweep}.nc" for case in cases]
        for order in ("restart", "up", "down")
    }
    followed = cases if config["dynamics"]["model"] == "torsional" else []
    files["branches"] = [f"results/{case}/branches/{sweep}.nc" for case in followed]
    return {**files, "claims": [CLAIMS] if scorecard() else []}


def sweep_cfg(sweep, case=""):
    """What a figure says of a sweep, and of one case or all that it has."""
    if case:
        states = {"state": drawn_state(case)}
    else:
        states = {
            "order": config["sweeps"]["order"],
            "states": [drawn_state(case) for case in swept_in(sweep)],
        }
    return {"sweep": sweep, "swept": swept(sweep), **states}


def drawn_case(wildcards):
    """What a figure of one case and sweep says of both."""
    return sweep_cfg(wildcards.sweep, wildcards.case)


def map_state(wildcards):
    """What the figure of a map says of it."""
    return {"map": wildcards.map, "state": drawn_state(config["maps"]["case"])}


def study_axes(wildcards):
    """What the figure of a study says of its axes."""
    return {
        "axes": list(config["studies"][wildcards.study]["grid"]) or ["member"],
        "units": units_of(wildcards.study),
        "order": config["sweeps"]["order"],
    }

# fmt: off
STATES = {"states": drawn_states()}
FIGURES = [
    Figure("fig06", "flanks:draw_wear", of_states("wear"), STATES, "Flanks", "Fig. 06: wear depth"),
    Figure("fig07", "flanks:draw_growth", of_states("deformation"), STATES, "Flanks", "Fig. 07: thermal growth"),
    Figure("fig08", "excitations:draw_stiffness", of_states("mesh_stiffness", "transmission_error"), STATES,
           "Excitations", "Fig. 08: mesh stiffness"),
    Figure("fig09", "excitations:draw_transmission_error", of_states("transmission_error"), STATES,
           "Excitations", "Fig. 09: transmission error"),
    Figure("fig10", "excitations:draw_lengths", of_states("deformation", "transmission_error", "wear"), STATES,
           "Excitations", "Fig. 10: growth, deflection and wear"),
    Figure("fig11", "excitations:draw_backlash", of_states("backlash"), STATES, "Excitations", "Fig. 11: backlash"),
    *(Figure(f"fig{number}", "bifurcation:draw", of_sweep(sweep), sweep_cfg(sweep), "Dynamics",
             f"Fig. {number}: diagram over the {quantity}")
      for number, sweep, quantity in ((12, "mesh_frequency", "mesh frequency"), (15, "ste", "transmission error"),
                                      (17, "backlash", "backlash"))),
    *(Figure(f"fig{number}", "portraits:draw", {"portraits": f"results/{case}/portraits/{sweep}.nc"},
             sweep_cfg(sweep, case), "Dynamics", f"Fig. {number}: portraits over the {quantity}")
      for number, case, sweep, quantity in ((13, "without", "mesh_frequency", "mesh frequency, cold"),
                                            (14, "with", "mesh_frequency", "mesh frequency, hot and worn"),
                                            (16, "with", "ste", "transmission error"),
                                            (18, "with", "backlash", "backlash"))),
    Figure("portraits", "portraits:draw", {"portraits": "results/{case}/portraits/{sweep}.nc"}, drawn_case,
           "Dynamics", "portraits of {case} over {sweep}", "figures/portraits_{case}_{sweep}"),
    Figure("basins", "basin_panels:draw", {"basins": "results/{case}/basins/{sweep}.nc"}, drawn_case,
           "Dynamics", "basins of {case} over {sweep}", "figures/basins_{case}_{sweep}"),
    Figure("wear_history", "history:draw", of_history("wear", "transmission_error"), {"states": worn_states()},
           "Flanks", "wear history"),
    Figure("contact_temperature", "flanks:draw_contact_temperature", of_states("temperature"), STATES,
           "Flanks", "contact temperature"),
    Figure("load_sharing", "flanks:draw_load_sharing",
           of_states("mesh_stiffness", "transmission_error", "response"), STATES, "Flanks", "load sharing"),
    Figure("mesh_force", "mesh_force:draw", of_states("response"), STATES, "Dynamics", "mesh force"),
    Figure("exponents", "exponents:draw", {"sweeps": main_sweeps()},
           {"panels": [sweep_cfg(sweep, case) for case, sweep in swept_cases()]}, "Dynamics", "exponents"),
    Figure("map", "maps:draw", {"parameter_map": f"results/{config['maps']['case']}/maps/{{map}}.nc"}, map_state,
           "Dynamics", "map {map}", "figures/map_{map}"),
    Figure("onsets", "onset_shifts:draw", {"shifts": "results/onset_shifts.nc"}, {}, "Dynamics", "onsets"),
    Figure("sensitivity", "tornado:draw", {"measures": "results/sensitivity.nc"}, {}, "Trust", "sensitivity"),
    Figure("study", "study_panels:draw", {"study": "results/studies/{study}/study.nc"}, study_axes,
           "Studies", "study {study}", "figures/study_{study}"),
    Figure("calibration", "trade_off:draw", {"calibration": "results/calibration/calibration.nc"}, {},
           "Calibration", "trade-off"),
    Figure("checks", "validation_group:draw",
           {"checks": own("config", "validation.yaml"), "found": "results/validation/{group}.csv"}, {},
           "Validation", "{group}", "validation/{group}"),
]
# fmt: on
DRAWN = digest.digests({f"figures.{one.draw}" for one in FIGURES}, MEMORY / "figures")

for figure in FIGURES:
    file = figure.file or f"figures/{figure.name}"
    job = f"plot_{file.removeprefix('figures/')}"

    rule:
        name:
            f"plot_{figure.name}"
        input:
            **figure.inputs,
            style=STYLE,
        output:
            svg=report(
                f"results/{file}.svg",
                caption=caption(figure.name),
                category=figure.category,
                labels={"figure": figure.label},
            ),
            png=f"results/{file}.png",
        log:
            f"results/logs/{job}.log",
        benchmark:
            f"results/benchmarks/{job}.tsv"
        # the first figures need no wear: they come before its chain
        priority: 20 if set(figure.inputs) <= {"geometry", "temperature", "deformation"} else 0
        params:
            cfg=figure.cfg,
            draw=figure.draw,
            code=DRAWN[f"figures.{figure.draw}"],
        message:
            "Drawing {output.svg}."
        script:
            "../scripts/figure.py"
