# SPDX-License-Identifier: Apache-2.0
# What bindings/python/*.cpp add, for type checkers and editors; the words are in the docstrings.
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, ClassVar, Final, Protocol, Self

import numpy as np
import numpy.typing as npt

__version__: str

_Doubles = npt.NDArray[np.float64]
_Path = str | os.PathLike[str]
_Seed = int | np.integer[Any]
_Param = float | bool | str | list[dict[str, float | bool | str]]

class _Algorithm(Protocol):
    def decide(self, situation: Situation) -> Command | npt.ArrayLike: ...

_Algorithms = Mapping[str, Callable[..., _Algorithm]]

class InputError(ValueError): ...
class RunDiverged(RuntimeError): ...

# ---- situations and commands: values that are never changed

class _Value:
    def replace(self, **changes: Any) -> Self: ...
    def __eq__(self, other: object) -> bool: ...
    def __copy__(self, *args: Any) -> Self: ...
    def __deepcopy__(self, *args: Any) -> Self: ...

class Ownship(_Value):
    def __init__(
        self,
        id: int = ...,
        position: npt.ArrayLike = ...,
        velocity: npt.ArrayLike = ...,
        yaw: float = ...,
        yaw_rate: float = ...,
        radius: float = ...,
        priority: int = ...,
    ) -> None: ...
    id: Final[int]
    position: Final[_Doubles]
    velocity: Final[_Doubles]
    yaw: Final[float]
    yaw_rate: Final[float]
    radius: Final[float]
    priority: Final[int]

class Track(_Value):
    def __init__(
        self,
        id: int = ...,
        position: npt.ArrayLike = ...,
        velocity: npt.ArrayLike = ...,
        yaw: float = ...,
        radius: float = ...,
        age: float = ...,
        priority: int = ...,
        destination: npt.ArrayLike | None = ...,
        reacts: bool = ...,
        position_covariance: npt.ArrayLike = ...,
        velocity_covariance: npt.ArrayLike = ...,
    ) -> None: ...
    id: Final[int]
    position: Final[_Doubles]
    velocity: Final[_Doubles]
    yaw: Final[float]
    radius: Final[float]
    age: Final[float]
    priority: Final[int]
    destination: Final[_Doubles | None]
    reacts: Final[bool]
    position_covariance: Final[_Doubles]
    velocity_covariance: Final[_Doubles]

class Obstacle(_Value):
    def __init__(
        self,
        kind: str = ...,
        position: npt.ArrayLike = ...,
        radius: float = ...,
        start: npt.ArrayLike = ...,
        end: npt.ArrayLike = ...,
        vertices: npt.ArrayLike = ...,
        charted: bool = ...,
        velocity: npt.ArrayLike = ...,
    ) -> None: ...
    @staticmethod
    def sphere(position: npt.ArrayLike, radius: float, charted: bool = ...) -> Obstacle: ...
    @staticmethod
    def segment(start: npt.ArrayLike, end: npt.ArrayLike, charted: bool = ...) -> Obstacle: ...
    @staticmethod
    def polygon(vertices: npt.ArrayLike, charted: bool = ...) -> Obstacle: ...
    @staticmethod
    def prism(vertices: npt.ArrayLike, charted: bool = ...) -> Obstacle: ...
    kind: Final[str]
    position: Final[_Doubles]
    radius: Final[float]
    start: Final[_Doubles]
    end: Final[_Doubles]
    vertices: Final[_Doubles]
    charted: Final[bool]
    velocity: Final[_Doubles]
    def nearest_point(self, position: npt.ArrayLike) -> tuple[_Doubles, float]: ...

class Goal(_Value):
    def __init__(
        self, position: npt.ArrayLike = ..., cruise_speed: float = ..., velocity: npt.ArrayLike | None = ...
    ) -> None: ...
    position: Final[_Doubles]
    cruise_speed: Final[float]
    velocity: Final[_Doubles | None]

class Limits(_Value):
    def __init__(
        self,
        max_speed: float = ...,
        max_climb_rate: float = ...,
        max_acceleration: float = ...,
        max_turn_rate: float = ...,
        min_depth: float = ...,
        max_depth: float = ...,
        min_speed: float = ...,
        sternway: bool = ...,
        sway: bool = ...,
    ) -> None: ...
    max_speed: Final[float]
    max_climb_rate: Final[float]
    max_acceleration: Final[float]
    max_turn_rate: Final[float]
    min_depth: Final[float]
    max_depth: Final[float]
    min_speed: Final[float]
    sternway: Final[bool]
    sway: Final[bool]

class OnboardModel(_Value):
    def __init__(
        self,
        mass: npt.ArrayLike = ...,
        linear_damping: npt.ArrayLike = ...,
        quadratic_damping: npt.ArrayLike = ...,
        restoring: npt.ArrayLike = ...,
        least: npt.ArrayLike = ...,
        greatest: npt.ArrayLike = ...,
    ) -> None: ...
    mass: Final[_Doubles]
    linear_damping: Final[_Doubles]
    quadratic_damping: Final[_Doubles]
    restoring: Final[_Doubles]
    least: Final[_Doubles]
    greatest: Final[_Doubles]

class _Enumeration:
    name: Final[str]
    value: Final[int]
    def __init__(self, value: int) -> None: ...
    def __int__(self) -> int: ...
    def __index__(self) -> int: ...
    def __hash__(self) -> int: ...
    def __eq__(self, other: object) -> bool: ...
    def __ne__(self, other: object) -> bool: ...

class Mode(_Enumeration):
    cruise: ClassVar[Mode]
    avoid: ClassVar[Mode]
    hold: ClassVar[Mode]
    infeasible: ClassVar[Mode]
    __members__: ClassVar[dict[str, Mode]]

class Command(_Value):
    def __init__(
        self,
        velocity: npt.ArrayLike = ...,
        mode: Mode | str = ...,
        astern: bool = ...,
        heading: float | None = ...,
        turn_rate: float | None = ...,
        wrench: npt.ArrayLike | None = ...,
        note: str = ...,
    ) -> None: ...
    velocity: Final[_Doubles]
    mode: Final[Mode]
    astern: Final[bool]
    heading: Final[float | None]
    turn_rate: Final[float | None]
    wrench: Final[_Doubles | None]
    note: Final[str]

class Situation(_Value):
    def __init__(
        self,
        own: Ownship = ...,
        goal: Goal = ...,
        period: float = ...,
        time: float = ...,
        limits: Limits = ...,
        tracks: Iterable[Track] = ...,
        obstacles: Iterable[Obstacle] = ...,
        model: OnboardModel | None = ...,
    ) -> None: ...
    own: Final[Ownship]
    goal: Final[Goal]
    period: Final[float]
    time: Final[float]
    limits: Final[Limits]
    tracks: Final[tuple[Track, ...]]
    obstacles: Final[tuple[Obstacle, ...]]
    model: Final[OnboardModel | None]
    preferred_velocity: Final[_Doubles]
    track_positions: Final[_Doubles]
    track_velocities: Final[_Doubles]
    track_radii: Final[_Doubles]

# ---- algorithms

class Parameter:
    name: Final[str]
    unit: Final[str]
    type: Final[str]
    low: Final[float]
    high: Final[float]
    meaning: Final[str]
    default: Final[float | bool | str]
    choices: Final[tuple[str, ...]]
    items: Final[tuple[Parameter, ...]]

class AlgorithmInfo:
    name: Final[str]
    title: Final[str]
    source: Final[str]
    planar: Final[bool]
    wraps: Final[bool]
    parameters: Final[tuple[Parameter, ...]]

def algorithms() -> list[AlgorithmInfo]: ...
def algorithm(name: str) -> AlgorithmInfo: ...

class CommandBatch:
    velocity: Final[_Doubles]
    mode: Final[npt.NDArray[np.uint8]]
    def __len__(self) -> int: ...

class Avoider:
    def __init__(self, name: str, seed: _Seed = ..., **params: _Param) -> None: ...
    name: Final[str]
    def decide(self, situation: Situation) -> Command: ...
    def decide_batch(
        self,
        jobs: int = ...,
        *,
        position: npt.ArrayLike,
        velocity: npt.ArrayLike,
        goal: npt.ArrayLike,
        cruise_speed: npt.ArrayLike = ...,
        yaw: npt.ArrayLike = ...,
        yaw_rate: npt.ArrayLike = ...,
        radius: npt.ArrayLike = ...,
        time: npt.ArrayLike = ...,
        track_position: npt.ArrayLike = ...,
        track_velocity: npt.ArrayLike = ...,
        track_radius: npt.ArrayLike = ...,
        period: float = ...,
        limits: Limits = ...,
        obstacles: Iterable[Obstacle] = ...,
    ) -> CommandBatch: ...
    def __copy__(self) -> Avoider: ...
    def __deepcopy__(self, memo: Any) -> Avoider: ...

# ---- vehicles

class State(_Value):
    def __init__(
        self,
        position: npt.ArrayLike = ...,
        quaternion: npt.ArrayLike = ...,
        velocity: npt.ArrayLike = ...,
        angular_velocity: npt.ArrayLike = ...,
    ) -> None: ...
    @staticmethod
    def level(position: npt.ArrayLike, yaw: float = ..., surge: float = ...) -> State: ...
    position: Final[_Doubles]
    quaternion: Final[_Doubles]
    velocity: Final[_Doubles]
    angular_velocity: Final[_Doubles]
    roll: Final[float]
    pitch: Final[float]
    yaw: Final[float]
    velocity_ned: Final[_Doubles]

class Actuator:
    name: Final[str]
    meaning: Final[str]
    low: Final[float]
    high: Final[float]
    time_constant_s: Final[float]

class VehicleInfo:
    name: Final[str]
    title: Final[str]
    source: Final[str]
    parameters: Final[tuple[Parameter, ...]]

def vehicles() -> list[VehicleInfo]: ...

_Actuators = Mapping[str, float] | npt.ArrayLike

class Vehicle:
    state: State
    def __init__(self, name: str, **params: _Param) -> None: ...
    name: Final[str]
    actuators: Final[list[Actuator]]
    @property
    def actuator_state(self) -> _Doubles: ...
    @actuator_state.setter
    def actuator_state(self, values: _Actuators) -> None: ...
    power: Final[float]
    def step(
        self, actuators: _Actuators, period: float, current: npt.ArrayLike = ..., density: float = ...
    ) -> State: ...
    def drive(
        self, commands: npt.ArrayLike, period: float, current: npt.ArrayLike = ..., density: float = ...
    ) -> _Doubles: ...
    def __copy__(self) -> Vehicle: ...
    def __deepcopy__(self, memo: Any) -> Vehicle: ...

def trial(
    vehicle: str,
    times: npt.ArrayLike,
    inputs: Mapping[str, npt.ArrayLike],
    settings: Mapping[str, float | bool | str] = ...,
) -> dict[str, _Doubles]: ...

# ---- scenarios and runs

class Leg(_Value):
    def __init__(
        self,
        kind: str = ...,
        position: npt.ArrayLike = ...,
        start: npt.ArrayLike = ...,
        speed_mps: float = ...,
        box_m: npt.ArrayLike = ...,
        arrival_m: float = ...,
        duration_s: float = ...,
    ) -> None: ...
    kind: Final[str]
    position: Final[_Doubles]
    start: Final[_Doubles]
    speed_mps: Final[float]
    box_m: Final[_Doubles]
    arrival_m: Final[float]
    duration_s: Final[float]

class ScenarioVehicle:
    id: Final[int]
    name: Final[str]
    model: Final[str]
    model_params: Final[dict[str, float | bool | str]]
    algorithm: Final[str]
    algorithm_params: Final[dict[str, float | bool | str]]
    position: Final[_Doubles]
    yaw: Final[float]
    speed: Final[float]
    start_delay_s: Final[float]
    radius_m: Final[float]
    priority: Final[int]
    cooperative: Final[bool]
    limits: Final[Limits]
    mission: Final[tuple[Leg, ...]]

class Scenario:
    @staticmethod
    def load(file: _Path, overrides: Mapping[str, Any] | None = ..., seed: _Seed | None = ...) -> Scenario: ...
    @staticmethod
    def parse(
        text: str, overrides: Mapping[str, Any] | None = ..., seed: _Seed | None = ..., file: str = ...
    ) -> Scenario: ...
    @staticmethod
    def schema() -> str: ...
    def to_yaml(self) -> str: ...
    def with_seed(self, seed: _Seed) -> Scenario: ...
    def with_overrides(self, overrides: Mapping[str, Any] | None) -> Scenario: ...
    def with_algorithm(self, name: str, **params: _Param) -> Scenario: ...
    name: Final[str]
    summary: Final[str]
    seed: Final[int]
    step_s: Final[float]
    steps_per_decision: Final[int]
    duration_s: Final[float]
    vehicles: Final[tuple[ScenarioVehicle, ...]]
    obstacles: Final[tuple[Obstacle, ...]]
    crit_dist_m: Final[float]
    safety_distance_m: Final[float]

class Phase(_Enumeration):
    deploying: ClassVar[Phase]
    waiting: ClassVar[Phase]
    under_way: ClassVar[Phase]
    stuck: ClassVar[Phase]
    arrived: ClassVar[Phase]
    __members__: ClassVar[dict[str, Phase]]

class _Moved:
    times: Final[_Doubles]
    positions: Final[_Doubles]
    velocities: Final[_Doubles]
    quaternions: Final[_Doubles]
    yaws: Final[_Doubles]
    commands: Final[_Doubles]
    goals: Final[_Doubles]
    powers: Final[_Doubles]
    modes: Final[npt.NDArray[np.uint8]]
    phases: Final[npt.NDArray[np.uint8]]

class Trajectories(_Moved):
    def __len__(self) -> int: ...

class Run:
    scenario: Final[str]
    seed: Final[int]
    simulated_s: Final[float]
    wall_s: Final[float]
    fleet: Final[dict[str, float]]
    vehicles: Final[list[dict[str, Any]]]
    notes: Final[dict[str, str]]
    trajectories: Final[Trajectories | None]

def run(
    scenario: Scenario | _Path,
    algorithms: _Algorithms | None = ...,
    record: _Path | None = ...,
    trajectories: bool = ...,
    perception: bool = ...,
    sketches: bool = ...,
) -> Run: ...

class Batch:
    scenario_names: Final[list[str]]
    scenarios: Final[npt.NDArray[np.int64]]
    seeds: Final[npt.NDArray[np.uint64]]
    fleet: Final[dict[str, _Doubles]]
    vehicles: Final[dict[str, _Doubles]]
    failures: Final[dict[int, BaseException]]
    wall_s: Final[float]
    def __len__(self) -> int: ...

def run_batch(
    scenario: Scenario | _Path | Sequence[Scenario | _Path],
    seeds: Iterable[_Seed] | None = ...,
    jobs: int = ...,
    algorithms: _Algorithms | None = ...,
    progress: Callable[[int, int], object] | None = ...,
) -> Batch: ...

# ---- what was kept

class Recording(_Moved):
    @staticmethod
    def read(file: _Path) -> Recording: ...
    file: Final[str]
    version: Final[str]
    scenario_name: Final[str]
    scenario_yaml: Final[str]
    seed: Final[int]
    period_s: Final[float]
    names: Final[list[str]]
    models: Final[list[str]]
    perception: Final[bool]
    sketches: Final[bool]
    divergence: Final[str]
    stopped: Final[bool]
    trajectories: Final[Trajectories]
    fleet: Final[dict[str, float]]
    vehicles: Final[list[dict[str, Any]]]
    def csv(self, file: _Path | None = ...) -> str | None: ...
    def tracks_csv(self, file: _Path | None = ...) -> str | None: ...
    def __len__(self) -> int: ...

class Results:
    labels: Final[dict[str, list[str]]]
    seeds: Final[npt.NDArray[np.uint64]]
    fleet: Final[dict[str, _Doubles]]
    vehicles: Final[dict[str, _Doubles]]
    failures: Final[dict[int, str]]
    keys: Final[list[str]]
    commands: Final[list[str]]
    made: Final[int]
    wall_s: Final[_Doubles]
    def __len__(self) -> int: ...

def load_results(file: _Path) -> Results: ...
def sweep(
    campaign: _Path,
    out: _Path | None = ...,
    jobs: int = ...,
    algorithms: _Algorithms | None = ...,
    retry_failures: bool = ...,
) -> Results: ...
def compare(
    results: Results | _Path | Sequence[Results | _Path],
    by: str = ...,
    baseline: str | None = ...,
    quantities: Iterable[str] | None = ...,
    confidence: float = ...,
) -> dict[str, Any]: ...
def explain(
    recording: Recording | _Path,
    vehicle: str | int,
    time: float,
    algorithms: _Algorithms | None = ...,
    out: _Path | None = ...,
) -> dict[str, Any]: ...
def view(
    recording: Recording | _Path,
    out: _Path | None = ...,
    sketch: bool = ...,
    algorithms: _Algorithms | None = ...,
    from_s: float = ...,
    to_s: float = ...,
    every: int = ...,
) -> str: ...
def studies() -> list[dict[str, str]]: ...
def study(
    name: str,
    seeds: int = ...,
    jobs: int = ...,
    overrides: Mapping[str, Any] | None = ...,
    store: _Path | None = ...,
) -> list[dict[str, Any]]: ...

# ---- environments: fairway.gym is made of these

class FleetEnvironments:
    def __init__(
        self,
        scenario: Scenario | _Path,
        *,
        count: int = ...,
        learners: Sequence[str] = ...,
        tracks: int | None = ...,
        obstacles: int | None = ...,
        axes: str = ...,
        reward: Mapping[str, float] = ...,
        action_repeat: int = ...,
        actions: str = ...,
        end_on_collision: bool = ...,
        skip_deployment: bool = ...,
        overrides: Mapping[str, Any] | None = ...,
        threads: int = ...,
        autoreset: bool = ...,
        algorithms: _Algorithms | None = ...,
    ) -> None: ...
    def reset(self, chosen: npt.ArrayLike | None = ..., seeds: Sequence[int | None] = ...) -> None: ...
    def step(self, actions: npt.ArrayLike) -> None: ...
    def step_commands(self, commands: Sequence[Command]) -> None: ...
    def advise(self) -> npt.NDArray[Any]: ...
    def advised_commands(self) -> list[Command]: ...
    def situation(self, environment: int = ..., learner: int = ...) -> Situation | None: ...
    def measures(self, environment: int = ...) -> dict[str, Any]: ...
    def outline(self, environment: int = ...) -> Any: ...
    count: Final[int]
    learners: Final[list[str]]
    vehicles: Final[list[str]]
    max_speeds: Final[list[float]]
    period: Final[float]
    observation_names: Final[list[str]]
    observations: Final[npt.NDArray[Any]]
    rewards: Final[npt.NDArray[Any]]
    returns: Final[npt.NDArray[Any]]
    terminated: Final[npt.NDArray[Any]]
    truncated: Final[npt.NDArray[Any]]
    time: Final[npt.NDArray[Any]]
    seed: Final[npt.NDArray[Any]]
    goal_distance: Final[npt.NDArray[Any]]
    separation: Final[npt.NDArray[Any]]
    clearance: Final[npt.NDArray[Any]]
    deciding: Final[npt.NDArray[Any]]
    arrived: Final[npt.NDArray[Any]]
    stuck: Final[npt.NDArray[Any]]
    collided: Final[npt.NDArray[Any]]
