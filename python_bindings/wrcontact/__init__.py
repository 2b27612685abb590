"""wrcontact: contact points, pressures and forces of wheels on rails.

>>> import wrcontact
>>> result = wrcontact.solve(lateral=3, rail="60E1")
>>> result.left.pmax                        # MPa
>>> result.left.patches[0].pressure         # an array, rows across the rail
>>> result.plot("contact.png")
>>> wrcontact.solve(lateral=[-3, 0, 3])["left.pmax"]     # of arrays: an xarray Dataset

mm, N, MPa, rad; track frame: x forward, y to the left, z up. `wrcontact.keys()` lists the inputs,
docs/results.md the results, docs/python.md shows the rest. Importing prints nothing, and nothing
here ends the program: failures raise a wrcontact.Error.
"""
from ._library import lib as _lib, string as _string
from .conicity import Conicity
from .errors import (AccuracyNote, Busy, ContactWarning, Error, FileMalformed, FileUnreadable, InternalError,
                     InvalidArgument, NoContact, NoResult, NotConverged, OutOfMemory, TooSmall,
                     UnknownName)
from .measures import Comparison, Dimensions
from .grid import NormalContact, RollingContact
from .plot import picture_style
from .profile import Profile, ProfilePoint, standard_profiles
from .report import report
from .result import FrozenResult, Group, Result
from .shakedown import shakedown_map
from .scene import Key, Scene, key_of, keys, solve
from .solver import Equilibrium, History, Solver, Step, solve_batch
from .study import study
from .table import Table, TableFacts

__version__: str = _string(_lib.wrc_version())
__all__ = [
    "AccuracyNote", "Busy", "Comparison", "Conicity", "ContactWarning", "Dimensions", "Equilibrium", "Error", "FileMalformed", "FileUnreadable", "FrozenResult", "Group", "History", "InternalError",
    "InvalidArgument", "Key", "NoContact", "NoResult", "NormalContact", "NotConverged",
    "OutOfMemory", "Profile", "ProfilePoint", "Result", "RollingContact", "Scene", "Solver", "Step",
    "Table", "TableFacts", "TooSmall", "UnknownName", "key_of", "keys", "picture_style", "report", "shakedown_map", "solve", "solve_batch", "standard_profiles",
    "study",
]
