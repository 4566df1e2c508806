"""Legends are read row by row."""

from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from gearwear.figures.sheet import legend_above


def test_entries_stand_in_rows():
    figure = Figure(layout="constrained")
    legend_above(figure, [Line2D([], [], label=str(place)) for place in range(5)], 3)
    figure.draw_without_rendering()
    boxes = [(text.get_window_extent(), text.get_text()) for text in figure.legends[0].get_texts()]
    in_rows = sorted(boxes, key=lambda box: (-round(box[0].y0), box[0].x0))
    assert [text for _, text in in_rows] == ["0", "1", "2", "3", "4"]
