"""What a wear cycle consists of, by name: planning reads this without the numerics."""

# The stages of a wear cycle in their order, and the results that each makes.
CYCLE: dict[str, tuple[str, ...]] = {
    "wear": ("wear",),
    "mesh_excitation": ("mesh_stiffness", "transmission_error", "backlash"),
    "response": ("response",),
}
