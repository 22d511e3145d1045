"""From a recording of a bouncing ball to the physics.

>>> import bouncelab as bl
>>> sound = bl.synthesize(height_m=0.3, restitution=0.95, ball="table-tennis-38", seed=1)
>>> drop = bl.analyze(sound.samples, sound.sample_rate_hz, ball="table-tennis-38").drops[0]
>>> print(f"restitution {drop.restitution.value:.3f}, from {drop.drop_height_m.value:.2f} m")
restitution 0.950, from 0.30 m

Quantities are in SI, with the unit in the name. Invalid input raises a :class:`BouncelabError` that states a remedy.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from bouncelab._core import __version__

if TYPE_CHECKING:
    from bouncelab._analyze import Progress, ProgressBar, analyze, analyze_times
    from bouncelab._data import (
        AirUsed,
        BallComparison,
        BallUsed,
        BandPoint,
        Budget,
        Correlations,
        Diagnostic,
        Estimate,
        GravityUsed,
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
        SettingsUsed,
        Share,
        Source,
        StrongestBand,
    )
    from bouncelab._detector import Detector
    from bouncelab._errors import (
        BouncelabError,
        BouncelabWarning,
        InferenceError,
        InputError,
        MissingPackageError,
        OutOfRangeError,
        OutputError,
        PhysicsError,
        RecordingError,
        RecordingNotFoundError,
        SessionError,
        UnknownNameError,
    )
    from bouncelab._figure import Figure
    from bouncelab._likelihood import Gradient, LogLikelihood
    from bouncelab._physics import (
        RestitutionLaw,
        air,
        air_density_kg_m3,
        air_viscosity_pa_s,
        diagnostic_codes,
        drag_coefficient,
        drag_laws,
        falls,
        flights,
        gravity_m_s2,
        languages,
        presets,
        restitution_laws,
        terminal_speed_m_s,
    )
    from bouncelab._recording import Draws, Drop, Drops, Recording
    from bouncelab._session import Study, session
    from bouncelab._settings import Air, Ball, Options, PhysicsOptions, SimulationOptions
    from bouncelab._simulation import Simulation, Sound, simulate, synthesize
    from bouncelab._table import Column, Table
    from bouncelab._verdict import Rule, Verdict, rules, verdict

#: Where each name is. A module is imported when something of it is used: the import itself takes little.
_PLACES = {
    "_analyze": "Progress ProgressBar analyze analyze_times",
    "_data": (
        "AirUsed BallComparison BallUsed BandPoint Budget Correlations Diagnostic Estimate GravityUsed "
        "ImpactPosterior ImpactRestitution LogLinearFit Measured Model PerImpact Posterior Prediction PriorContraction Sampling "
        "SettingsUsed Share Source StrongestBand"
    ),
    "_detector": "Detector",
    "_errors": (
        "BouncelabError BouncelabWarning InferenceError InputError MissingPackageError OutOfRangeError OutputError PhysicsError "
        "RecordingError RecordingNotFoundError SessionError UnknownNameError"
    ),
    "_figure": "Figure",
    "_likelihood": "Gradient LogLikelihood",
    "_physics": (
        "RestitutionLaw air air_density_kg_m3 air_viscosity_pa_s diagnostic_codes drag_coefficient drag_laws "
        "falls flights gravity_m_s2 languages presets restitution_laws terminal_speed_m_s"
    ),
    "_recording": "Draws Drop Drops Recording",
    "_session": "Study session",
    "_settings": "Air Ball Options PhysicsOptions SimulationOptions",
    "_simulation": "Simulation Sound simulate synthesize",
    "_table": "Column Table",
    "_verdict": "Rule Verdict rules verdict",
}
_MODULES = {name: module for module, names in _PLACES.items() for name in names.split()}

__all__ = [
    "Air",
    "AirUsed",
    "Ball",
    "BallComparison",
    "BallUsed",
    "BandPoint",
    "BouncelabError",
    "BouncelabWarning",
    "Budget",
    "Column",
    "Correlations",
    "Detector",
    "Diagnostic",
    "Draws",
    "Drop",
    "Drops",
    "Estimate",
    "Figure",
    "Gradient",
    "GravityUsed",
    "ImpactPosterior",
    "ImpactRestitution",
    "InferenceError",
    "InputError",
    "LogLikelihood",
    "LogLinearFit",
    "Measured",
    "MissingPackageError",
    "Model",
    "Options",
    "OutOfRangeError",
    "OutputError",
    "PerImpact",
    "PhysicsError",
    "PhysicsOptions",
    "Posterior",
    "Prediction",
    "PriorContraction",
    "Progress",
    "ProgressBar",
    "Recording",
    "RecordingError",
    "RecordingNotFoundError",
    "RestitutionLaw",
    "Rule",
    "Sampling",
    "SessionError",
    "SettingsUsed",
    "Share",
    "Simulation",
    "SimulationOptions",
    "Sound",
    "Source",
    "StrongestBand",
    "Study",
    "Table",
    "UnknownNameError",
    "Verdict",
    "__version__",
    "air",
    "air_density_kg_m3",
    "air_viscosity_pa_s",
    "analyze",
    "analyze_times",
    "diagnostic_codes",
    "drag_coefficient",
    "drag_laws",
    "falls",
    "flights",
    "gravity_m_s2",
    "languages",
    "presets",
    "restitution_laws",
    "rules",
    "session",
    "simulate",
    "synthesize",
    "terminal_speed_m_s",
    "verdict",
]


def __getattr__(name: str) -> object:
    if name == "batch":
        return importlib.import_module("bouncelab.batch")
    if name not in _MODULES:
        raise AttributeError(f"module 'bouncelab' has no attribute {name!r}")
    value = getattr(importlib.import_module(f"bouncelab.{_MODULES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return __all__
