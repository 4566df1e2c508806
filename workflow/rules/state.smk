rule build_geometry:
    output:
        "results/{root}geometry.nc",
    log:
        "results/logs/{root}build_geometry.log",
    benchmark:
        "results/benchmarks/{root}build_geometry.tsv"
    params:
        cfg=cfg("geometry"),
        code=code("build_geometry.py"),
    message:
        "Building the gear pair and its path of contact: results/{wildcards.root}geometry.nc."
    script:
        "../scripts/build_geometry.py"


rule heat_contact:
    input:
        geometry="results/{root}geometry.nc",
    output:
        "results/{root}{case}/temperature.nc",
    log:
        "results/logs/{root}{case}/heat_contact.log",
    benchmark:
        "results/benchmarks/{root}{case}/heat_contact.tsv"
    params:
        cfg=cfg("temperature"),
        code=code("heat_contact.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: heating the tooth contact."
    script:
        "../scripts/heat_contact.py"


rule grow_flanks:
    input:
        geometry="results/{root}geometry.nc",
        temperature="results/{root}{case}/temperature.nc",
    output:
        "results/{root}{case}/deformation.nc",
    log:
        "results/logs/{root}{case}/grow_flanks.log",
    benchmark:
        "results/benchmarks/{root}{case}/grow_flanks.tsv"
    params:
        cfg=cfg("deformation"),
        code=code("grow_flanks.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: growing the flanks by heat."
    script:
        "../scripts/grow_flanks.py"


rule start_wear:
    input:
        geometry="results/{root}geometry.nc",
    output:
        "results/{root}{case}/wear/q{q}.nc",
    log:
        "results/logs/{root}{case}/start_wear/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/start_wear/q{q}.tsv"
    wildcard_constraints:
        q="000",
    params:
        cfg=cfg("start_wear"),
        code=code("start_wear.py"),
    message:
        "Case {wildcards.root}{wildcards.case}: starting from pristine flanks."
    script:
        "../scripts/start_wear.py"


rule advance_wear:
    input:
        geometry="results/{root}geometry.nc",
        wear=earlier("results/{root}{case}/wear/q{q}.nc"),
        mesh_stiffness=earlier("results/{root}{case}/mesh_stiffness/q{q}.nc"),
        transmission_error=earlier("results/{root}{case}/transmission_error/q{q}.nc"),
        response=earlier("results/{root}{case}/response/q{q}.nc"),
    output:
        "results/{root}{case}/wear/q{q}.nc",
    log:
        "results/logs/{root}{case}/advance_wear/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/advance_wear/q{q}.tsv"
    wildcard_constraints:
        root=LINKED,
        q=r"(?!000)\d{3}",
    priority: 10
    params:
        cfg=cfg("advance_wear"),
        code=code("advance_wear.py"),
    message:
        "Case {wildcards.root}{wildcards.case}, cycle {wildcards.q}: wearing the flanks under the mesh force of the cycle before."
    script:
        "../scripts/advance_wear.py"


rule build_stiffness:
    input:
        geometry="results/{root}geometry.nc",
        deformation="results/{root}{case}/deformation.nc",
        wear="results/{root}{case}/wear/q{q}.nc",
    output:
        "results/{root}{case}/mesh_stiffness/q{q}.nc",
    log:
        "results/logs/{root}{case}/build_stiffness/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/build_stiffness/q{q}.tsv"
    wildcard_constraints:
        root=LINKED,
    priority: 10
    params:
        cfg=cfg("mesh_stiffness"),
        code=code("build_stiffness.py"),
    message:
        "Case {wildcards.root}{wildcards.case}, cycle {wildcards.q}: computing the mesh stiffness."
    script:
        "../scripts/build_stiffness.py"


rule share_load:
    input:
        geometry="results/{root}geometry.nc",
        deformation="results/{root}{case}/deformation.nc",
        wear="results/{root}{case}/wear/q{q}.nc",
        mesh_stiffness="results/{root}{case}/mesh_stiffness/q{q}.nc",
    output:
        "results/{root}{case}/transmission_error/q{q}.nc",
    log:
        "results/logs/{root}{case}/share_load/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/share_load/q{q}.tsv"
    wildcard_constraints:
        root=LINKED,
    priority: 10
    params:
        cfg=cfg("transmission_error"),
        code=code("share_load.py"),
    message:
        "Case {wildcards.root}{wildcards.case}, cycle {wildcards.q}: sharing the load and finding the transmission error."
    script:
        "../scripts/share_load.py"


rule open_backlash:
    input:
        geometry="results/{root}geometry.nc",
        deformation="results/{root}{case}/deformation.nc",
        wear="results/{root}{case}/wear/q{q}.nc",
        transmission_error="results/{root}{case}/transmission_error/q{q}.nc",
    output:
        "results/{root}{case}/backlash/q{q}.nc",
    log:
        "results/logs/{root}{case}/open_backlash/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/open_backlash/q{q}.tsv"
    wildcard_constraints:
        root=LINKED,
    priority: 10
    params:
        cfg=cfg("backlash"),
        code=code("open_backlash.py"),
    message:
        "Case {wildcards.root}{wildcards.case}, cycle {wildcards.q}: opening the backlash."
    script:
        "../scripts/open_backlash.py"


rule solve_response:
    input:
        geometry="results/{root}geometry.nc",
        mesh_stiffness="results/{root}{case}/mesh_stiffness/q{q}.nc",
        transmission_error="results/{root}{case}/transmission_error/q{q}.nc",
        backlash="results/{root}{case}/backlash/q{q}.nc",
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{root}{case}/response/q{q}.nc",
    log:
        "results/logs/{root}{case}/solve_response/q{q}.log",
    benchmark:
        "results/benchmarks/{root}{case}/solve_response/q{q}.tsv"
    wildcard_constraints:
        root=LINKED,
    priority: 10
    params:
        cfg=cfg("response"),
        code=code("solve_response.py"),
    message:
        "Case {wildcards.root}{wildcards.case}, cycle {wildcards.q}: solving the dynamic response at the running speed."
    script:
        "../scripts/solve_response.py"
