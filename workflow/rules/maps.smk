"""Maps of the motion over the mesh frequency and a second parameter or a state of the pair."""

POINTS_OF_A_TILE = 5000  # twenty seconds of one processor


def mapped():
    """The figures of the maps."""
    return expand(
        "results/figures/map_{map}.svg", map=("ste", "backlash", "temperature", "wear")
    )


def map_cfg(wildcards):
    """The settings a map sees."""
    return cfg(
        "temperature_map_tile"
        if wildcards.map == "temperature"
        else f"map_{wildcards.map}"
    )(wildcards)


def tiles(wildcards):
    """The tiles of a map: as many as scattergather says, more where each would have too many points."""
    name, settings = wildcards.map, config["maps"]
    rows = {
        "temperature": len(settings["temperature"]),
        "wear": updates_of(config, wildcards.case) + 1,
    }.get(name) or settings[name]["points"]
    wanted = -(-rows * settings["mesh_frequency"]["points"] // POINTS_OF_A_TILE)
    parts = max(len(gather.map("{scatteritem}")), min(rows, wanted))
    folder = f"results/{wildcards.case}/maps/tiles/{name}"
    return [f"{folder}/{part}-of-{parts}.nc" for part in range(1, parts + 1)]


def rows_of(stage):
    """Input function: the files of a stage behind the rows of a tile, or the one file that all rows share."""

    def files(wildcards):
        case = wildcards.case
        if wildcards.map in ("ste", "backlash"):
            return f"results/{case}/{stage}/q{last(case)}.nc"
        part, parts = (int(word) for word in wildcards.scatteritem.split("-of-"))
        cycles = range(int(last(case)) + 1)[part - 1 :: parts]
        return [f"results/{case}/{stage}/q{q:03d}.nc" for q in cycles]

    return files


def temperature_histories(wildcards):
    """The wear histories behind the rows of a tile of the map over the bulk temperature."""
    part, parts = (int(word) for word in wildcards.scatteritem.split("-of-"))
    roots = map(temperature_root, config["maps"]["temperature"][part - 1 :: parts])
    return [history_file(MEMBERS[root], wildcards.case) for root in roots]


rule map_tile:
    input:
        geometry="results/geometry.nc",
        mesh_stiffness=rows_of("mesh_stiffness"),
        transmission_error=rows_of("transmission_error"),
        backlash=rows_of("backlash"),
        wear=lambda wildcards: (
            rows_of("wear")(wildcards) if wildcards.map == "wear" else []
        ),
        reference_stiffness=reference("mesh_stiffness"),
        reference_error=reference("transmission_error"),
    output:
        "results/{case}/maps/tiles/{map}/{scatteritem}.nc",
    log:
        "results/logs/{case}/map_tile/{map}/{scatteritem}.log",
    benchmark:
        "results/benchmarks/{case}/map_tile/{map}/{scatteritem}.tsv"
    wildcard_constraints:
        map="ste|backlash|wear",
    params:
        cfg=map_cfg,
        code=code("map_tile"),
    message:
        "Case {wildcards.case}: mapping mesh frequency and {wildcards.map}, tile {wildcards.scatteritem}."
    script:
        "../scripts/stage.py"


rule temperature_map_tile:
    input:
        histories=temperature_histories,
    output:
        "results/{case}/maps/tiles/temperature/{scatteritem}.nc",
    log:
        "results/logs/{case}/map_tile/temperature/{scatteritem}.log",
    benchmark:
        "results/benchmarks/{case}/map_tile/temperature/{scatteritem}.tsv"
    params:
        cfg=lambda wildcards: {
            "map": cfg("temperature_map_tile")(wildcards),
            "updates": updates_of(config, wildcards.case),
        },
        code=code("temperature_map_tile"),
    message:
        "Case {wildcards.case}: mapping mesh frequency and bulk temperature, tile {wildcards.scatteritem}."
    script:
        "../scripts/stage.py"


rule map:
    input:
        tiles=tiles,
    output:
        "results/{case}/maps/{map}.nc",
    log:
        "results/logs/{case}/map/{map}.log",
    benchmark:
        "results/benchmarks/{case}/map/{map}.tsv"
    params:
        cfg=map_cfg,
        code=code("map"),
    message:
        "Case {wildcards.case}: joining the tiles of the map over {wildcards.map}."
    script:
        "../scripts/stage.py"
