"""The sheet of a figure: its size, its files, and legends that are read row by row."""

import pytest
import xarray as xr
from matplotlib.figure import Figure
from matplotlib.image import imread
from matplotlib.lines import Line2D

from gearwear.figures.sheet import legend_above, sheet


def test_entries_stand_in_rows():
    figure = Figure(layout="constrained")
    legend_above(figure, [Line2D([], [], label=str(place)) for place in range(5)], 3)
    figure.draw_without_rendering()
    boxes = [(text.get_window_extent(), text.get_text()) for text in figure.legends[0].get_texts()]
    in_rows = sorted(boxes, key=lambda box: (-round(box[0].y0), box[0].x0))
    assert [text for _, text in in_rows] == ["0", "1", "2", "3", "4"]


@pytest.fixture
def written(tmp_path):
    """Return a function that writes a figure and returns the paths of SVG and PNG."""

    def write(drawing, **inputs):
        drawing.write(inputs, {"svg.hashsalt": "test", "savefig.dpi": 50}, tmp_path / "a.svg", tmp_path / "a.png")
        return tmp_path / "a.svg", tmp_path / "a.png"

    return write


@sheet(50.8, lambda count, **_: 25.4 * count, layout=None)
def panels(figure, count, data):
    for position in range(count):
        figure.add_subplot(count, 1, position + 1)


def test_the_height_may_follow_from_the_inputs(written):
    svg, png = written(panels, count=3, data=[])
    assert 'width="144pt" height="216pt"' in svg.read_text()
    assert imread(png).shape[:2] == (150, 100)


def test_the_source_is_the_lineages_of_the_datasets(written):
    made = [xr.Dataset(attrs={"lineage": name}) for name in ("b", "a", "b")]
    svg, png = written(panels, count=1, data=made)
    assert "gearwear a b<" in svg.read_text()
    assert b"gearwear a b" in png.read_bytes()


def test_a_figure_that_fails_leaves_no_file(written, tmp_path):
    with pytest.raises(TypeError):
        written(panels, count=1)
    assert list(tmp_path.iterdir()) == []
