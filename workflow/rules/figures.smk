from gearwear.config.rules import DRAWN_PORTRAITS

DIAGRAMS = {"mesh_frequency": 12, "ste": 15, "backlash": 17}


def figures():
    """The figures of the paper, numbers 6 to 18; of given oscillators its diagrams alone."""
    numbers = range(6, 19)
    if config["oscillators"]:
        numbers = [number for sweep, number in DIAGRAMS.items() if swept_in(sweep)]
    return [f"results/figures/fig{number:02d}.svg" for number in numbers]


def portrait_figures():
    """The phase portraits that the figures of the paper do not show."""
    return [
        f"results/figures/portraits_{case}_{sweep}.svg"
        for case, sweep in listed(config["portraits"], DRAWN_PORTRAITS)
    ]


def followed(sweep):
    """The branches of periodic orbits along a sweep, which model torsional alone has."""
    if config["dynamics"]["model"] != "torsional":
        return []
    return [f"results/{case}/branches/{sweep}.nc" for case in swept_in(sweep)]


def basin_figures():
    """The basins of every case and sweep that the configuration lists values for."""
    return [
        f"results/figures/basins_{case}_{sweep}.svg"
        for case, sweep in listed(config["basins"]["points"])
    ]


def paper_windows():
    """The file that names the windows of motion of the paper, where they are drawn."""
    return [CLAIMS] if scorecard() else []


def diagonal(pattern):
    """The files of `pattern` for the states of figures 6 to 11, in their order."""
    return [
        pattern.format(case=case, q=last(case))
        for case in config["figures"]["diagonal"]
    ]


def drawn_case(wildcards):
    """What a figure of one case and sweep says of both."""
    return {
        "sweep": wildcards.sweep,
        "swept": swept(wildcards.sweep),
        "state": drawn_state(wildcards.case),
    }


rule plot_wear:
    input:
        geometry="results/geometry.nc",
        wear=diagonal("results/{case}/wear/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig06.svg",
            caption=caption("fig06"),
            category="Flanks",
            labels={"figure": "Fig. 06: wear depth"},
        ),
        png="results/figures/fig06.png",
    log:
        "results/logs/plot_wear.log",
    benchmark:
        "results/benchmarks/plot_wear.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_wear.py"),
    message:
        "Figure 6: wear depth of both flanks."
    script:
        "../scripts/plot_wear.py"


rule plot_growth:
    input:
        geometry="results/geometry.nc",
        deformation=diagonal("results/{case}/deformation.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig07.svg",
            caption=caption("fig07"),
            category="Flanks",
            labels={"figure": "Fig. 07: thermal growth"},
        ),
        png="results/figures/fig07.png",
    log:
        "results/logs/plot_growth.log",
    benchmark:
        "results/benchmarks/plot_growth.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_growth.py"),
    message:
        "Figure 7: thermal growth of both flanks."
    script:
        "../scripts/plot_growth.py"


rule plot_stiffness:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=diagonal("results/{case}/mesh_stiffness/q{q}.nc"),
        transmission_error=diagonal("results/{case}/transmission_error/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig08.svg",
            caption=caption("fig08"),
            category="Excitations",
            labels={"figure": "Fig. 08: mesh stiffness"},
        ),
        png="results/figures/fig08.png",
    log:
        "results/logs/plot_stiffness.log",
    benchmark:
        "results/benchmarks/plot_stiffness.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_stiffness.py"),
    message:
        "Figure 8: mesh stiffness."
    script:
        "../scripts/plot_stiffness.py"


rule plot_error:
    input:
        geometry="results/geometry.nc",
        transmission_error=diagonal("results/{case}/transmission_error/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig09.svg",
            caption=caption("fig09"),
            category="Excitations",
            labels={"figure": "Fig. 09: transmission error"},
        ),
        png="results/figures/fig09.png",
    log:
        "results/logs/plot_error.log",
    benchmark:
        "results/benchmarks/plot_error.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_error.py"),
    message:
        "Figure 9: static transmission error."
    script:
        "../scripts/plot_error.py"


rule plot_growth_share:
    input:
        geometry="results/geometry.nc",
        deformation=diagonal("results/{case}/deformation.nc"),
        transmission_error=diagonal("results/{case}/transmission_error/q{q}.nc"),
        wear=diagonal("results/{case}/wear/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig10.svg",
            caption=caption("fig10"),
            category="Excitations",
            labels={"figure": "Fig. 10: growth, deflection and wear"},
        ),
        png="results/figures/fig10.png",
    log:
        "results/logs/plot_growth_share.log",
    benchmark:
        "results/benchmarks/plot_growth_share.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_growth_share.py"),
    message:
        "Figure 10: thermal growth, deflection and wear compared."
    script:
        "../scripts/plot_growth_share.py"


rule plot_backlash:
    input:
        geometry="results/geometry.nc",
        backlash=diagonal("results/{case}/backlash/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig11.svg",
            caption=caption("fig11"),
            category="Excitations",
            labels={"figure": "Fig. 11: backlash"},
        ),
        png="results/figures/fig11.png",
    log:
        "results/logs/plot_backlash.log",
    benchmark:
        "results/benchmarks/plot_backlash.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_backlash.py"),
    message:
        "Figure 11: half backlash."
    script:
        "../scripts/plot_backlash.py"


rule plot_frequency_sweep:
    input:
        restart=[
            f"results/{case}/sweeps/restart/mesh_frequency.nc"
            for case in swept_in("mesh_frequency")
        ],
        up=[
            f"results/{case}/sweeps/up/mesh_frequency.nc"
            for case in swept_in("mesh_frequency")
        ],
        down=[
            f"results/{case}/sweeps/down/mesh_frequency.nc"
            for case in swept_in("mesh_frequency")
        ],
        branches=followed("mesh_frequency"),
        claims=paper_windows(),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig12.svg",
            caption=caption("fig12"),
            category="Dynamics",
            labels={"figure": "Fig. 12: diagram over the mesh frequency"},
        ),
        png="results/figures/fig12.png",
    log:
        "results/logs/plot_frequency_sweep.log",
    benchmark:
        "results/benchmarks/plot_frequency_sweep.tsv"
    params:
        cfg={
            "sweep": "mesh_frequency",
            "order": config["sweeps"]["order"],
            "swept": swept("mesh_frequency"),
            "states": [drawn_state(case) for case in swept_in("mesh_frequency")],
        },
        code=code("plot_bifurcation.py"),
    message:
        "Figure 12: bifurcations over the mesh frequency."
    script:
        "../scripts/plot_bifurcation.py"


rule plot_portraits_cold:
    input:
        portraits="results/without/portraits/mesh_frequency.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig13.svg",
            caption=caption("fig13"),
            category="Dynamics",
            labels={"figure": "Fig. 13: portraits over the mesh frequency, cold"},
        ),
        png="results/figures/fig13.png",
    log:
        "results/logs/plot_portraits_cold.log",
    benchmark:
        "results/benchmarks/plot_portraits_cold.tsv"
    params:
        cfg={
            "sweep": "mesh_frequency",
            "swept": swept("mesh_frequency"),
            "state": drawn_state("without"),
        },
        code=code("plot_portraits.py"),
    message:
        "Figure 13: phase portraits over the mesh frequency, cold and unworn."
    script:
        "../scripts/plot_portraits.py"


rule plot_portraits_hot:
    input:
        portraits="results/with/portraits/mesh_frequency.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig14.svg",
            caption=caption("fig14"),
            category="Dynamics",
            labels={
                "figure": "Fig. 14: portraits over the mesh frequency, hot and worn"
            },
        ),
        png="results/figures/fig14.png",
    log:
        "results/logs/plot_portraits_hot.log",
    benchmark:
        "results/benchmarks/plot_portraits_hot.tsv"
    params:
        cfg={
            "sweep": "mesh_frequency",
            "swept": swept("mesh_frequency"),
            "state": drawn_state("with"),
        },
        code=code("plot_portraits.py"),
    message:
        "Figure 14: phase portraits over the mesh frequency, hot and worn."
    script:
        "../scripts/plot_portraits.py"


rule plot_ste_sweep:
    input:
        restart=[f"results/{case}/sweeps/restart/ste.nc" for case in swept_in("ste")],
        up=[f"results/{case}/sweeps/up/ste.nc" for case in swept_in("ste")],
        down=[f"results/{case}/sweeps/down/ste.nc" for case in swept_in("ste")],
        branches=followed("ste"),
        claims=paper_windows(),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig15.svg",
            caption=caption("fig15"),
            category="Dynamics",
            labels={"figure": "Fig. 15: diagram over the transmission error"},
        ),
        png="results/figures/fig15.png",
    log:
        "results/logs/plot_ste_sweep.log",
    benchmark:
        "results/benchmarks/plot_ste_sweep.tsv"
    params:
        cfg={
            "sweep": "ste",
            "order": config["sweeps"]["order"],
            "swept": swept("ste"),
            "states": [drawn_state(case) for case in swept_in("ste")],
        },
        code=code("plot_bifurcation.py"),
    message:
        "Figure 15: bifurcations over the transmission error."
    script:
        "../scripts/plot_bifurcation.py"


rule plot_portraits_ste:
    input:
        portraits="results/with/portraits/ste.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig16.svg",
            caption=caption("fig16"),
            category="Dynamics",
            labels={"figure": "Fig. 16: portraits over the transmission error"},
        ),
        png="results/figures/fig16.png",
    log:
        "results/logs/plot_portraits_ste.log",
    benchmark:
        "results/benchmarks/plot_portraits_ste.tsv"
    params:
        cfg={"sweep": "ste", "swept": swept("ste"), "state": drawn_state("with")},
        code=code("plot_portraits.py"),
    message:
        "Figure 16: phase portraits over the transmission error."
    script:
        "../scripts/plot_portraits.py"


rule plot_backlash_sweep:
    input:
        restart=[
            f"results/{case}/sweeps/restart/backlash.nc"
            for case in swept_in("backlash")
        ],
        up=[f"results/{case}/sweeps/up/backlash.nc" for case in swept_in("backlash")],
        down=[
            f"results/{case}/sweeps/down/backlash.nc" for case in swept_in("backlash")
        ],
        branches=followed("backlash"),
        claims=paper_windows(),
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig17.svg",
            caption=caption("fig17"),
            category="Dynamics",
            labels={"figure": "Fig. 17: diagram over the backlash"},
        ),
        png="results/figures/fig17.png",
    log:
        "results/logs/plot_backlash_sweep.log",
    benchmark:
        "results/benchmarks/plot_backlash_sweep.tsv"
    params:
        cfg={
            "sweep": "backlash",
            "order": config["sweeps"]["order"],
            "swept": swept("backlash"),
            "states": [drawn_state(case) for case in swept_in("backlash")],
        },
        code=code("plot_bifurcation.py"),
    message:
        "Figure 17: bifurcations over the backlash."
    script:
        "../scripts/plot_bifurcation.py"


rule plot_portraits_backlash:
    input:
        portraits="results/with/portraits/backlash.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/fig18.svg",
            caption=caption("fig18"),
            category="Dynamics",
            labels={"figure": "Fig. 18: portraits over the backlash"},
        ),
        png="results/figures/fig18.png",
    log:
        "results/logs/plot_portraits_backlash.log",
    benchmark:
        "results/benchmarks/plot_portraits_backlash.tsv"
    params:
        cfg={
            "sweep": "backlash",
            "swept": swept("backlash"),
            "state": drawn_state("with"),
        },
        code=code("plot_portraits.py"),
    message:
        "Figure 18: phase portraits over the backlash."
    script:
        "../scripts/plot_portraits.py"


rule plot_portraits:
    input:
        portraits="results/{case}/portraits/{sweep}.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/portraits_{case}_{sweep}.svg",
            caption=caption("portraits"),
            category="Dynamics",
            labels={"figure": "portraits of {case} over {sweep}"},
        ),
        png="results/figures/portraits_{case}_{sweep}.png",
    log:
        "results/logs/plot_portraits/{case}_{sweep}.log",
    benchmark:
        "results/benchmarks/plot_portraits/{case}_{sweep}.tsv"
    params:
        cfg=drawn_case,
        code=code("plot_portraits.py"),
    message:
        "Phase portraits, case {wildcards.case}, over {wildcards.sweep}."
    script:
        "../scripts/plot_portraits.py"


rule plot_basins:
    input:
        basins="results/{case}/basins/{sweep}.nc",
        style=STYLE,
    output:
        svg=report(
            "results/figures/basins_{case}_{sweep}.svg",
            caption=caption("basins"),
            category="Dynamics",
            labels={"figure": "basins of {case} over {sweep}"},
        ),
        png="results/figures/basins_{case}_{sweep}.png",
    log:
        "results/logs/plot_basins/{case}_{sweep}.log",
    benchmark:
        "results/benchmarks/plot_basins/{case}_{sweep}.tsv"
    params:
        cfg=drawn_case,
        code=code("plot_basins.py"),
    message:
        "Basins of attraction, case {wildcards.case}, over {wildcards.sweep}."
    script:
        "../scripts/plot_basins.py"
