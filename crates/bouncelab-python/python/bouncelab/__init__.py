"""From a recording of a bouncing ball to the physics.

>>> import bouncelab as bl
>>> sound = bl.synthesize(height_m=0.305, restitution=0.95, seed=1)
>>> drop = bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38").drops[0]
>>> print(f"restitution {drop.restitution.value:.3f}, from {drop.drop_height_m.value:.2f} m")
restitution 0.950, from 0.30 m

Quantities are in SI and say so in their names. Bad input is a :class:`BouncelabError` that says what to do.
"""

from bouncelab._analyze import Progress, ProgressBar, analyze, analyze_times
from bouncelab._core import __version__
from bouncelab._data import (
    BandPoint,
    Budget,
    Correlations,
    Diagnostic,
    Estimate,
    ImpactPosterior,
    ImpactRestitution,
    LogLinearFit,
    Measured,
    Model,
    PerImpact,
    Posterior,
    Prediction,
    PriorContraction,
    Sampling,
    Settings,
    Share,
    Source,
    StrongestBand,
)
from bouncelab._errors import (
    BouncelabError,
    InferenceError,
    InputError,
    OutOfRangeError,
    OutputError,
    PhysicsError,
    RecordingError,
    RecordingNotFoundError,
    SessionError,
    UnknownNameError,
)
from bouncelab._figure import Figure
from bouncelab._physics import (
    DragLaw,
    air,
    diagnostic_codes,
    drag_coefficient,
    drag_laws,
    gravity_m_s2,
    languages,
    presets,
)
from bouncelab._recording import Draws, Drop, Drops, Recording
from bouncelab._settings import Air, Ball, Options
from bouncelab._table import Column, Table

__all__ = [
    "Air",
    "Ball",
    "BandPoint",
    "BouncelabError",
    "Budget",
    "Column",
    "Correlations",
    "Diagnostic",
    "DragLaw",
    "Draws",
    "Drop",
    "Drops",
    "Estimate",
    "Figure",
    "ImpactPosterior",
    "ImpactRestitution",
    "InferenceError",
    "InputError",
    "LogLinearFit",
    "Measured",
    "Model",
    "Options",
    "OutOfRangeError",
    "OutputError",
    "PerImpact",
    "PhysicsError",
    "Posterior",
    "Prediction",
    "PriorContraction",
    "Progress",
    "ProgressBar",
    "Recording",
    "RecordingError",
    "RecordingNotFoundError",
    "Sampling",
    "SessionError",
    "Settings",
    "Share",
    "Source",
    "StrongestBand",
    "Table",
    "UnknownNameError",
    "__version__",
    "air",
    "analyze",
    "analyze_times",
    "diagnostic_codes",
    "drag_coefficient",
    "drag_laws",
    "gravity_m_s2",
    "languages",
    "presets",
]
