"""Model sensitivity: what every option of the model and every open parameter changes, one at a time."""
