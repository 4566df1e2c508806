import csv
from types import SimpleNamespace

from gearwear.plumbing import tables
from gearwear.plumbing.closure import SCRIPTS

ROWS = [("a.key", "1.5", "m", "length of < and &"), ("list", "[1, 2]", "-", 'two, "quoted"')]


def test_numbers_of_a_csv_read_back_as_the_same(tmp_path):
    values = [0.1, 1 / 3, 6.02214076e23, 5e-324]
    tables.write_csv(str(tmp_path / "numbers.csv"), ("value",), ([value] for value in values))
    with open(tmp_path / "numbers.csv", newline="") as file:
        assert [float(row["value"]) for row in csv.DictReader(file)] == values


def test_a_table_is_written_as_csv_and_as_a_page_of_its_own(tmp_path):
    template = str(SCRIPTS.parent / "report" / "table.html.j2")
    output = SimpleNamespace(csv=str(tmp_path / "table.csv"), html=str(tmp_path / "table.html"))
    job = SimpleNamespace(input=SimpleNamespace(template=template), output=output)
    tables.write(job, "parameters", ("key", "value", "unit", "meaning"), iter(ROWS))
    with open(output.csv, newline="") as file:
        assert [tuple(row) for row in csv.reader(file)] == [("key", "value", "unit", "meaning"), *ROWS]
    page = (tmp_path / "table.html").read_text(encoding="utf-8")
    assert "<h1>Parameters</h1>" in page
    assert page.count("<tr>") == 3
    assert "length of &lt; and &amp;" in page
    assert "http" not in page
    assert sorted(path.name for path in tmp_path.iterdir()) == ["table.csv", "table.html"]


def test_rows_are_written_as_csv_that_any_reader_understands(tmp_path):
    rows = [{"key": "a, b", "value": "1"}, {"key": 'said "c"', "value": "two\nlines"}]
    tables.write_rows(rows, str(tmp_path / "table.csv"))
    with open(tmp_path / "table.csv", newline="") as file:
        assert list(csv.DictReader(file)) == rows
    assert b"\r" not in (tmp_path / "table.csv").read_bytes()
    assert [path.name for path in tmp_path.iterdir()] == ["table.csv"]
