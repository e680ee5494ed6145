// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/headline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include "fairway/core/angles.hpp"
#include "fairway/metrics/progress.hpp"

namespace fairway {
namespace {

/// Less is not worth a word [m/s, rad].
constexpr double least_speed = 0.005;
constexpr double least_turn = radians(0.5);

/// A velocity has a course worth telling if its horizontal part is at least this share of it.
constexpr double least_share_of_way = 0.2;

/// Less is the rounding of sums [m/s].
constexpr double least_difference = 1e-9;

/// "1 of 2 regions", "the only region", "all 3 regions".
std::string some_of(std::size_t count, std::size_t all, std::string_view one, std::string_view many) {
  if (all == 1) return fmt::format("the only {}", one);
  if (count == all) return fmt::format("all {} {}", all, many);
  return fmt::format("{} of {} {}", count, all, many);
}

std::optional<std::string> forbidden_words(std::span<const StrokeFacts> strokes, Stroke::Kind kind) {
  std::size_t all = 0;
  std::size_t forbidding = 0;
  for (const StrokeFacts& facts : strokes) {
    if (facts.kind != kind) continue;
    all += facts.count;
    forbidding += facts.forbids_preferred;
  }
  if (forbidding == 0) return {};
  if (kind == Stroke::Kind::half_space) {
    return fmt::format(
        "the velocity it prefers is outside {}",
        some_of(forbidding, all, "half-space of allowed velocities", "half-spaces of allowed velocities"));
  }
  return fmt::format(
      "the velocity it prefers is inside {}",
      some_of(forbidding, all, "region of forbidden velocities", "regions of forbidden velocities"));
}

/// What pushes, of a method that adds up forces.
std::optional<std::string> repulsion_words(const Situation& s, std::span<const StrokeFacts> strokes) {
  const auto drawn = [&](std::string_view meaning) {
    const auto facts = std::ranges::find_if(strokes, [&](const StrokeFacts& f) {
      return f.kind == Stroke::Kind::velocity && f.meaning == meaning;
    });
    return facts == strokes.end() ? Vec3{Vec3::Zero()} : facts->strokes.back()->points[0];
  };
  const Vec3 repulsion = drawn("repulsion");
  if (repulsion.norm() < least_speed) return {};
  return fmt::format("a repulsion of {:.2f} m/s, {}, is added to an attraction of {:.2f} m/s",
                     repulsion.norm(), bearing_words(bearing_from_bow(repulsion, s.own.yaw)),
                     drawn("attraction").norm());
}

/// The plan that it carries out, of a method that draws one.
std::optional<std::string> plan_words(std::span<const StrokeFacts> strokes) {
  for (const StrokeFacts& facts : strokes) {
    const bool is_plan = facts.meaning == "trajectory" || facts.meaning == "band";
    if (!is_plan || facts.kind != Stroke::Kind::path) continue;
    return fmt::format("its {} is {:.1f} m long", facts.meaning, facts.length);
  }
  return {};
}

/// Whoever would come nearer than both radii first, if the preferred velocity were followed.
std::optional<std::string> conflict_words(const Scenario& scenario, const DecisionFacts& facts) {
  const NeighbourFacts* first = nullptr;
  for (const NeighbourFacts& n : facts.neighbours) {
    const bool touches = n.preferred.distance < n.radii;
    if (touches && (first == nullptr || n.preferred.time < first->preferred.time)) first = &n;
  }
  if (first == nullptr) return {};
  return fmt::format("the preferred velocity leads to {:.1f} m from {} in {:.1f} s, both radii are {:.1f} m",
                     first->preferred.distance, track_name(scenario, first->track.id), first->preferred.time,
                     first->radii);
}

std::string nearest_words(const Scenario& scenario, const DecisionFacts& facts, Mode mode) {
  const auto may_pass_first = [](const NeighbourFacts& n) { return n.precedence == Precedence::theirs; };
  auto nearest = facts.neighbours.begin();
  const auto first_served = std::ranges::find_if(facts.neighbours, may_pass_first);
  const bool waits = mode == Mode::hold && first_served != facts.neighbours.end();
  if (waits) nearest = first_served;
  if (nearest != facts.neighbours.end()) {
    return fmt::format("{} is {}, {:.1f} m away, {}",
                       waits ? std::string("the nearest that has the right of way")
                             : fmt::format("the nearest of {} neighbour{}", facts.neighbours.size(),
                                           facts.neighbours.size() == 1 ? "" : "s"),
                       track_name(scenario, nearest->track.id), nearest->range,
                       bearing_words(nearest->bearing));
  }
  if (!facts.obstacles.empty()) {
    return fmt::format("no neighbour is known, and the nearest obstacle is {:.1f} m away, {}",
                       facts.obstacles.front().distance, bearing_words(facts.obstacles.front().bearing));
  }
  return "no neighbour and no obstacle is known";
}

/// Behind a colon what the decision was made of, behind a semicolon what else is true.
std::string reason_words(const Scenario& scenario, const FoundDecision& found, const DecisionFacts& facts,
                         std::span<const StrokeFacts> strokes) {
  const Command& command = found.decision->command();
  const Situation& situation = found.decision->situation();
  if (!is_usable(situation)) return ": " + std::string(why_unusable(situation));
  if (!command.note.empty()) return ": " + std::string(command.note);
  // what was drawn is of the velocity that it would have had
  if (command.mode == Mode::hold) return "; " + nearest_words(scenario, facts, command.mode);
  if (const auto words = forbidden_words(strokes, Stroke::Kind::half_space)) return ": " + *words;
  if (const auto words = forbidden_words(strokes, Stroke::Kind::region)) return ": " + *words;
  if (const auto words = repulsion_words(situation, strokes)) return ": " + *words;
  if (const auto words = plan_words(strokes)) return "; " + *words;
  if (const auto words = conflict_words(scenario, facts)) return "; " + *words;
  return "; " + nearest_words(scenario, facts, command.mode);
}

/// " It has made no progress since 43.2 s: deadlocked with robot2." Empty if it does, or is not meant to.
std::string progress_words(const Scenario& scenario, const ProgressReport& progress) {
  std::string with;
  if (progress.with) {
    const std::size_t index = number(*progress.with), vehicles = scenario.vehicles.size();
    with = index < vehicles ? scenario.vehicles[index].name : fmt::format("obstacles[{}]", index - vehicles);
  }
  const std::string text = text_of(progress, with);
  return text.empty() ? text : " It has made " + text + ".";
}

std::string place_words(const Vec3& p) {
  return fmt::format("({:.1f}, {:.1f}, {:.1f}) m", p.x(), p.y(), p.z());
}

}  // namespace

std::string track_name(const Scenario& scenario, TrackId id) {
  const auto vehicle = std::ranges::find(scenario.vehicles, number(id), &VehicleSpec::id);
  if (vehicle != scenario.vehicles.end()) return vehicle->name;
  if (number(id) >= first_drifter_id)
    return fmt::format("drifting obstacle {}", number(id) - first_drifter_id);
  if (number(id) >= first_tracker_id) return fmt::format("track {}", number(id) - first_tracker_id);
  return fmt::format("track {}", number(id));
}

std::string named_meaning(const Scenario& scenario, std::string_view meaning) {
  constexpr std::array<std::pair<std::string_view, std::uint32_t>, 3> kinds{
      {{" vehicle ", 0}, {" contact ", first_tracker_id}, {" drifter ", first_drifter_id}}};
  for (const auto& [kind, first] : kinds) {
    const std::size_t at = meaning.rfind(kind);
    if (at == std::string_view::npos) continue;
    const std::string_view digits = meaning.substr(at + kind.size());
    std::uint32_t serial{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), serial);
    if (error != std::errc{} || end != digits.data() + digits.size()) continue;
    return std::string(meaning.substr(0, at + 1)) + track_name(scenario, TrackId{first + serial});
  }
  return std::string(meaning);
}

std::string time_words(double time) { return fmt::format("{:.10g} s", time); }

std::string bearing_words(double bearing) {
  const double size = std::abs(degrees(bearing));
  if (size < 0.5) return "dead ahead";
  if (size > 179.5) return "dead astern";
  return fmt::format("{:.0f} deg to {}", size, bearing > 0.0 ? "starboard" : "port");
}

std::string deviation_words(const Deviation& deviation, const Vec3& commanded) {
  if (deviation.size < least_difference) return "keeps to the velocity it prefers";
  const double speed = commanded.norm();
  if (speed < least_speed && deviation.speed < -least_speed) return "stops";
  if (deviation.astern) return fmt::format("goes astern at {:.2f} m/s", speed);
  std::vector<std::string> parts;
  // what goes nearly straight up or down has a course, but nobody would call it a turn
  const bool has_way = horizontal_norm(commanded) >= least_share_of_way * speed;
  if (has_way && deviation.turn && std::abs(*deviation.turn) >= least_turn) {
    parts.push_back(fmt::format("turns {:.0f} deg to {}", std::abs(degrees(*deviation.turn)),
                                *deviation.turn > 0.0 ? "starboard" : "port"));
  }
  if (std::abs(deviation.speed) >= least_speed) {
    parts.push_back(fmt::format("{} by {:.2f} m/s to {:.2f} m/s",
                                deviation.speed < 0.0 ? "slows down" : "speeds up", std::abs(deviation.speed),
                                speed));
  }
  if (std::abs(deviation.climb) >= least_speed) {
    parts.push_back(fmt::format("goes {:.2f} m/s more {}", std::abs(deviation.climb),
                                deviation.climb > 0.0 ? "upwards" : "downwards"));
  }
  if (parts.empty()) {
    return fmt::format("hardly leaves the velocity it prefers, by {:.1g} m/s", deviation.size);
  }
  std::string all = parts.front();
  for (std::size_t i = 1; i < parts.size(); ++i) all += (i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return all;
}

std::string headline_of(const Scenario& scenario, const FoundDecision& found, const DecisionFacts& facts,
                        std::span<const StrokeFacts> strokes) {
  const Command& command = found.decision->command();
  std::string what = deviation_words(facts.deviation, command.velocity);
  if (command.mode == Mode::hold) what = "waits on purpose";
  if (command.mode == Mode::infeasible) what = "finds no safe velocity and " + what;
  return fmt::format("{} {}{}.{}", scenario.vehicles[found.instant.vehicle].name, what,
                     reason_words(scenario, found, facts, strokes), progress_words(scenario, found.progress));
}

std::string headline_of_unasked(const Scenario& scenario, const FoundDecision& found) {
  const VehicleSpec& vehicle = scenario.vehicles[found.instant.vehicle];
  const auto sentence = [&](std::string_view who) {
    return fmt::format("{} asks no avoider: {}.", vehicle.name, who);
  };
  if (found.time < vehicle.start_delay_s) {
    return sentence(fmt::format("its mission begins at {}, and until then it holds its position",
                                time_words(vehicle.start_delay_s)));
  }
  if (!found.leg) return sentence("its mission is done, and it holds its position");
  switch (found.leg->kind) {
    case LegKind::go_to:
      return sentence("guidance steers it straight to " + place_words(found.leg->position));
    case LegKind::section:
      return sentence("guidance steers it along the line from " + place_words(found.leg->from) + " to " +
                      place_words(found.leg->position));
    case LegKind::rendezvous:
      return sentence("it holds its position at a rendezvous until everyone has come to theirs");
    case LegKind::keep_position:
    case LegKind::transit:
      break;
  }
  return sentence("its mission has it hold its position");
}

}  // namespace fairway
