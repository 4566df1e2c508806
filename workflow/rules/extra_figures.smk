def extra_figures():
    """The figures that the paper does not have."""
    of_pair = ["wear_history", "contact_temperature", "load_sharing", "mesh_force"]
    names = ["exponents"] if config["oscillators"] else [*of_pair, "exponents"]
    return [f"results/figures/{name}.svg" for name in names]


def worn_states():
    """The cases that wear, those of figures 6 to 11 first, each with its place in the order of colours."""
    names = dict.fromkeys([*config["figures"]["diagonal"], *config["cases"]])
    placed = [{"place": place, **drawn_state(case)} for place, case in enumerate(names)]
    return [state for state in placed if state["cycle"]] or placed


def history(stage):
    """The files of a stage at every wear cycle of the cases that wear."""
    return [
        f"results/{state['case']}/{stage}/q{q:03d}.nc"
        for state in worn_states()
        for q in range(state["cycle"] + 1)
    ]


rule plot_wear_history:
    input:
        geometry="results/geometry.nc",
        wear=history("wear"),
        mesh_stiffness=history("mesh_stiffness"),
        transmission_error=history("transmission_error"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/wear_history.svg",
            caption=caption("wear_history"),
            category="Flanks",
            labels={"figure": "wear history"},
        ),
        png="results/figures/wear_history.png",
    log:
        "results/logs/plot_wear_history.log",
    benchmark:
        "results/benchmarks/plot_wear_history.tsv"
    params:
        cfg={"states": worn_states()},
        code=code("plot_wear_history.py"),
    message:
        "Wear, transmission error and stiffness over the revolutions."
    script:
        "../scripts/plot_wear_history.py"


rule plot_contact_temperature:
    input:
        geometry="results/geometry.nc",
        temperature=diagonal("results/{case}/temperature.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/contact_temperature.svg",
            caption=caption("contact_temperature"),
            category="Flanks",
            labels={"figure": "contact temperature"},
        ),
        png="results/figures/contact_temperature.png",
    log:
        "results/logs/plot_contact_temperature.log",
    benchmark:
        "results/benchmarks/plot_contact_temperature.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_contact_temperature.py"),
    message:
        "Contact temperature and friction along the path of contact."
    script:
        "../scripts/plot_contact_temperature.py"


rule plot_load_sharing:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=diagonal("results/{case}/mesh_stiffness/q{q}.nc"),
        transmission_error=diagonal("results/{case}/transmission_error/q{q}.nc"),
        response=diagonal("results/{case}/response/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/load_sharing.svg",
            caption=caption("load_sharing"),
            category="Flanks",
            labels={"figure": "load sharing"},
        ),
        png="results/figures/load_sharing.png",
    log:
        "results/logs/plot_load_sharing.log",
    benchmark:
        "results/benchmarks/plot_load_sharing.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_load_sharing.py"),
    message:
        "Load of one pair along the path of contact."
    script:
        "../scripts/plot_load_sharing.py"


rule plot_mesh_force:
    input:
        geometry="results/geometry.nc",
        response=diagonal("results/{case}/response/q{q}.nc"),
        style=STYLE,
    output:
        svg=report(
            "results/figures/mesh_force.svg",
            caption=caption("mesh_force"),
            category="Dynamics",
            labels={"figure": "mesh force"},
        ),
        png="results/figures/mesh_force.png",
    log:
        "results/logs/plot_mesh_force.log",
    benchmark:
        "results/benchmarks/plot_mesh_force.tsv"
    params:
        cfg={"states": drawn_states()},
        code=code("plot_mesh_force.py"),
    message:
        "Dynamic mesh force and its spectrum."
    script:
        "../scripts/plot_mesh_force.py"


rule plot_exponents:
    input:
        sweeps=main_sweeps(),
        style=STYLE,
    output:
        svg=report(
            "results/figures/exponents.svg",
            caption=caption("exponents"),
            category="Dynamics",
            labels={"figure": "exponents"},
        ),
        png="results/figures/exponents.png",
    log:
        "results/logs/plot_exponents.log",
    benchmark:
        "results/benchmarks/plot_exponents.tsv"
    params:
        cfg={
            "panels": [
                {"sweep": sweep, "swept": swept(sweep), "state": drawn_state(case)}
                for case, sweep in swept_cases()
            ]
        },
        code=code("plot_exponents.py"),
    message:
        "Sections of all sweeps, coloured by the largest Lyapunov exponent."
    script:
        "../scripts/plot_exponents.py"
