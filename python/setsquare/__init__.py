# SPDX-FileCopyrightText: 2026 The Setsquare authors
# SPDX-License-Identifier: Apache-2.0
"""2-D laser scans of a building to a map whose walls are straight and square.

    import setsquare

    map = setsquare.map_log("intel.clf")            # any format, no parameters
    map.save("out")                                 # every file that the command writes
    answer = setsquare.match(ranges_a, ranges_b, fov_deg=180)   # no initial guess

Angles are in rad and lengths in m, unless a name says otherwise (fov_deg, stamp_ns). A pose T_a_b
maps points of frame b into frame a. In a notebook scans, matches and maps draw themselves;
setsquare.plot draws them with Matplotlib.
"""

from setsquare import _notebook
from setsquare._core import (
    AbsoluteTrajectoryError,
    Error,
    ErrorBounds,
    ErrorStatistics,
    FileError,
    FormatError,
    KnownMap,
    LocalisedPose,
    Localizer,
    LocatedScan,
    LogReader,
    LogRecord,
    Map,
    MapDoubt,
    Mapper,
    MatchResult,
    MeanAndDeviation,
    OccupancyGrid,
    ParameterError,
    Pose2,
    PoseGraph,
    PossiblePlace,
    PreparedScan,
    RelationErrorReport,
    RelationErrors,
    RunnerUp,
    Scan,
    Simulation,
    TrackedPose,
    Trajectory,
    __version__,
    evaluate_relations,
    evaluate_trajectory,
    explain,
    locate,
    map_log,
    match,
    merge,
    prepare,
    read_log,
    simulate,
)

__all__ = [
    "AbsoluteTrajectoryError",
    "Error",
    "ErrorBounds",
    "ErrorStatistics",
    "FileError",
    "FormatError",
    "KnownMap",
    "LocalisedPose",
    "Localizer",
    "LocatedScan",
    "LogReader",
    "LogRecord",
    "Map",
    "MapDoubt",
    "Mapper",
    "MatchResult",
    "MeanAndDeviation",
    "OccupancyGrid",
    "ParameterError",
    "Pose2",
    "PoseGraph",
    "PossiblePlace",
    "PreparedScan",
    "RelationErrorReport",
    "RelationErrors",
    "RunnerUp",
    "Scan",
    "Simulation",
    "TrackedPose",
    "Trajectory",
    "__version__",
    "evaluate_relations",
    "evaluate_trajectory",
    "explain",
    "locate",
    "map_log",
    "match",
    "merge",
    "prepare",
    "read_log",
    "simulate",
]

_notebook.install()
