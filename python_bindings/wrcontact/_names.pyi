"""Keywords of scenes and names of results, for editors and mypy. Written by scripts/write_python_names.py, not by hand."""
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Protocol, TypeVar, Union, overload

import numpy as np
import xarray

from ._handle import Handle
from ._library import Array
from .profile import Profile
from .result import Group, Result

class _HasArray(Protocol):
    def __array__(self) -> Any: ...

_Self = TypeVar("_Self")
N = Union[float, "np.integer[Any]", "np.floating[Any]", str, None]  # a number, or its word
Ns = Union[N, Sequence[float], _HasArray]
L = Union[Sequence[float], _HasArray, str, None]  # a list of numbers
T = Union[str, None]
B = Union[bool, str, None]
W = Union[str, Sequence[str], None]
P = Union[str, "PathLike[str]", Profile, Mapping[str, Any]]
Ps = Union[P, Sequence[Union[str, Profile]], _HasArray]

class SceneKeywords(Handle):
    def __init__(self, *,
        convention_units: T = ..., units: T = ..., convention_frame: T = ..., frame: T = ..., track_gauge: N = ..., gauge: N = ...,
        track_gauge_height: N = ..., gauge_height: N = ..., track_inclination: N = ..., inclination: N = ..., track_rail: P = ...,
        rail: P = ..., track_left_rail: P = ..., left_rail: P = ..., track_left_displacement: L = ..., left_displacement: L = ...,
        track_left_velocity: L = ..., left_velocity: L = ..., track_left_slope: L = ..., left_slope: L = ..., track_right_rail: P = ...,
        right_rail: P = ..., track_right_displacement: L = ..., right_displacement: L = ..., track_right_velocity: L = ...,
        right_velocity: L = ..., track_right_slope: L = ..., right_slope: L = ..., wheelset_wheel: P = ..., wheel: P = ...,
        wheelset_harmonics: L = ..., harmonics: L = ..., wheelset_back_to_back: N = ..., back_to_back: N = ...,
        wheelset_tape_offset: N = ..., tape_offset: N = ..., wheelset_radius: N = ..., radius: N = ..., wheelset_left_wheel: P = ...,
        left_wheel: P = ..., wheelset_left_harmonics: L = ..., left_harmonics: L = ..., wheelset_left_radius: N = ...,
        left_radius: N = ..., wheelset_right_wheel: P = ..., right_wheel: P = ..., wheelset_right_harmonics: L = ...,
        right_harmonics: L = ..., wheelset_right_radius: N = ..., right_radius: N = ..., material_youngs_modulus: N = ...,
        youngs_modulus: N = ..., material_poisson: N = ..., poisson: N = ..., material_wheel_youngs_modulus: N = ...,
        wheel_youngs_modulus: N = ..., material_wheel_poisson: N = ..., wheel_poisson: N = ..., material_wheel_yield_stress: N = ...,
        wheel_yield_stress: N = ..., material_rail_youngs_modulus: N = ..., rail_youngs_modulus: N = ..., material_rail_poisson: N = ...,
        rail_poisson: N = ..., material_rail_yield_stress: N = ..., rail_yield_stress: N = ..., pose_lateral: N = ..., lateral: N = ...,
        pose_longitudinal: N = ..., longitudinal: N = ..., pose_pitch: N = ..., pitch: N = ..., pose_yaw: N = ..., yaw: N = ...,
        pose_roll: N = ..., roll: N = ..., pose_vertical: N = ..., vertical: N = ..., load_both: N = ..., both: N = ...,
        load_left: N = ..., load_right: N = ..., load_of: T = ..., of: T = ..., friction_coefficient: N = ..., coefficient: N = ...,
        friction_places: L = ..., places: L = ..., friction_left: N = ..., friction_left_places: L = ..., left_places: L = ...,
        friction_right: N = ..., friction_right_places: L = ..., right_places: L = ..., friction_limit_ratio: N = ...,
        limit_ratio: N = ..., friction_decay: N = ..., decay: N = ..., creepage_longitudinal: N = ..., creepage_lateral: N = ...,
        creepage_spin: N = ..., spin: N = ..., creepage_left: L = ..., creepage_right: L = ..., motion_speed: N = ..., speed: N = ...,
        motion_pitch: N = ..., motion_torque: N = ..., torque: N = ..., motion_lateral: N = ..., motion_vertical: N = ...,
        motion_roll: N = ..., motion_yaw: N = ..., motion_curvature: N = ..., curvature: N = ..., motion_acceleration: L = ...,
        acceleration: L = ..., motion_standstill_speed: N = ..., standstill_speed: N = ..., solve_creep: T = ..., creep: T = ...,
        solve_derivatives: B = ..., derivatives: B = ..., solve_side: T = ..., side: T = ..., solve_until: T = ..., until: T = ...,
        solve_method: T = ..., method: T = ..., solve_curved: B = ..., curved: B = ..., solve_model: T = ..., model: T = ...,
        solve_accuracy_of: T = ..., accuracy_of: T = ..., solve_accuracy: N = ..., accuracy: N = ..., solve_grid: L = ..., grid: L = ...,
        solve_tolerance: N = ..., tolerance: N = ..., solve_element_limit: N = ..., element_limit: N = ...,
        solve_joining_distance: N = ..., joining_distance: N = ..., solve_near_tolerance: N = ..., near_tolerance: N = ...,
        solve_passes: N = ..., passes: N = ..., solve_threads: N = ..., threads: N = ..., solve_results: W = ..., results: W = ...,
        stress_body: T = ..., body: T = ..., stress_section: T = ..., section: T = ..., wear_law: T = ..., law: T = ...,
        wear_energy_coefficient: N = ..., energy_coefficient: N = ..., wear_hardness: N = ..., hardness: N = ..., wear_scale: N = ...,
        scale: N = ..., fatigue_shear_yield: N = ..., shear_yield: N = ...) -> None: ...
    def set(self: _Self, *,
        convention_units: T = ..., units: T = ..., convention_frame: T = ..., frame: T = ..., track_gauge: N = ..., gauge: N = ...,
        track_gauge_height: N = ..., gauge_height: N = ..., track_inclination: N = ..., inclination: N = ..., track_rail: P = ...,
        rail: P = ..., track_left_rail: P = ..., left_rail: P = ..., track_left_displacement: L = ..., left_displacement: L = ...,
        track_left_velocity: L = ..., left_velocity: L = ..., track_left_slope: L = ..., left_slope: L = ..., track_right_rail: P = ...,
        right_rail: P = ..., track_right_displacement: L = ..., right_displacement: L = ..., track_right_velocity: L = ...,
        right_velocity: L = ..., track_right_slope: L = ..., right_slope: L = ..., wheelset_wheel: P = ..., wheel: P = ...,
        wheelset_harmonics: L = ..., harmonics: L = ..., wheelset_back_to_back: N = ..., back_to_back: N = ...,
        wheelset_tape_offset: N = ..., tape_offset: N = ..., wheelset_radius: N = ..., radius: N = ..., wheelset_left_wheel: P = ...,
        left_wheel: P = ..., wheelset_left_harmonics: L = ..., left_harmonics: L = ..., wheelset_left_radius: N = ...,
        left_radius: N = ..., wheelset_right_wheel: P = ..., right_wheel: P = ..., wheelset_right_harmonics: L = ...,
        right_harmonics: L = ..., wheelset_right_radius: N = ..., right_radius: N = ..., material_youngs_modulus: N = ...,
        youngs_modulus: N = ..., material_poisson: N = ..., poisson: N = ..., material_wheel_youngs_modulus: N = ...,
        wheel_youngs_modulus: N = ..., material_wheel_poisson: N = ..., wheel_poisson: N = ..., material_wheel_yield_stress: N = ...,
        wheel_yield_stress: N = ..., material_rail_youngs_modulus: N = ..., rail_youngs_modulus: N = ..., material_rail_poisson: N = ...,
        rail_poisson: N = ..., material_rail_yield_stress: N = ..., rail_yield_stress: N = ..., pose_lateral: N = ..., lateral: N = ...,
        pose_longitudinal: N = ..., longitudinal: N = ..., pose_pitch: N = ..., pitch: N = ..., pose_yaw: N = ..., yaw: N = ...,
        pose_roll: N = ..., roll: N = ..., pose_vertical: N = ..., vertical: N = ..., load_both: N = ..., both: N = ...,
        load_left: N = ..., load_right: N = ..., load_of: T = ..., of: T = ..., friction_coefficient: N = ..., coefficient: N = ...,
        friction_places: L = ..., places: L = ..., friction_left: N = ..., friction_left_places: L = ..., left_places: L = ...,
        friction_right: N = ..., friction_right_places: L = ..., right_places: L = ..., friction_limit_ratio: N = ...,
        limit_ratio: N = ..., friction_decay: N = ..., decay: N = ..., creepage_longitudinal: N = ..., creepage_lateral: N = ...,
        creepage_spin: N = ..., spin: N = ..., creepage_left: L = ..., creepage_right: L = ..., motion_speed: N = ..., speed: N = ...,
        motion_pitch: N = ..., motion_torque: N = ..., torque: N = ..., motion_lateral: N = ..., motion_vertical: N = ...,
        motion_roll: N = ..., motion_yaw: N = ..., motion_curvature: N = ..., curvature: N = ..., motion_acceleration: L = ...,
        acceleration: L = ..., motion_standstill_speed: N = ..., standstill_speed: N = ..., solve_creep: T = ..., creep: T = ...,
        solve_derivatives: B = ..., derivatives: B = ..., solve_side: T = ..., side: T = ..., solve_until: T = ..., until: T = ...,
        solve_method: T = ..., method: T = ..., solve_curved: B = ..., curved: B = ..., solve_model: T = ..., model: T = ...,
        solve_accuracy_of: T = ..., accuracy_of: T = ..., solve_accuracy: N = ..., accuracy: N = ..., solve_grid: L = ..., grid: L = ...,
        solve_tolerance: N = ..., tolerance: N = ..., solve_element_limit: N = ..., element_limit: N = ...,
        solve_joining_distance: N = ..., joining_distance: N = ..., solve_near_tolerance: N = ..., near_tolerance: N = ...,
        solve_passes: N = ..., passes: N = ..., solve_threads: N = ..., threads: N = ..., solve_results: W = ..., results: W = ...,
        stress_body: T = ..., body: T = ..., stress_section: T = ..., section: T = ..., wear_law: T = ..., law: T = ...,
        wear_energy_coefficient: N = ..., energy_coefficient: N = ..., wear_hardness: N = ..., hardness: N = ..., wear_scale: N = ...,
        scale: N = ..., fatigue_shear_yield: N = ..., shear_yield: N = ...) -> _Self: ...

@overload  # type: ignore  # without arguments both fit: the first one holds
def solve(*,
        convention_units: T = ..., units: T = ..., convention_frame: T = ..., frame: T = ..., track_gauge: N = ..., gauge: N = ...,
        track_gauge_height: N = ..., gauge_height: N = ..., track_inclination: N = ..., inclination: N = ..., track_rail: P = ...,
        rail: P = ..., track_left_rail: P = ..., left_rail: P = ..., track_left_displacement: L = ..., left_displacement: L = ...,
        track_left_velocity: L = ..., left_velocity: L = ..., track_left_slope: L = ..., left_slope: L = ..., track_right_rail: P = ...,
        right_rail: P = ..., track_right_displacement: L = ..., right_displacement: L = ..., track_right_velocity: L = ...,
        right_velocity: L = ..., track_right_slope: L = ..., right_slope: L = ..., wheelset_wheel: P = ..., wheel: P = ...,
        wheelset_harmonics: L = ..., harmonics: L = ..., wheelset_back_to_back: N = ..., back_to_back: N = ...,
        wheelset_tape_offset: N = ..., tape_offset: N = ..., wheelset_radius: N = ..., radius: N = ..., wheelset_left_wheel: P = ...,
        left_wheel: P = ..., wheelset_left_harmonics: L = ..., left_harmonics: L = ..., wheelset_left_radius: N = ...,
        left_radius: N = ..., wheelset_right_wheel: P = ..., right_wheel: P = ..., wheelset_right_harmonics: L = ...,
        right_harmonics: L = ..., wheelset_right_radius: N = ..., right_radius: N = ..., material_youngs_modulus: N = ...,
        youngs_modulus: N = ..., material_poisson: N = ..., poisson: N = ..., material_wheel_youngs_modulus: N = ...,
        wheel_youngs_modulus: N = ..., material_wheel_poisson: N = ..., wheel_poisson: N = ..., material_wheel_yield_stress: N = ...,
        wheel_yield_stress: N = ..., material_rail_youngs_modulus: N = ..., rail_youngs_modulus: N = ..., material_rail_poisson: N = ...,
        rail_poisson: N = ..., material_rail_yield_stress: N = ..., rail_yield_stress: N = ..., pose_lateral: N = ..., lateral: N = ...,
        pose_longitudinal: N = ..., longitudinal: N = ..., pose_pitch: N = ..., pitch: N = ..., pose_yaw: N = ..., yaw: N = ...,
        pose_roll: N = ..., roll: N = ..., pose_vertical: N = ..., vertical: N = ..., load_both: N = ..., both: N = ...,
        load_left: N = ..., load_right: N = ..., load_of: T = ..., of: T = ..., friction_coefficient: N = ..., coefficient: N = ...,
        friction_places: L = ..., places: L = ..., friction_left: N = ..., friction_left_places: L = ..., left_places: L = ...,
        friction_right: N = ..., friction_right_places: L = ..., right_places: L = ..., friction_limit_ratio: N = ...,
        limit_ratio: N = ..., friction_decay: N = ..., decay: N = ..., creepage_longitudinal: N = ..., creepage_lateral: N = ...,
        creepage_spin: N = ..., spin: N = ..., creepage_left: L = ..., creepage_right: L = ..., motion_speed: N = ..., speed: N = ...,
        motion_pitch: N = ..., motion_torque: N = ..., torque: N = ..., motion_lateral: N = ..., motion_vertical: N = ...,
        motion_roll: N = ..., motion_yaw: N = ..., motion_curvature: N = ..., curvature: N = ..., motion_acceleration: L = ...,
        acceleration: L = ..., motion_standstill_speed: N = ..., standstill_speed: N = ..., solve_creep: T = ..., creep: T = ...,
        solve_derivatives: B = ..., derivatives: B = ..., solve_side: T = ..., side: T = ..., solve_until: T = ..., until: T = ...,
        solve_method: T = ..., method: T = ..., solve_curved: B = ..., curved: B = ..., solve_model: T = ..., model: T = ...,
        solve_accuracy_of: T = ..., accuracy_of: T = ..., solve_accuracy: N = ..., accuracy: N = ..., solve_grid: L = ..., grid: L = ...,
        solve_tolerance: N = ..., tolerance: N = ..., solve_element_limit: N = ..., element_limit: N = ...,
        solve_joining_distance: N = ..., joining_distance: N = ..., solve_near_tolerance: N = ..., near_tolerance: N = ...,
        solve_passes: N = ..., passes: N = ..., solve_threads: N = ..., threads: N = ..., solve_results: W = ..., results: W = ...,
        stress_body: T = ..., body: T = ..., stress_section: T = ..., section: T = ..., wear_law: T = ..., law: T = ...,
        wear_energy_coefficient: N = ..., energy_coefficient: N = ..., wear_hardness: N = ..., hardness: N = ..., wear_scale: N = ...,
        scale: N = ..., fatigue_shear_yield: N = ..., shear_yield: N = ...) -> Result: ...
@overload
def solve(*, outputs: Union[str, Sequence[str]] = ..., progress: Union[Callable[[float], object], None] = ...,
        convention_units: T = ..., units: T = ..., convention_frame: T = ..., frame: T = ..., track_gauge: Ns = ..., gauge: Ns = ...,
        track_gauge_height: Ns = ..., gauge_height: Ns = ..., track_inclination: Ns = ..., inclination: Ns = ..., track_rail: Ps = ...,
        rail: Ps = ..., track_left_rail: Ps = ..., left_rail: Ps = ..., track_left_displacement: L = ..., left_displacement: L = ...,
        track_left_velocity: L = ..., left_velocity: L = ..., track_left_slope: L = ..., left_slope: L = ..., track_right_rail: Ps = ...,
        right_rail: Ps = ..., track_right_displacement: L = ..., right_displacement: L = ..., track_right_velocity: L = ...,
        right_velocity: L = ..., track_right_slope: L = ..., right_slope: L = ..., wheelset_wheel: Ps = ..., wheel: Ps = ...,
        wheelset_harmonics: L = ..., harmonics: L = ..., wheelset_back_to_back: Ns = ..., back_to_back: Ns = ...,
        wheelset_tape_offset: Ns = ..., tape_offset: Ns = ..., wheelset_radius: Ns = ..., radius: Ns = ..., wheelset_left_wheel: Ps = ...,
        left_wheel: Ps = ..., wheelset_left_harmonics: L = ..., left_harmonics: L = ..., wheelset_left_radius: Ns = ...,
        left_radius: Ns = ..., wheelset_right_wheel: Ps = ..., right_wheel: Ps = ..., wheelset_right_harmonics: L = ...,
        right_harmonics: L = ..., wheelset_right_radius: Ns = ..., right_radius: Ns = ..., material_youngs_modulus: Ns = ...,
        youngs_modulus: Ns = ..., material_poisson: Ns = ..., poisson: Ns = ..., material_wheel_youngs_modulus: Ns = ...,
        wheel_youngs_modulus: Ns = ..., material_wheel_poisson: Ns = ..., wheel_poisson: Ns = ..., material_wheel_yield_stress: Ns = ...,
        wheel_yield_stress: Ns = ..., material_rail_youngs_modulus: Ns = ..., rail_youngs_modulus: Ns = ...,
        material_rail_poisson: Ns = ..., rail_poisson: Ns = ..., material_rail_yield_stress: Ns = ..., rail_yield_stress: Ns = ...,
        pose_lateral: Ns = ..., lateral: Ns = ..., pose_longitudinal: Ns = ..., longitudinal: Ns = ..., pose_pitch: Ns = ...,
        pitch: Ns = ..., pose_yaw: Ns = ..., yaw: Ns = ..., pose_roll: Ns = ..., roll: Ns = ..., pose_vertical: Ns = ...,
        vertical: Ns = ..., load_both: Ns = ..., both: Ns = ..., load_left: Ns = ..., load_right: Ns = ..., load_of: T = ..., of: T = ...,
        friction_coefficient: Ns = ..., coefficient: Ns = ..., friction_places: L = ..., places: L = ..., friction_left: Ns = ...,
        friction_left_places: L = ..., left_places: L = ..., friction_right: Ns = ..., friction_right_places: L = ...,
        right_places: L = ..., friction_limit_ratio: Ns = ..., limit_ratio: Ns = ..., friction_decay: Ns = ..., decay: Ns = ...,
        creepage_longitudinal: Ns = ..., creepage_lateral: Ns = ..., creepage_spin: Ns = ..., spin: Ns = ..., creepage_left: L = ...,
        creepage_right: L = ..., motion_speed: Ns = ..., speed: Ns = ..., motion_pitch: Ns = ..., motion_torque: Ns = ...,
        torque: Ns = ..., motion_lateral: Ns = ..., motion_vertical: Ns = ..., motion_roll: Ns = ..., motion_yaw: Ns = ...,
        motion_curvature: Ns = ..., curvature: Ns = ..., motion_acceleration: L = ..., acceleration: L = ...,
        motion_standstill_speed: Ns = ..., standstill_speed: Ns = ..., solve_creep: T = ..., creep: T = ..., solve_derivatives: B = ...,
        derivatives: B = ..., solve_side: T = ..., side: T = ..., solve_until: T = ..., until: T = ..., solve_method: T = ...,
        method: T = ..., solve_curved: B = ..., curved: B = ..., solve_model: T = ..., model: T = ..., solve_accuracy_of: T = ...,
        accuracy_of: T = ..., solve_accuracy: Ns = ..., accuracy: Ns = ..., solve_grid: L = ..., grid: L = ..., solve_tolerance: Ns = ...,
        tolerance: Ns = ..., solve_element_limit: Ns = ..., element_limit: Ns = ..., solve_joining_distance: Ns = ...,
        joining_distance: Ns = ..., solve_near_tolerance: Ns = ..., near_tolerance: Ns = ..., solve_passes: Ns = ..., passes: Ns = ...,
        solve_threads: Ns = ..., threads: Ns = ..., solve_results: W = ..., results: W = ..., stress_body: T = ..., body: T = ...,
        stress_section: T = ..., section: T = ..., wear_law: T = ..., law: T = ..., wear_energy_coefficient: Ns = ...,
        energy_coefficient: Ns = ..., wear_hardness: Ns = ..., hardness: Ns = ..., wear_scale: Ns = ..., scale: Ns = ...,
        fatigue_shear_yield: Ns = ..., shear_yield: Ns = ...) -> xarray.Dataset: ...
def study(parameters: Mapping[str, Any], results: Union[str, Sequence[str]] = ..., *, threads: int = ..., separator: str = ...,
        progress: Union[Callable[[float], object], None] = ...,
        convention_units: T = ..., units: T = ..., convention_frame: T = ..., frame: T = ..., track_gauge: N = ..., gauge: N = ...,
        track_gauge_height: N = ..., gauge_height: N = ..., track_inclination: N = ..., inclination: N = ..., track_rail: P = ...,
        rail: P = ..., track_left_rail: P = ..., left_rail: P = ..., track_left_displacement: L = ..., left_displacement: L = ...,
        track_left_velocity: L = ..., left_velocity: L = ..., track_left_slope: L = ..., left_slope: L = ..., track_right_rail: P = ...,
        right_rail: P = ..., track_right_displacement: L = ..., right_displacement: L = ..., track_right_velocity: L = ...,
        right_velocity: L = ..., track_right_slope: L = ..., right_slope: L = ..., wheelset_wheel: P = ..., wheel: P = ...,
        wheelset_harmonics: L = ..., harmonics: L = ..., wheelset_back_to_back: N = ..., back_to_back: N = ...,
        wheelset_tape_offset: N = ..., tape_offset: N = ..., wheelset_radius: N = ..., radius: N = ..., wheelset_left_wheel: P = ...,
        left_wheel: P = ..., wheelset_left_harmonics: L = ..., left_harmonics: L = ..., wheelset_left_radius: N = ...,
        left_radius: N = ..., wheelset_right_wheel: P = ..., right_wheel: P = ..., wheelset_right_harmonics: L = ...,
        right_harmonics: L = ..., wheelset_right_radius: N = ..., right_radius: N = ..., material_youngs_modulus: N = ...,
        youngs_modulus: N = ..., material_poisson: N = ..., poisson: N = ..., material_wheel_youngs_modulus: N = ...,
        wheel_youngs_modulus: N = ..., material_wheel_poisson: N = ..., wheel_poisson: N = ..., material_wheel_yield_stress: N = ...,
        wheel_yield_stress: N = ..., material_rail_youngs_modulus: N = ..., rail_youngs_modulus: N = ..., material_rail_poisson: N = ...,
        rail_poisson: N = ..., material_rail_yield_stress: N = ..., rail_yield_stress: N = ..., pose_lateral: N = ..., lateral: N = ...,
        pose_longitudinal: N = ..., longitudinal: N = ..., pose_pitch: N = ..., pitch: N = ..., pose_yaw: N = ..., yaw: N = ...,
        pose_roll: N = ..., roll: N = ..., pose_vertical: N = ..., vertical: N = ..., load_both: N = ..., both: N = ...,
        load_left: N = ..., load_right: N = ..., load_of: T = ..., of: T = ..., friction_coefficient: N = ..., coefficient: N = ...,
        friction_places: L = ..., places: L = ..., friction_left: N = ..., friction_left_places: L = ..., left_places: L = ...,
        friction_right: N = ..., friction_right_places: L = ..., right_places: L = ..., friction_limit_ratio: N = ...,
        limit_ratio: N = ..., friction_decay: N = ..., decay: N = ..., creepage_longitudinal: N = ..., creepage_lateral: N = ...,
        creepage_spin: N = ..., spin: N = ..., creepage_left: L = ..., creepage_right: L = ..., motion_speed: N = ..., speed: N = ...,
        motion_pitch: N = ..., motion_torque: N = ..., torque: N = ..., motion_lateral: N = ..., motion_vertical: N = ...,
        motion_roll: N = ..., motion_yaw: N = ..., motion_curvature: N = ..., curvature: N = ..., motion_acceleration: L = ...,
        acceleration: L = ..., motion_standstill_speed: N = ..., standstill_speed: N = ..., solve_creep: T = ..., creep: T = ...,
        solve_derivatives: B = ..., derivatives: B = ..., solve_side: T = ..., side: T = ..., solve_until: T = ..., until: T = ...,
        solve_method: T = ..., method: T = ..., solve_curved: B = ..., curved: B = ..., solve_model: T = ..., model: T = ...,
        solve_accuracy_of: T = ..., accuracy_of: T = ..., solve_accuracy: N = ..., accuracy: N = ..., solve_grid: L = ..., grid: L = ...,
        solve_tolerance: N = ..., tolerance: N = ..., solve_element_limit: N = ..., element_limit: N = ...,
        solve_joining_distance: N = ..., joining_distance: N = ..., solve_near_tolerance: N = ..., near_tolerance: N = ...,
        solve_passes: N = ..., passes: N = ..., solve_threads: N = ..., solve_results: W = ..., stress_body: T = ..., body: T = ...,
        stress_section: T = ..., section: T = ..., wear_law: T = ..., law: T = ..., wear_energy_coefficient: N = ...,
        energy_coefficient: N = ..., wear_hardness: N = ..., hardness: N = ..., wear_scale: N = ..., scale: N = ...,
        fatigue_shear_yield: N = ..., shear_yield: N = ...) -> xarray.Dataset: ...

class WheelCentroid(Group):
    angle: float
    rolling_radius: float
    s_wheel: float
    t_rail: float
    v_rail: float
    w_wheel: float
    wheel_angle: float
    x: float
    y: float
    z: float

class WheelElementSize(Group):
    lateral: float
    longitudinal: float

class WheelFatigue(Group):
    elastic_limit: float
    friction: float
    pressure_ratio: float
    rail_damage: float
    shakedown_limit: float
    surface_index: float

class WheelGrid(Group):
    lateral: int
    longitudinal: int

class WheelGroove(Group):
    depth_max: float

class WheelJacobianForceXBy(Group):
    lateral: float
    lateral_velocity: float
    pitch_rate: float
    roll: float
    roll_rate: float
    speed: float
    vertical: float
    vertical_velocity: float
    yaw: float
    yaw_rate: float

class WheelJacobianForceX(Group):
    by: WheelJacobianForceXBy

class WheelJacobianForce(Group):
    x: WheelJacobianForceX
    y: WheelJacobianForceX
    z: WheelJacobianForceX

class WheelJacobian(Group):
    force: WheelJacobianForce
    moment: WheelJacobianForce

class NearContact(Group):
    angle: float
    distance: float
    rolling_radius: float
    s_wheel: float
    t_rail: float
    v_rail: float
    w_wheel: float
    wheel_angle: float
    x: float
    y: float
    z: float

class PatchCreepage(Group):
    lateral: float
    longitudinal: float
    spin: float

class PatchKalker(Group):
    c11: float
    c22: float
    c23: float
    c33: float

class PatchPressureForce(Group):
    x: float
    y: float
    z: float

class PatchStress(Group):
    across: float
    along: float
    depth: float
    error_estimate: float
    shear: float
    tension: float
    von_mises_max: float

class PatchWear(Group):
    depth_max: float
    tgamma: float
    tgamma_with_spin: float
    volume: float

class Patch(Group):
    adhesion_area: float
    angle: float
    approach: float
    area: float
    centroid: WheelCentroid
    coupling_weight: float
    creep_convolutions: int
    creep_element_size: WheelElementSize
    creep_error_estimate: float
    creep_force: WheelElementSize
    creep_grid: WheelGrid
    creep_residual: float
    creep_steady_error: float
    creepage: PatchCreepage
    element_size: WheelElementSize
    fatigue: WheelFatigue
    fill: float
    friction: float
    friction_power: float
    grid: WheelGrid
    groove: WheelGroove
    kalker: PatchKalker
    lateral_force: float
    lobes: int
    longitudinal_force: float
    normal_force: float
    numerical_loss: float
    parts: Sequence[Patch]
    plane_angle: float
    plane_error: float
    pmax: float
    pmax_elastic: float
    pmax_element: float
    pressure_force: PatchPressureForce
    pressure_moment: PatchPressureForce
    radii: WheelElementSize
    regions: int
    rolling_radius: float
    s_wheel: float
    semi_axes: WheelElementSize
    slip_area: float
    slip_variation: float
    spin_moment: float
    stress: PatchStress
    t_rail: float
    traction_max: float
    turn: float
    v_rail: float
    vertical_force: float
    w_wheel: float
    wear: PatchWear
    wear_number: float
    wheel_angle: float
    x: float
    y: float
    z: float
    undeformed_distance: Array
    pressure: Array
    displacement: Array
    row_scale: Array
    creep_x: Array
    creep_y: Array
    creep_z: Array
    creep_pressure: Array
    traction_x: Array
    traction_y: Array
    slip_x: Array
    slip_y: Array
    frictional_energy: Array
    wear_depth: Array
    wear_s_wheel: Array
    wear_t_rail: Array
    groove_depth_wheel: Array
    groove_depth_rail: Array
    groove_s_wheel: Array
    groove_t_rail: Array
    stress_place: Array
    stress_depth: Array
    stress_von_mises: Array
    stress_shear: Array
    stress_xx: Array
    stress_yy: Array
    stress_zz: Array
    stress_xy: Array
    stress_xz: Array
    stress_yz: Array
    lobe_normal_force: Array
    lobe_force_x: Array
    lobe_force_y: Array
    lobe_force_z: Array
    lobe_angle: Array
    lobe_x: Array
    lobe_y: Array
    lobe_z: Array
    lobe_s_wheel: Array
    lobe_t_rail: Array
    lobe_rolling_radius: Array
    lobe_semi_axes_longitudinal: Array
    lobe_semi_axes_lateral: Array

class WheelResiduals(Group):
    complementarity: float
    least_gap: float
    load_balance: float

class WheelSensitivitiesAtLoadPressureForceY(Group):
    lateral: float
    roll: float

class WheelSensitivitiesAtLoadPressureForce(Group):
    y: WheelSensitivitiesAtLoadPressureForceY

class WheelSensitivitiesAtLoad(Group):
    pressure_force: WheelSensitivitiesAtLoadPressureForce
    vertical: WheelSensitivitiesAtLoadPressureForceY

class WheelSensitivitiesPressureForceY(Group):
    lateral: float
    roll: float
    vertical: float
    yaw: float

class WheelSensitivitiesPressureForce(Group):
    y: WheelSensitivitiesPressureForceY
    z: WheelSensitivitiesPressureForceY

class WheelSensitivities(Group):
    at_load: WheelSensitivitiesAtLoad
    pressure_force: WheelSensitivitiesPressureForce

class WheelSmoothed0Mm(Group):
    area: float
    pmax: float

class WheelSpread(Group):
    area: float
    grade: int
    pmax: float

class WheelTotal(Group):
    force: PatchPressureForce
    moment: PatchPressureForce

class Wheel(Group):
    angle: float
    approach: float
    area: float
    centroid: WheelCentroid
    convolutions: int
    creep_steady_error: float
    depth: float
    derailment_quotient: float
    discretisation_error: float
    element_size: WheelElementSize
    error_estimate: float
    fatigue: WheelFatigue
    fill: float
    grade: int
    grid: WheelGrid
    groove: WheelGroove
    iterations: int
    jacobian: WheelJacobian
    lateral_force: float
    longitudinal_force: float
    model: str
    model_error: float
    model_reason: str
    near_contacts: Sequence[NearContact]
    normal_force: float
    patch_count: int
    patches: Sequence[Patch]
    pmax: float
    pmax_elastic: float
    pmax_element: float
    pressure_force: PatchPressureForce
    pressure_moment: PatchPressureForce
    residuals: WheelResiduals
    rigid_contact: NearContact
    sensitivities: WheelSensitivities
    smoothed_0mm: WheelSmoothed0Mm
    smoothed_15mm: WheelSmoothed0Mm
    smoothed_3mm: WheelSmoothed0Mm
    smoothed_5mm: WheelSmoothed0Mm
    smoothed_8mm: WheelSmoothed0Mm
    solutions: int
    spread: WheelSpread
    state: int
    steels: str
    stop_reason: str
    stress: PatchStress
    total: WheelTotal
    validity: float
    vertical: float
    vertical_force: float
    warning_count: int
    warnings: Sequence[str]
    wear: PatchWear
    wear_number: float
    x: Array
    y: Array
    z: Array
    undeformed_distance: Array
    pressure: Array
    displacement: Array
    row_scale: Array
    creep_x: Array
    creep_y: Array
    creep_z: Array
    creep_pressure: Array
    traction_x: Array
    traction_y: Array
    slip_x: Array
    slip_y: Array
    frictional_energy: Array
    wear_depth: Array
    wear_s_wheel: Array
    wear_t_rail: Array
    groove_depth_wheel: Array
    groove_depth_rail: Array
    groove_s_wheel: Array
    groove_t_rail: Array
    stress_place: Array
    stress_depth: Array
    stress_von_mises: Array
    stress_shear: Array
    stress_xx: Array
    stress_yy: Array
    stress_zz: Array
    stress_xy: Array
    stress_xz: Array
    stress_yz: Array
    lobe_normal_force: Array
    lobe_force_x: Array
    lobe_force_y: Array
    lobe_force_z: Array
    lobe_angle: Array
    lobe_x: Array
    lobe_y: Array
    lobe_z: Array
    lobe_s_wheel: Array
    lobe_t_rail: Array
    lobe_rolling_radius: Array
    lobe_semi_axes_longitudinal: Array
    lobe_semi_axes_lateral: Array
    rail_y: Array
    rail_z: Array
    wheel_y: Array
    wheel_z: Array

class Spread(Group):
    rolling_radius_difference: float

class TimeMs(Group):
    damage: float
    geometry: float
    mechanics: float
    profile: float
    remesh: float
    rolling: float
    setup: float
    total: float

class ResultNames:
    corrections: Sequence[str]
    frame: str
    grade: int
    left: Wheel
    model: str
    pitch: float
    roll: float
    rolling_radius_difference: float
    solver: str
    spread: Spread
    time_ms: TimeMs
    units: str
    vertical: float
    warning_classes: Sequence[str]
    warning_count: int
    warning_grades: Sequence[str]
    wheelset: WheelTotal
    right: Wheel
