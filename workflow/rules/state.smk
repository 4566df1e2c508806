rule build_geometry:
    output:
        "results/geometry.nc",
    log:
        "results/logs/build_geometry.log",
    benchmark:
        "results/benchmarks/build_geometry.tsv"
    params:
        cfg=cfg("geometry"),
        code=code("build_geometry.py"),
    message:
        "Building the gear pair and its path of contact."
    script:
        "../scripts/build_geometry.py"


rule heat_contact:
    input:
        geometry="results/geometry.nc",
    output:
        "results/{case}/temperature.nc",
    log:
        "results/logs/{case}/heat_contact.log",
    benchmark:
        "results/benchmarks/{case}/heat_contact.tsv"
    params:
        cfg=cfg("temperature"),
        code=code("heat_contact.py"),
    message:
        "Case {wildcards.case}: heating the tooth contact."
    script:
        "../scripts/heat_contact.py"


rule grow_flanks:
    input:
        geometry="results/geometry.nc",
        temperature="results/{case}/temperature.nc",
    output:
        "results/{case}/deformation.nc",
    log:
        "results/logs/{case}/grow_flanks.log",
    benchmark:
        "results/benchmarks/{case}/grow_flanks.tsv"
    params:
        cfg=cfg("deformation"),
        code=code("grow_flanks.py"),
    message:
        "Case {wildcards.case}: growing the flanks by heat."
    script:
        "../scripts/grow_flanks.py"


rule start_wear:
    input:
        geometry="results/geometry.nc",
    output:
        "results/{case}/wear/q{q}.nc",
    log:
        "results/logs/{case}/start_wear/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/start_wear/q{q}.tsv"
    wildcard_constraints:
        q="000",
    params:
        cfg=cfg("start_wear"),
        code=code("start_wear.py"),
    message:
        "Case {wildcards.case}: starting from pristine flanks."
    script:
        "../scripts/start_wear.py"


rule advance_wear:
    input:
        geometry="results/geometry.nc",
        wear=earlier("results/{case}/wear/q{q}.nc"),
        mesh_stiffness=earlier("results/{case}/mesh_stiffness/q{q}.nc"),
        transmission_error=earlier("results/{case}/transmission_error/q{q}.nc"),
        response=earlier("results/{case}/response/q{q}.nc"),
    output:
        "results/{case}/wear/q{q}.nc",
    log:
        "results/logs/{case}/advance_wear/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/advance_wear/q{q}.tsv"
    wildcard_constraints:
        q=r"(?!000)\d{3}",
    priority: 10
    params:
        cfg=cfg("advance_wear"),
        code=code("advance_wear.py"),
    message:
        "Case {wildcards.case}, cycle {wildcards.q}: wearing the flanks under the mesh force of the cycle before."
    script:
        "../scripts/advance_wear.py"


rule build_stiffness:
    input:
        geometry="results/geometry.nc",
        deformation="results/{case}/deformation.nc",
        wear="results/{case}/wear/q{q}.nc",
    output:
        "results/{case}/mesh_stiffness/q{q}.nc",
    log:
        "results/logs/{case}/build_stiffness/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/build_stiffness/q{q}.tsv"
    priority: 10
    params:
        cfg=cfg("mesh_stiffness"),
        code=code("build_stiffness.py"),
    message:
        "Case {wildcards.case}, cycle {wildcards.q}: computing the mesh stiffness."
    script:
        "../scripts/build_stiffness.py"


rule share_load:
    input:
        geometry="results/geometry.nc",
        deformation="results/{case}/deformation.nc",
        wear="results/{case}/wear/q{q}.nc",
        mesh_stiffness="results/{case}/mesh_stiffness/q{q}.nc",
    output:
        "results/{case}/transmission_error/q{q}.nc",
    log:
        "results/logs/{case}/share_load/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/share_load/q{q}.tsv"
    priority: 10
    params:
        cfg=cfg("transmission_error"),
        code=code("share_load.py"),
    message:
        "Case {wildcards.case}, cycle {wildcards.q}: sharing the load and finding the transmission error."
    script:
        "../scripts/share_load.py"


rule open_backlash:
    input:
        geometry="results/geometry.nc",
        deformation="results/{case}/deformation.nc",
        wear="results/{case}/wear/q{q}.nc",
        transmission_error="results/{case}/transmission_error/q{q}.nc",
    output:
        "results/{case}/backlash/q{q}.nc",
    log:
        "results/logs/{case}/open_backlash/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/open_backlash/q{q}.tsv"
    priority: 10
    params:
        cfg=cfg("backlash"),
        code=code("open_backlash.py"),
    message:
        "Case {wildcards.case}, cycle {wildcards.q}: opening the backlash."
    script:
        "../scripts/open_backlash.py"


rule solve_response:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness="results/{case}/mesh_stiffness/q{q}.nc",
        transmission_error="results/{case}/transmission_error/q{q}.nc",
        backlash="results/{case}/backlash/q{q}.nc",
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{case}/response/q{q}.nc",
    log:
        "results/logs/{case}/solve_response/q{q}.log",
    benchmark:
        "results/benchmarks/{case}/solve_response/q{q}.tsv"
    priority: 10
    params:
        cfg=cfg("response"),
        code=code("solve_response.py"),
    message:
        "Case {wildcards.case}, cycle {wildcards.q}: solving the dynamic response at the running speed."
    script:
        "../scripts/solve_response.py"
