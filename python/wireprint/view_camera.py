"""From where pictures are taken."""

from __future__ import annotations

from typing import Final

from wireprint._core import SettingError

#: Azimuth, elevation and field of view in degrees; a field of view of 0 is a parallel projection.
CAMERAS: Final = {
    "iso": (35.0, 25.0, 28.0),
    "front": (0.0, 0.0, 0.0),
    "side": (90.0, 0.0, 0.0),
    "top": (0.0, 90.0, 0.0),
}


def camera_angles(camera: str) -> tuple[float, float, float]:
    """Angles of a named camera, or of ``AZIMUTH,ELEVATION``.

    Parameters
    ----------
    camera
        ``iso``, ``front``, ``side``, ``top``, or two numbers in degrees: azimuth about z
        (0 is the front, 90 the right side) and elevation above the horizon.

    Returns
    -------
    tuple
        Azimuth, elevation and field of view, degrees.

    Raises
    ------
    SettingError
        It is neither.
    """
    if camera in CAMERAS:
        return CAMERAS[camera]
    try:
        azimuth, elevation = (float(number) for number in camera.split(","))
    except ValueError:
        names = ", ".join(CAMERAS)
        raise SettingError(f"camera is {camera!r}; it must be {names} or AZ,EL") from None
    return azimuth, elevation, CAMERAS["iso"][2]
