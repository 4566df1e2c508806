from gearwear.io.data_dictionary import text
from gearwear.io.variables import variables


def test_every_field_has_a_row_with_its_unit():
    rows = [line.split(" | ") for line in text().splitlines() if line.startswith("| `")]
    assert len(rows) == len(variables())
    for row, (name, field) in zip(rows, variables().items(), strict=True):
        assert row[0] == f"| `{name.removeprefix('swept ')}`"
        assert row[1] == (field.units or "-")
