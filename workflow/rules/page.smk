rule trace_motions:
    input:
        excitation="results/{root}{case}/excitation.nc",
        sweep="results/{root}{case}/sweeps/{order}/{sweep}.nc",
    output:
        "results/{root}{case}/motions/{order}/{sweep}.nc",
    log:
        "results/logs/{root}{case}/trace_motions/{order}/{sweep}.log",
    benchmark:
        "results/benchmarks/{root}{case}/trace_motions/{order}/{sweep}.tsv"
    wildcard_constraints:
        order="restart|up|down",
    params:
        cfg=cfg("motions"),
        code=code("trace_motions.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: tracing the motion at every point of {wildcards.sweep}."
    script:
        "../scripts/trace_motions.py"


rule show_page:
    input:
        geometry=[] if config["oscillators"] else "results/geometry.nc",
        sweeps=main_sweeps(),
        motions=main_sweeps("motions"),
        template=own("workflow", "report", "page.html.j2"),
        program=own("workflow", "report", "page.js"),
    output:
        report(
            "results/page.html",
            caption=caption("page"),
            category="Dynamics",
            labels={"figure": "interactive page"},
        ),
    log:
        "results/logs/show_page.log",
    benchmark:
        "results/benchmarks/show_page.tsv"
    params:
        cfg={
            "panels": [
                {"sweep": sweep, "swept": swept(sweep), "state": drawn_state(case)}
                for case, sweep in swept_cases()
            ]
        },
        code=code("show_page.py"),
    message:
        "Writing the interactive page of the motions."
    script:
        "../scripts/show_page.py"
