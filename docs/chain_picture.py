"""Draw docs/images/chain.svg, the picture of the stages: `python docs/chain_picture.py`."""

from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

FILE = Path(__file__).parent / "images" / "chain.svg"
BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#555555"
WIDTH, HEIGHT = 1.75, 0.62

# name: centre, text, colour
BOXES = {
    "pair": ((1.0, 4.3), "pair, load, oil,\nbulk temperature", GREY),
    "geometry": ((3.3, 4.3), "geometry\npath of contact", BLUE),
    "temperature": ((5.6, 4.3), "temperature\nflash, friction", BLUE),
    "deformation": ((7.9, 4.3), "deformation\nthermal growth", BLUE),
    "mesh": ((3.3, 2.6), "mesh_excitation\nk(t), e(t), b(t)", ORANGE),
    "response": ((5.6, 2.6), "response\ndynamic mesh force", ORANGE),
    "wear": ((7.9, 2.6), "wear\nboth flanks", ORANGE),
    "excitation": ((1.0, 0.6), "excitation\nof the oscillator", GREEN),
    "sweep": ((3.3, 0.6), "sweep\nfrom rest, up, down", GREEN),
    "branches": ((5.6, 0.6), "branches, portraits,\nbasins, maps", GREEN),
    "figures": ((7.9, 0.6), "figures, onsets,\nclaims, studies", GREEN),
}
ARROWS = [
    ("pair", "geometry"),
    ("geometry", "temperature"),
    ("temperature", "deformation"),
    ("mesh", "response"),
    ("response", "wear"),
    ("excitation", "sweep"),
    ("sweep", "branches"),
    ("branches", "figures"),
]


def arrow(axes, points: list[tuple[float, float]]) -> None:
    """Draw straight lines through the points, with a head at the last."""
    for start, end in zip(points[:-2], points[1:-1], strict=True):
        axes.plot(*zip(start, end, strict=True), c="black", linewidth=1, solid_capstyle="projecting")
    axes.add_patch(FancyArrowPatch(*points[-2:], arrowstyle="-|>", mutation_scale=10, shrinkA=0, shrinkB=0, fc="black"))


def draw() -> plt.Figure:
    figure, axes = plt.subplots(figsize=(8.9, 4.9), layout="constrained")
    loop = FancyBboxPatch((2.15, 1.75), 6.9, 1.75, boxstyle="round,pad=0.05", fc="#fdf3ea", ec=ORANGE)
    axes.add_patch(loop)
    axes.text(4.4, 3.3, "every wear cycle q", c=ORANGE, fontsize=9, style="italic", va="center")
    for (x, y), text, colour in BOXES.values():
        corner = (x - WIDTH / 2, y - HEIGHT / 2)
        axes.add_patch(FancyBboxPatch(corner, WIDTH, HEIGHT, boxstyle="round,pad=0.04", fc="white", ec=colour))
        axes.text(x, y, text, ha="center", va="center", fontsize=9)
    reach = WIDTH / 2 + 0.05
    for start, end in ARROWS:
        (x0, y0), (x1, y1) = BOXES[start][0], BOXES[end][0]
        arrow(axes, [(x0 + reach, y0), (x1 - reach, y1)])
    arrow(axes, [(7.9, 3.94), (7.9, 3.66), (3.3, 3.66), (3.3, 2.96)])
    arrow(axes, [(7.9, 2.24), (7.9, 1.95), (3.3, 1.95), (3.3, 2.24)])
    arrow(axes, [(2.38, 2.6), (1.0, 2.6), (1.0, 0.96)])
    axes.text(5.6, 2.05, "q + 1", ha="center", fontsize=9)
    axes.text(1.08, 1.5, "last cycle", fontsize=9)
    axes.set(xlim=(-0.05, 9.15), ylim=(0.15, 4.75), aspect="equal")
    axes.axis("off")
    return figure


if __name__ == "__main__":
    plt.rcParams.update({"svg.hashsalt": "chain", "font.family": "DejaVu Sans"})
    picture = draw()
    picture.savefig(FILE, metadata={"Date": None}, facecolor="white")
