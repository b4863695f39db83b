"""Strokes on the example cube, as a brush makes them."""


def flank(z_mm=14.0, radius_mm=4.0):
    """Return a stroke along the front of a cube of 28 mm."""
    points = [[x, -14.0, z_mm] for x in range(-8, 9, 2)]
    return {
        "kind": "stroke",
        "points_mm": points,
        "normals": [[0.0, -1.0, 0.0]] * len(points),
        "radius_mm": radius_mm,
        "spread_deg": 80.0,
    }
