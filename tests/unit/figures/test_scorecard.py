from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
import xarray as xr

from gearwear.figures import scorecard
from gearwear.figures.motion_classes import colour

TEMPLATE = (Path(__file__).resolve().parents[3] / "workflow/report/claims.html.j2").read_text(encoding="utf-8")
CLAIMS = [
    {"id": "wear", "figure": "6a", "kind": "qualitative", "says": "a < b & 'c'"},
    {
        "id": "window",
        "figure": "15",
        "kind": "window",
        "case": "with",
        "sweep": "ste",
        "range": [1.0, 2.0],
        "class": ["CH"],
    },
]
ROWS = [
    {
        "id": "wear",
        "figure": "6a",
        "says": "a < b & 'c'",
        "expected": "holds",
        "found": "<b>yes</b>",
        "verdict": "agree",
    },
    {"id": "window", "figure": "15", "says": "chaos", "expected": "CH", "found": "P2", "verdict": "differs"},
]
SWEEP = xr.Dataset(
    {"motion_class": ("point", np.array([1, 1, 2, 2, 101], dtype=np.int32))},
    {"ste": ("point", [0.5, 1.0, 1.5, 2.0, 2.5])},
)


def shown(claims=CLAIMS, rows=ROWS, sweeps=None):
    return scorecard.page(TEMPLATE, rows, claims, {("with", "ste"): SWEEP} if sweeps is None else sweeps)


def test_page_counts_what_agrees_and_escapes_what_it_is_told():
    page = shown()
    assert "1 of 2 agree" in page and "Wear: 1 of 1" in page and "transmission error: 0 of 1" in page
    assert "a &lt; b &amp; &#39;c&#39;" in page and "&lt;b&gt;yes&lt;/b&gt;" in page
    assert "<b>yes" not in page


def test_strip_shows_the_window_and_the_classes_around_it():
    page = shown()
    body = page[page.index("<body>") : page.index("</body>") + 7]
    strips = [
        [(rect.get("fill"), float(rect.get("x")), float(rect.get("width"))) for rect in strip.iter("rect")]
        for strip in ElementTree.fromstring(body.replace("<br>", "<br/>")).iter("svg")
    ]
    # From 0.5 to 2.5, half the window on either side; classes meet midway between points.
    assert strips == [
        [(colour("CH"), 25.0, 50.0)],
        [(colour("P1"), 0.0, 37.5), (colour("P2"), 37.5, 50.0), (colour("CH"), 87.5, 12.5)],
    ]


def test_page_needs_no_other_file():
    page = shown()
    assert "http" not in page.replace("https://doi", "") and "src=" not in page and "<link" not in page


def test_a_window_without_its_sweep_has_no_strip():
    assert "<svg" not in shown(sweeps={})


def test_a_claim_of_an_unknown_figure_is_refused():
    with pytest.raises(ValueError, match="1 belong to no group"):
        shown(rows=[ROWS[0] | {"figure": "99"}, ROWS[1]])
