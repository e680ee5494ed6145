# SPDX-License-Identifier: Apache-2.0
"""Situations and commands: values that are made by keywords, owned, and never changed."""

import copy
import gc
import pickle

import numpy as np
import pytest

import fairway as fw


def situation(**changes):
    own = fw.Ownship(id=0, position=[0, 0, 5], velocity=[0.5, 0, 0])
    given = dict(own=own, goal=fw.Goal(position=[50, 0, 5], cruise_speed=0.5), period=0.1)
    return fw.Situation(**{**given, **changes})


def test_vectors_are_float64_arrays_of_three():
    position = fw.Track(position=(1, 2, 3)).position
    assert position.dtype == np.float64 and position.shape == (3,)
    assert position.tolist() == [1, 2, 3]


def test_what_is_not_given_has_the_default_of_the_library():
    track = fw.Track(id=7, position=[1, 2, 3])
    assert (track.radius, track.age, track.reacts, track.destination) == (1.0, 0.0, True, None)
    assert track.priority == 7, "the id unless given"
    assert fw.Limits().max_speed == np.inf


def test_tracks_are_held_nearest_first_and_equal_ranges_by_id():
    tracks = [fw.Track(id=i, position=[d, 0, 5]) for i, d in [(1, 9), (3, 4), (2, 4)]]
    shown = situation(tracks=tracks)
    assert [track.id for track in shown.tracks] == [2, 3, 1]
    assert shown.track_positions[:, 0].tolist() == [4, 4, 9]
    assert shown.track_velocities.shape == (3, 3) and shown.track_radii.tolist() == [1, 1, 1]


def test_without_tracks_their_arrays_are_empty():
    assert situation().track_positions.shape == (0, 3)
    assert situation().track_radii.shape == (0,)


def test_nothing_of_a_situation_can_be_written():
    shown = situation(tracks=[fw.Track(position=[1, 0, 5])])
    for array in (shown.own.position, shown.track_positions, shown.tracks[0].velocity, shown.track_radii):
        with pytest.raises(ValueError):
            array[0] = 7
    with pytest.raises(AttributeError):
        shown.own.yaw = 1


def test_what_is_kept_of_a_situation_outlives_it():
    shown = situation(tracks=[fw.Track(id=4, position=[1, 2, 3])], obstacles=[fw.Obstacle.prism([(0, 0), (4, 0), (4, 4)])])
    kept = shown.tracks[0].position, shown.obstacles[0].vertices, shown.own, shown.track_positions
    del shown
    gc.collect()
    filler = [situation() for _ in range(1000)]  # whatever was freed is written over
    assert kept[0].tolist() == [1, 2, 3]
    assert kept[1].tolist() == [[0, 0, 0], [4, 0, 0], [4, 4, 0]]
    assert kept[2].velocity.tolist() == [0.5, 0, 0]
    assert kept[3].tolist() == [[1, 2, 3]]
    assert len(filler) == 1000


def test_values_compare_copy_and_pickle():
    shown = situation(tracks=[fw.Track(position=[1, 2, 3])], obstacles=[fw.Obstacle.sphere([9, 9, 9], 2)])
    assert shown == pickle.loads(pickle.dumps(shown)) == copy.deepcopy(shown)
    assert shown != shown.replace(time=1.0)
    assert shown != 3
    assert "Track(position=[1.0, 2.0, 3.0])" in repr(shown)


def test_replace_changes_what_it_names_alone():
    own = fw.Ownship(id=3, position=[1, 2, 3], yaw=0.5, priority=9)
    moved = own.replace(position=[4, 5, 6])
    assert moved.position.tolist() == [4, 5, 6]
    assert (moved.id, moved.yaw, moved.priority) == (3, 0.5, 9)
    assert own.position.tolist() == [1, 2, 3]


def test_the_preferred_velocity_goes_straight_and_slows_down_to_stop_on_the_goal():
    assert situation().preferred_velocity.tolist() == [0.5, 0, 0]
    near = situation(goal=fw.Goal(position=[0.01, 0, 5], cruise_speed=0.5))
    assert near.preferred_velocity == pytest.approx([0.1, 0, 0])


def test_obstacles_know_their_nearest_point():
    point, distance = fw.Obstacle.sphere([10, 0, 0], 2).nearest_point([0, 0, 0])
    assert point.tolist() == [8, 0, 0] and distance == 8
    point, distance = fw.Obstacle.segment([0, 5, 0], [10, 5, 0]).nearest_point([3, 0, 0])
    assert point.tolist() == [3, 5, 0] and distance == 5
    _, distance = fw.Obstacle.polygon([(1, -1), (3, -1), (3, 1), (1, 1)]).nearest_point([0, 0, 7])
    assert distance == 1


def test_a_command_takes_a_mode_or_its_name():
    assert fw.Command([0, 0, 0], fw.Mode.hold).mode == fw.Command(mode="hold").mode == fw.Mode.hold
    assert fw.Mode(int(fw.Mode.avoid)) == fw.Mode.avoid
    assert fw.Command(note="gives way").note == "gives way"
    assert fw.Command(wrench=[1, 2, 3, 4, 5, 6]).wrench.tolist() == [1, 2, 3, 4, 5, 6]


def test_notes_without_end_do_not_fill_the_memory():
    notes = {fw.Command(note=f"note {i}").note for i in range(10000)}
    assert "(one note too many)" in notes and len(notes) < 5000


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: fw.Track(positon=[1, 2, 3]), "Track: position is missing"),
        (lambda: fw.Track(position=[1, 2, 3], radus=2), "Track.radus: there is no such field; did you mean radius?"),
        (lambda: fw.Track(position=[1, 2]), "Track.position: expected 3 numbers, got [1, 2]"),
        (lambda: fw.Track(position="north"), "Track.position: expected 3 numbers, got 'north'"),
        (lambda: fw.Track([1, 2, 3], id=1), "Track.id: given twice"),
        (lambda: fw.Ownship(id=-1, position=[0, 0, 0]), "Ownship.id: expected a whole number that fits, got -1"),
        (lambda: fw.Ownship(yaw="n", position=[0, 0, 0]), "Ownship.yaw: expected a number, got 'n'"),
        (lambda: fw.Goal([1, 2, 3]), "Goal: cruise_speed is missing"),
        (lambda: fw.Command(mode="hodl"), 'Command.mode: unknown "hodl"; did you mean hold?'),
        (lambda: fw.Limits(min_speed=-1), "Limits.min_speed: expected a finite number that is not negative"),
        (lambda: fw.Limits(min_depth=9, max_depth=1), "Limits: min_depth is below max_depth; depth counts downwards"),
        (lambda: fw.Obstacle.sphere([0, 0, 0], -1), "Obstacle.radius: expected a number that is not negative"),
        (lambda: fw.Obstacle.polygon([(0, 0), (1, 1)]), "Obstacle.vertices: expected at least three, got 2"),
        (
            lambda: fw.Obstacle.polygon([(0, 0), (4, 4), (4, 0)]),
            "Obstacle.vertices: they run clockwise; write them counter-clockwise with n as x and e as y",
        ),
        (lambda: situation(tracks=[3]), "Situation.tracks[0]: expected a value of class Track, got 3"),
        (lambda: situation().replace(tiem=3), "Situation.tiem: there is no such field; did you mean time?"),
    ],
)
def test_a_mistake_is_one_line_that_says_what_was_expected(make, message):
    with pytest.raises(fw.InputError) as raised:
        make()
    assert str(raised.value) == message
    assert isinstance(raised.value, ValueError)


def test_an_id_that_is_too_large_for_a_priority_is_refused_unless_one_is_given():
    assert fw.Track(id=2**31 - 1, position=[0, 0, 0]).priority == 2**31 - 1
    for made in (fw.Track, fw.Ownship):
        with pytest.raises(fw.InputError, match="id: is 2147483648, and no priority can be that"):
            made(id=2**31, position=[0, 0, 0])
    assert fw.Track(id=2**32 - 1, position=[0, 0, 0], priority=3).priority == 3


def test_a_mode_is_one_that_there_is():
    assert [fw.Mode(i) for i in range(4)] == list(fw.Mode.__members__.values())
    for number in (-1, 4, 9, 300):
        with pytest.raises(fw.InputError, match="Mode: expected 0 to 3, got"):
            fw.Mode(number)
    with pytest.raises(TypeError):
        fw.Mode("cruise")
    forged = fw.Mode.__new__(fw.Mode)
    forged.__setstate__(9)
    with pytest.raises(fw.InputError, match="Command.mode: expected one of its names"):
        fw.Command(velocity=[0, 0, 0], mode=forged)


def test_what_was_never_initialised_is_refused():
    for empty in (fw.Situation.__new__(fw.Situation), fw.Track.__new__(fw.Track)):
        name = type(empty).__name__
        for attribute in ("own", "tracks", "track_positions", "preferred_velocity") if name == "Situation" else ("position", "id"):
            with pytest.raises((fw.InputError, TypeError)):
                getattr(empty, attribute)
        with pytest.raises((fw.InputError, TypeError)):
            repr(empty)
    with pytest.raises(TypeError):
        fw.Avoider("orca3d").decide(fw.Situation.__new__(fw.Situation))
    with pytest.raises(fw.InputError, match="Track: is empty, since __init__ has not run"):
        situation(tracks=[fw.Track.__new__(fw.Track)])
    with pytest.raises(fw.InputError, match="Ownship: is empty"):
        fw.Situation(own=fw.Ownship.__new__(fw.Ownship), goal=fw.Goal(position=[0, 0, 0], cruise_speed=1), period=1)


def test_an_avoider_is_shown_the_link():
    pledge = fw.Avoider("pledge", team_count=2)
    shown = situation(limits=fw.Limits(max_speed=0.5))
    assert pledge.decide(shown).note == "pledge hears nobody: it needs an exchange"
    heard = [fw.Heard(sender=1, sent=-0.5, speech=bytes(25))]
    link = fw.Link(heard=heard, turn_period=2.0, next_turn=1.0, ranges=[fw.AcousticRange(to=1, distance=20)])
    assert "needs an exchange" not in pledge.decide(shown.replace(link=link)).note
