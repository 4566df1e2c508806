"""How results look on paper: the sheet, its axes, colours and legends. No quantity is computed here."""
