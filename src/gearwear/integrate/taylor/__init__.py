"""Power-series integrator of the translational oscillator."""
