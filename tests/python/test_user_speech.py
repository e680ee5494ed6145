# SPDX-License-Identifier: Apache-2.0
"""Algorithms written in Python that speak: what they say is carried, recorded and read, and what they hear is theirs."""

import pytest

import fairway

from conftest import ROOT
from test_user_algorithms import Straight


class Counts(Straight):
    """Says how often it was asked for its word, and keeps what it hears."""

    heard = {}

    def __init__(self):
        self.asked = 0

    def speech(self):
        self.asked += 1
        return bytes([7, self.asked % 256])

    def decide(self, situation):
        self.link = situation.link
        if self.link is not None:
            for each in self.link.heard:
                Counts.heard[situation.own.id, each.sender] = (each.sent, each.speech)
            Counts.next_turn = (situation.time, self.link.next_turn, self.link.turn_period)
        Counts.tracks = len(situation.tracks)
        return super().decide(situation)


def speaking(kind=Counts):
    slots = {"exchange.update_rate_hz": 1, "duration_s": 20}
    return fairway.run(fairway.Scenario.load(ROOT / "scenarios" / "acoustic_pair.yaml", overrides=slots).with_algorithm("mine"),
                       algorithms={"mine": kind})


def test_it_is_told_the_distances_that_modems_measure():
    class Measures(Counts):
        ranges = []

        def decide(self, situation):
            command = super().decide(situation)
            Measures.ranges += list(self.link.ranges)
            return command

    path, slots = ROOT / "scenarios" / "acoustic_pair.yaml", {"exchange.update_rate_hz": 1, "exchange.ranging": "one_way", "duration_s": 20}
    fairway.run(fairway.Scenario.load(path, overrides=slots).with_algorithm("mine"), algorithms={"mine": Measures})
    assert {each.to for each in Measures.ranges} == {0, 1}
    assert all(each.distance > 1 and each.deviation == 0.2 and each.out == each.back <= 20 for each in Measures.ranges)


def test_it_may_speak_and_hears_what_the_others_say():
    Counts.heard = {}
    speaking()
    assert set(Counts.heard) == {(0, 1), (1, 0)}
    for sent, speech in Counts.heard.values():
        assert 0 <= sent < 20
        assert len(speech) == 2 and speech[0] == 7
    now, following, period = Counts.next_turn
    assert now < following <= now + period
    assert Counts.tracks == 0, "its words stand in the place of the record that tells where it is"


def test_its_words_are_recorded_and_read_by_it(tmp_path):
    class Reads(Counts):
        def reading(self, word):
            return f"was asked for {word.speech[1]} words by {word.sent} s"

    def words_read_by(kind):
        slots = {"exchange.update_rate_hz": 1, "duration_s": 20}
        file = ROOT / "scenarios" / "acoustic_pair.yaml"
        fairway.run(fairway.Scenario.load(file, overrides=slots).with_algorithm("mine"), algorithms={"mine": kind}, record=tmp_path / "said.mcap")
        why = fairway.explain(tmp_path / "said.mcap", vehicle=0, time=15, algorithms={"mine": kind})
        return why["words"]["said"], why["words"]["heard"][0]

    for word in words_read_by(Reads):
        assert word["text"].startswith(f"was asked for {bytes.fromhex(word['bytes'])[1]} words by ")
    for word in words_read_by(Counts):
        assert word["text"] == f"says the bytes {word['bytes']}"


def test_what_goes_wrong_in_a_reading_is_raised(tmp_path):
    class Breaks(Counts):
        def reading(self, word):
            raise LookupError("no such word")

    file = ROOT / "scenarios" / "acoustic_pair.yaml"
    run = fairway.Scenario.load(file, overrides={"duration_s": 20}).with_algorithm("mine")
    fairway.run(run, algorithms={"mine": Breaks}, record=tmp_path / "said.mcap")
    with pytest.raises(LookupError, match="no such word"):
        fairway.explain(tmp_path / "said.mcap", vehicle=0, time=15, algorithms={"mine": Breaks})


def test_who_says_nothing_tells_where_it_is():
    class Mute(Counts):
        def speech(self):
            return None

    Counts.heard = {}
    speaking(Mute)
    assert Counts.heard == {}
    assert Counts.tracks == 1


def test_more_than_a_modem_takes_is_refused():
    class Babbler(Straight):
        def speech(self):
            return bytes(26)

    with pytest.raises(fairway.InputError, match=r'speech\(\) of the algorithm "mine": expected bytes, 25 at most'):
        speaking(Babbler)


def test_what_goes_wrong_in_a_speech_ends_the_run():
    class Broken(Straight):
        def speech(self):
            return 1 / 0

    with pytest.raises(ZeroDivisionError):
        speaking(Broken)
