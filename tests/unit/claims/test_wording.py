from gearwear.claims.wording import micrometres, millimetres, percent


def test_numbers_carry_their_unit():
    assert micrometres(1.23456e-5) == "12.3 um"
    assert millimetres(0.0081234) == "8.123 mm"
    assert percent(0.00123) == "0.123 %"
