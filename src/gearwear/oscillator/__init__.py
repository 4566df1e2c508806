"""The nonlinear oscillator of the gear mesh and its excitation."""
