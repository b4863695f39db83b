"""What the figures of a machine can be: bounds that profiles and imports of others share.

From a watchmaker's printer to one that fills a hall. They keep numbers away that would only
overflow a formula or ask for more slices than there is memory.
"""

from typing import Annotated, Any, get_args

from pydantic import Field

BedSize = Annotated[float, Field(ge=10, le=5000)]
CarriageHeight = Annotated[float, Field(ge=0.1, le=300)]
CarriageReach = Annotated[float, Field(ge=0.1, le=500)]
Speed = Annotated[float, Field(ge=0.1, le=5000, description="mm/s")]
Accel = Annotated[float, Field(ge=1, le=1e6, description="mm/s²")]
CornerSpeed = Annotated[float, Field(ge=0, le=1000, description="mm/s")]
Length = Annotated[float, Field(ge=1e-4, le=5000, description="mm")]


def bounds_of(kind: Any) -> tuple[float, float]:
    """Return the least and the most that a kind of figure, or the field of one, can be."""
    about = getattr(kind, "metadata", None) or get_args(kind)[1].metadata
    least = next(one.ge for one in about if hasattr(one, "ge"))
    most = next(one.le for one in about if hasattr(one, "le"))
    return float(least), float(most)
