from pathlib import Path

import yaml

from gearwear.claims.properties import PROPERTIES
from gearwear.claims.scorecard import expectation

ROOT = Path(__file__).parents[3]
CLAIMS = yaml.safe_load((ROOT / "config/paper_claims.yaml").read_text(encoding="utf-8"))["claims"]


def test_there_are_54_claims_with_unique_ids_and_sentences():
    assert len(CLAIMS) == 54
    assert len({claim["id"] for claim in CLAIMS}) == 54
    assert len({claim["says"] for claim in CLAIMS}) == 54


def test_each_qualitative_claim_has_one_function_of_its_own():
    qualitative = [claim["id"] for claim in CLAIMS if claim["kind"] == "qualitative"]
    assert sorted(PROPERTIES) == sorted(qualitative)
    assert len(set(PROPERTIES.values())) == len(PROPERTIES)


def test_each_claim_can_be_judged():
    keys = {
        "qualitative": set(),
        "numeric": {"case", "sweep", "event", "expected"},
        "window": {"case", "sweep", "range", "class"},
    }
    for claim in CLAIMS:
        assert set(claim) == {"id", "figure", "kind", "says"} | keys[claim["kind"]], claim["id"]
        assert expectation(claim)


def test_a_claim_of_quasi_periodic_motion_accepts_period_1():
    for claim in CLAIMS:
        if "QP" in claim.get("class", []):
            assert claim["class"] == ["QP", "P1"], claim["id"]
