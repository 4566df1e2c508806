"""Tables as CSV and as pages, whatever text they hold."""

import csv
from html.parser import HTMLParser
from pathlib import Path

import pytest

from gearwear.figures import page, scorecard
from gearwear.io import tables

ROOT = Path(__file__).resolve().parents[3]
TEMPLATE = ROOT / "workflow" / "report" / "table.html.j2"

ROWS = [("a.key", "1.5", "m", "length of < and &"), ("list", "[1, 2]", "-", 'two, "quoted"')]


def test_numbers_of_a_csv_read_back_as_the_same(tmp_path):
    values = [0.1, 1 / 3, 6.02214076e23, 5e-324]
    tables.write_csv(str(tmp_path / "numbers.csv"), ("value",), ([value] for value in values))
    with open(tmp_path / "numbers.csv", newline="") as file:
        assert [float(row["value"]) for row in csv.DictReader(file)] == values


def test_a_table_is_written_as_csv_and_as_a_page_of_its_own(tmp_path):
    table = tables.Table(("key", "value", "unit", "meaning"), ROWS)
    tables.write_csv(tmp_path / "table.csv", *table)
    with open(tmp_path / "table.csv", newline="") as file:
        assert [tuple(row) for row in csv.reader(file)] == [table.columns, *ROWS]
    page = tables.page_of(table, TEMPLATE, "parameters")
    assert "<h1>Parameters</h1>" in page
    assert page.count("<tr>") == 3
    assert "length of &lt; and &amp;" in page
    assert "http" not in page
    assert [path.name for path in tmp_path.iterdir()] == ["table.csv"]


def test_rows_with_the_same_keys_are_a_table_that_any_reader_understands(tmp_path):
    rows = [{"key": "a, b", "value": "1"}, {"key": 'said "c"', "value": "two\nlines"}]
    table = tables.Table.of(rows)
    assert table == (("key", "value"), [("a, b", "1"), ('said "c"', "two\nlines")])
    tables.write_csv(str(tmp_path / "table.csv"), *table)
    with open(tmp_path / "table.csv", newline="") as file:
        assert list(csv.DictReader(file)) == rows
    assert b"\r" not in (tmp_path / "table.csv").read_bytes()


FORMULAS = ("=1+1", "+1+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\t=1", '=HYPERLINK("x")')


def test_text_is_no_formula_for_a_spreadsheet(tmp_path):
    plain = ["-", "-1.5", "+2", "-inf", "a=b", "1e-3", "", "x, -y"]
    tables.write_csv(str(tmp_path / "table.csv"), ("text",), ([text] for text in (*FORMULAS, *plain)))
    with open(tmp_path / "table.csv", newline="") as file:
        assert [row["text"] for row in csv.DictReader(file)] == [*(f"'{text}" for text in FORMULAS), *plain]


HOSTILE = "<script>alert(1)</script>\"'><img src=x onerror=alert(1)>&lt;</td>"


class Read(HTMLParser):
    """Elements, attributes and text of a page, read as a browser reads them."""

    def __init__(self, text):
        super().__init__()
        self.elements, self.attributes, self.text = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.elements.append(tag)
        self.attributes += [name for name, _ in attrs]

    def handle_data(self, data):
        self.text.append(data)


def shape(text):
    read = Read(text)
    return read.elements, read.attributes


def template(name):
    return (ROOT / "workflow" / "report" / name).read_text(encoding="utf-8")


def table_page(text):
    return tables.page_of(tables.Table((text, "value"), [(text, text), ("-", text)]), TEMPLATE, text)


def claims_page(text):
    row = dict.fromkeys(("id", "says", "expected", "found", "verdict"), text) | {"figure": "12"}
    claim = {"kind": "qualitative", "case": text}
    return scorecard.page(template("claims.html.j2"), [row], [claim], {})


def motions_page(text):
    record = {"case": text, "label": text, "sweep": text, "class": [text], "longest": 3}
    return page.page(template("page.html.j2"), "", [record])


@pytest.mark.parametrize("write", [table_page, claims_page, motions_page])
def test_text_is_no_markup_on_a_page(write):
    found = write(HOSTILE)
    assert shape(found) == shape(write("plain"))
    assert HOSTILE in Read(found).text
