from gearwear.io.data_dictionary import FILE, text
from gearwear.io.variables import variables


def test_the_page_is_that_of_the_table_of_fields():
    assert FILE.read_text(encoding="utf-8") == text()


def test_every_field_has_a_row_with_its_unit():
    rows = [line.split(" | ") for line in text().splitlines() if line.startswith("| `")]
    assert len(rows) == len(variables())
    for row, (name, field) in zip(rows, variables().items(), strict=True):
        assert row[0] == f"| `{name.removeprefix('swept ')}`"
        assert row[1] == (field.units or "-")
