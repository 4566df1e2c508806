"""The library in a few lines each: a gear pair from its mesh stiffness to the motion of its oscillator."""

import numpy as np

import gearwear

pair = gearwear.GearPair((26, 78), module=3.175e-3, face_width=16e-3, bore_radius=(16e-3, 55e-3))

stiffness = pair.mesh_stiffness(bulk_temperature=100.0).mesh_stiffness
print(f"mesh stiffness {1e-6 * stiffness.min():.0f} to {1e-6 * stiffness.max():.0f} N/um")

error = pair.transmission_error(torque=135.0, bulk_temperature=100.0).transmission_error
print(f"transmission error {1e6 * error.min():.1f} to {1e6 * error.max():.1f} um")

share = pair.load_sharing(torque=135.0).load_share_path
print(f"a pair enters with {100 * share[0]:.0f} % of the mesh force")

heat = pair.contact_temperature(torque=135.0, speed=3400.0, bulk_temperature=100.0)
print(f"contact temperature up to {heat.contact_temperature.max():.0f} degC")

worn = pair.wear(torque=135.0, speed=3400.0, cycles=3e8, bulk_temperature=100.0, force="quasi_static")
print(f"wear {1e6 * worn.wear_depth[-1].max():.2f} um after {float(worn.running_cycles[-1]):.1e} revolutions")

oscillator = pair.oscillator(torque=135.0, bulk_temperature=100.0, wear=worn.isel(wear_cycle=-1))
sweep = oscillator.sweep(np.linspace(0.4, 1.6, 13))
periods = dict(zip(sweep.mesh_frequency.values.round(2).tolist(), sweep.period.values.tolist(), strict=True))
print(f"period in mesh periods by mesh frequency, 0 for chaos: {periods}")

phase = (np.arange(100) + 0.5) / 100
measured = 3e8 * (1 + 0.2 * np.cos(2 * np.pi * phase))
own = gearwear.Oscillator.from_arrays(
    measured, 6e-6 * np.cos(2 * np.pi * phase), force=1000.0, damping_ratio=0.07, half_backlash=60e-6
)
print(f"contact loss share at resonance {own.settle(mesh_frequency=0.9).contact_loss_share:.2f}")
