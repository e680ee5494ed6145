// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <vector>

#include "bindings/python/values.hpp"
#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway::python {

/// `fairway.Heard`: what another vehicle's method said.
struct HeardSpeech {
  VehicleId from{};
  double sent{};
  Speech speech;
};

/// `fairway.Link`: owns what was heard.
struct OwnedLink {
  std::vector<HeardSpeech> heard;
  double turn_period{};
  double next_turn{};
  std::vector<AcousticRange> ranges;
};

/// Room for what a view shows and a situation has in another form.
struct SituationRoom {
  std::vector<Obstacle> solids;
  std::vector<Heard> heard;
  Link link;
};

/// `fairway.Situation`: owns its tracks, its obstacles and their vertices, so that it may be kept.
struct OwnedSituation {
  double time{};
  double period{};
  Ownship own;
  Goal goal;
  Limits limits;
  std::optional<OnboardModel> model;
  std::optional<Envelope> envelope;
  std::optional<OwnedLink> link;
  Vec3 current = Vec3::Zero();  ///< of the water, as estimated on board [m/s, NED]
  Attendance attendance{};
  std::vector<Track> tracks;            ///< nearest first; equal ranges by id
  std::vector<ObstacleSpec> obstacles;  ///< `velocity` means nothing here

  OwnedSituation() = default;
  /// A copy of all that it is made of. O(tracks + vertices).
  explicit OwnedSituation(const Situation& situation);

  /// What an avoider is shown; `room` is overwritten. Valid while this and `room` live.
  Situation view(SituationRoom& room) const;
};

/// What an algorithm written in Python answered: a Command, or a velocity of three numbers. Throws InputError
/// that begins with `who`.
Command command_of(pybind11::handle answer, const std::string& who);

}  // namespace fairway::python

namespace pybind11::detail {

/// One whose __init__ has not run is no Situation.
template <>
struct type_caster<fairway::python::OwnedSituation> : type_caster_base<fairway::python::OwnedSituation> {
  bool load(handle given, bool convert) {
    const bool is_one = isinstance<fairway::python::OwnedSituation>(given);
    return !(is_one && !fairway::python::is_made(given)) && type_caster_base::load(given, convert);
  }
};

}  // namespace pybind11::detail
