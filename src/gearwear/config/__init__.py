"""Declaration, reading and checking of the configuration."""
