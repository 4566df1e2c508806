"""Events on the route to chaos as columns of a table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from gearwear.codes.onset_codes import EVENTS
from gearwear.onsets.doublings import Onset


def columns(ways: Sequence[Sequence[Onset]]) -> dict[str, Any]:
    """Return the variables of the events, each as (dimensions, array), for one or several ways to compute them.

    Parameters
    ----------
    ways : the events of codes.EVENTS, of every way; a single one leaves no dimension for it.
    """
    dims = ("event",) if len(ways) == 1 else ("variant", "event")

    def of(name: str, kind: Any) -> Any:
        table = np.array([[getattr(event, name) for event in events] for events in ways], dtype=kind)
        return dims, table[0] if len(ways) == 1 else table

    return {
        "onset": of("value", float),
        "onset_seen": of("seen", float),
        "onset_how": of("how", np.int32),
        "onset_resolution": of("resolution", float),
        "onset_remark": of("remark", object),
        "event": ("event", np.array(EVENTS, dtype=object)),
    }
