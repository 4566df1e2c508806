"""Tribology of the tooth contact: Hertz contact, oil, film, friction, flash temperature."""
