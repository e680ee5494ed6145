// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "fairway/scenario/scenario.hpp"
#include "fairway/view/explain/decision_facts.hpp"
#include "fairway/view/explain/found_decision.hpp"
#include "fairway/view/explain/stroke_facts.hpp"

namespace fairway {

/// What a track is called: the vehicle's name, or what it is tracked as.
std::string track_name(const Scenario& scenario, TrackId id);

/// What a stroke means, with whoever it is of called as everywhere else: "allowed by west_bound" of "allowed
/// by vehicle 1".
std::string named_meaning(const Scenario& scenario, std::string_view meaning);

/// "55.55 s": without the last digits of `tick * period`.
std::string time_words(double time);

/// "34 deg to starboard", "dead ahead", "dead astern".
std::string bearing_words(double bearing);

/// "turns 34 deg to starboard and slows down by 0.12 m/s to 0.38 m/s", against the preferred velocity.
std::string deviation_words(const Deviation& deviation, const Vec3& commanded);

/// One sentence of what was decided and the plainest fact that bears on it, and another if the vehicle makes
/// no progress.
std::string headline_of(const Scenario& scenario, const FoundDecision& found, const DecisionFacts& facts,
                        std::span<const StrokeFacts> strokes);

/// The same where no avoider is asked: who steers instead.
std::string headline_of_unasked(const Scenario& scenario, const FoundDecision& found);

}  // namespace fairway
