"""A file of any program is timed and judged: here one whose second post runs into the first."""

import wireprint

TEXT = b"""\
G28
M104 S230
M109 S230
G90
M83
G1 X0 Y0 Z0.35 F3000
G1 X20 Y0 E4 F1800
G1 X20 Y0 Z8 E2
G4 P1000
G0 Z20
G0 X20 Y0.5
G0 Z2
"""

estimate = wireprint.estimate(TEXT, printer="kossel-mini")
print(f"{estimate.total_s:.0f} s")

certificate = wireprint.check(TEXT, printer="kossel-mini")
assert not certificate.ok
hit = certificate.collisions[0]
print(f"line {hit.line}: the head reaches {hit.depth_mm:.1f} mm into material")
