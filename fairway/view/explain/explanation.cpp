// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/explanation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/sim/agent.hpp"
#include "fairway/sim/team.hpp"
#include "fairway/view/explain/decision_facts.hpp"
#include "fairway/view/explain/drawn_section.hpp"
#include "fairway/view/explain/headline.hpp"

namespace fairway {
namespace {

/// Obstacles shown one by one: a wall may be made of hundreds.
constexpr std::size_t most_obstacles = 24;

std::string vector_words(const Vec3& v, std::string_view unit) {
  // no minus before what is zero to the digits shown
  const auto shown = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; };
  return fmt::format("[{:.3f}, {:.3f}, {:.3f}] {}", shown(v.x()), shown(v.y()), shown(v.z()), unit);
}

/// From north over east [deg], as many digits as are shown and less than 360.
double compass(double angle) {
  const double tenths = std::round(10.0 * degrees(angle));
  return (tenths < 0.0 ? tenths + 3600.0 : tenths) / 10.0;
}

/// "0.482 m/s, course 34.0 deg, level ([0.400, 0.270, 0.000] NED)".
std::string velocity_words(const Vec3& v) {
  return fmt::format("{:.3f} m/s, course {:.1f} deg, {} ({})", v.norm(), compass(math::atan2(v.y(), v.x())),
                     std::abs(v.z()) < 5e-4
                         ? "level"
                         : fmt::format("{} at {:.3f} m/s", v.z() > 0.0 ? "down" : "up", std::abs(v.z())),
                     vector_words(v, "NED"));
}

std::string approach_words(const ClosestApproach& approach) {
  if (approach.time == 0.0) return fmt::format("{:.2f} m and drawing apart", approach.distance);
  return fmt::format("{:.2f} m in {:.1f} s", approach.distance, approach.time);
}

ExplanationSection found_section(const FoundDecision& found) {
  ExplanationSection section{"How it was found", {}, {}};
  section.lines.push_back(
      fmt::format("Simulated again until tick {} ({}): {} recorded frames met, the same to the bit.",
                  count(found.tick), time_words(found.time), found.matched));
  if (found.decision && found.decision->tick != found.tick) {
    section.lines.push_back(fmt::format("The decision in force then was made before, at tick {} ({}).",
                                        count(found.decision->tick),
                                        time_words(found.decision->situation().time)));
  }
  if (!found.difference) {
    section.lines.emplace_back("The command found is the recorded command, to the bit.");
  } else {
    const QuantityDifference& d = *found.difference;
    section.lines.push_back(
        fmt::format("NOT the recorded command: {} was recorded as {}, now it is {}.", d.quantity, d.a, d.b));
  }
  return section;
}

ExplanationSection command_section(const KeptDecision& decision, const DecisionFacts& facts) {
  const Command& command = decision.command();
  ExplanationSection section{"Command", {}, {}};
  auto& lines = section.lines;
  lines.push_back(fmt::format("Mode: {}.", enum_name(command.mode)));
  lines.push_back("Commanded: " + velocity_words(command.velocity) + ".");
  lines.push_back("Preferred: " + velocity_words(facts.preferred) + ".");
  lines.push_back(fmt::format("So it {}: a difference of {:.4f} m/s.",
                              deviation_words(facts.deviation, command.velocity), facts.deviation.size));
  if (command.heading)
    lines.push_back(fmt::format("Heading commanded: {:.1f} deg.", compass(wrap_angle(*command.heading))));
  if (command.turn_rate)
    lines.push_back(fmt::format("Turn rate commanded: {:.3f} rad/s.", *command.turn_rate));
  if (command.astern) lines.emplace_back("It may go stern first rather than turn round.");
  if (command.wrench) {
    const Wrench& w = *command.wrench;
    lines.push_back(
        fmt::format("Forces commanded (body): {} and moments {}; the velocity is where they lead.",
                    vector_words(w.head<3>(), "N"), vector_words(w.tail<3>(), "N m")));
  }
  if (!command.note.empty()) lines.push_back(fmt::format("It says: {}.", command.note));
  lines.push_back(facts.binding.empty() ? "No limit binds."
                                        : fmt::format("At its limits: {}.", fmt::join(facts.binding, "; ")));
  if (facts.shortfall != Shortfall::none)
    lines.push_back(fmt::format("Beyond the vehicle: {}.", words_of(facts.shortfall)));
  return section;
}

/// "go slower than 0.94 m/s, go astern, go sideways".
std::string inability_words(const Limits& limits) {
  std::vector<std::string> all;
  if (limits.min_speed > 0.0) all.push_back(fmt::format("go slower than {:.3f} m/s", limits.min_speed));
  if (!limits.sternway) all.emplace_back("go astern");
  if (!limits.sway) all.emplace_back("go sideways");
  return fmt::format("{}", fmt::join(all, ", "));
}

ExplanationSection own_section(const Situation& s, const DecisionFacts& facts) {
  ExplanationSection section{"Own state, as believed on board", {}, {}};
  auto& lines = section.lines;
  lines.push_back(fmt::format("At {}, heading {:.1f} deg.", vector_words(s.own.position, "m NED"),
                              compass(wrap_angle(s.own.yaw))));
  if (s.own.position_sigma > 0.0)
    lines.push_back(
        fmt::format("Its navigation states a standard deviation of {:.2f} m.", s.own.position_sigma));
  lines.push_back("Moving over ground: " + velocity_words(s.own.velocity) + ".");
  lines.push_back(fmt::format("Goal: {}, {:.2f} m away, {}, at {:.2f} m/s.",
                              vector_words(s.goal.position, "m NED"), facts.goal_distance,
                              bearing_words(facts.goal_bearing), s.goal.cruise_speed));
  lines.push_back(fmt::format("Decides every {}; radius {} m; priority {}.", time_words(s.period),
                              number_text(s.own.radius), s.own.priority));
  if (const std::string inability = inability_words(s.limits); !inability.empty())
    lines.push_back(fmt::format("The vehicle cannot {}.", inability));
  return section;
}

/// One line for whoever comes nearest with the command, and one for how many would touch.
void summarise_neighbours(const Scenario& scenario, const DecisionFacts& facts,
                          std::vector<std::string>& lines) {
  const auto touching = [&](ClosestApproach NeighbourFacts::*approach) {
    return std::ranges::count_if(facts.neighbours,
                                 [&](const NeighbourFacts& n) { return (n.*approach).distance < n.radii; });
  };
  lines.push_back(
      fmt::format("{} known. If all kept their velocities, {} would come nearer than both radii; with the "
                  "preferred velocity {}, "
                  "with the commanded one {}.",
                  facts.neighbours.size(), touching(&NeighbourFacts::at_present),
                  touching(&NeighbourFacts::preferred), touching(&NeighbourFacts::commanded)));
  const auto nearest = std::ranges::min_element(
      facts.neighbours, {}, [](const NeighbourFacts& n) { return n.at_present.distance - n.radii; });
  lines.push_back(
      fmt::format("{}: {} as they move now, {} with the preferred velocity, {} with the commanded one.",
                  track_name(scenario, nearest->track.id), approach_words(nearest->at_present),
                  approach_words(nearest->preferred), approach_words(nearest->commanded)));
}

ExplanationSection neighbours_section(const Scenario& scenario, const DecisionFacts& facts) {
  ExplanationSection section{"Neighbours", {}, {}};
  if (facts.neighbours.empty()) {
    section.lines.emplace_back("None is known.");
    return section;
  }
  summarise_neighbours(scenario, facts, section.lines);
  section.table.columns = {"neighbour", "range_m", "bearing_deg", "deeper_m",        "closing_mps",
                           "cpa_m",     "cpa_s",   "radii_m",     "commanded_cpa_m", "commanded_cpa_s",
                           "age_s",     "reacts",  "right_of_way"};
  for (const NeighbourFacts& n : facts.neighbours) {
    section.table.rows.push_back({track_name(scenario, n.track.id), n.range, degrees(n.bearing), n.below,
                                  n.closing, n.at_present.distance, n.at_present.time, n.radii,
                                  n.commanded.distance, n.commanded.time, n.track.age,
                                  n.track.reacts ? "yes" : "no", enum_name(n.precedence)});
  }
  return section;
}

ExplanationSection obstacles_section(const DecisionFacts& facts) {
  ExplanationSection section{"Obstacles", {}, {}};
  section.lines.push_back(fmt::format(
      "{} known, by the nearest point of their surface{}.", facts.obstacles.size(),
      facts.obstacles.size() > most_obstacles ? fmt::format("; the {} nearest", most_obstacles) : ""));
  section.table.columns = {"obstacle", "distance_m", "bearing_deg", "n_m", "e_m", "d_m"};
  for (const ObstacleFacts& o :
       std::span{facts.obstacles}.first(std::min(most_obstacles, facts.obstacles.size()))) {
    section.table.rows.push_back(
        {enum_name(o.kind), o.distance, degrees(o.bearing), o.nearest.x(), o.nearest.y(), o.nearest.z()});
  }
  return section;
}

ExplanationTable::Cell cell_of(const ParamValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* yes = std::get_if<bool>(&value)) return std::string(*yes ? "true" : "false");
  return std::get<std::string>(value);
}

ExplanationSection method_section(const Choice& avoider, const Catalog& avoiders) {
  ExplanationSection section{"Method: " + avoider.name, {}, {}};
  for (const Catalog::Entry* layer : layers_of(avoider.name, avoiders)) {
    const AlgorithmInfo& info = layer->info;
    const std::string_view ignorance = layer->wraps ? "" : ignorance_of(info);
    section.lines.push_back(fmt::format("{}: {}. Source: {}.{}{}", info.name, info.title, info.source,
                                        info.planar ? " It thinks in the horizontal plane." : "",
                                        ignorance.empty() ? "" : fmt::format(" It {}.", ignorance)));
  }
  section.table.columns = {"parameter", "value", "unit", "meaning"};
  for (const ParamInfo& param : params_in_force(avoider, avoiders)) {
    section.table.rows.push_back({param.name, cell_of(param.value), param.unit, param.meaning});
  }
  if (section.table.rows.empty()) section.table.columns.clear();
  return section;
}

/// What its method had said and heard.
ExplanationSection words_section(const Scenario& scenario, const FoundWords& words) {
  ExplanationSection section{"Words", {}, {}};
  section.lines.push_back(
      words.said ? fmt::format("Said last, {} ago: {}.", time_words(words.said->age), words.said->text)
                 : "It has said nothing yet.");
  if (words.heard.empty()) {
    section.lines.emplace_back("It has heard nobody yet.");
    return section;
  }
  section.lines.push_back(
      fmt::format("Heard of {}, the last word of each, with its age since it was said:", words.heard.size()));
  section.table.columns = {"said_by", "age_s", "word"};
  for (const FoundWord& word : words.heard)
    section.table.rows.push_back({scenario.vehicles[word.from].name, word.age, word.text});
  return section;
}

ExplanationSection unasked_section(const FoundDecision& found) {
  ExplanationSection section{"Who steers", {}, {}};
  section.lines.push_back(
      fmt::format("Phase: {}. Avoiders are asked on transits only{}.", enum_name(found.phase),
                  found.words ? "; one that speaks may choose where to stay meanwhile" : ""));
  if (!found.note.empty()) section.lines.push_back(fmt::format("It says: {}.", found.note));
  section.lines.push_back(found.asked
                              ? fmt::format("In this recording its avoider is asked from {} to {}.",
                                            time_words(found.asked->first), time_words(found.asked->second))
                              : "In this recording its avoider is never asked.");
  return section;
}

}  // namespace

std::vector<const Catalog::Entry*> layers_of(std::string_view name, const Catalog& avoiders) {
  std::vector<const Catalog::Entry*> layers;
  for (const std::string_view layer : layer_names(name)) layers.push_back(&avoiders.find(layer));
  return layers;
}

std::vector<ParamInfo> params_in_force(const Choice& avoider, const Catalog& avoiders) {
  std::vector<ParamInfo> params = avoiders.params(avoider.name);
  for (const auto& [name, value] : avoider.params) {
    const auto known = std::ranges::find(params, name, &ParamInfo::name);
    if (known != params.end()) {
      known->value = value;
    } else {  // an item of a list
      params.push_back(
          {.name = name, .unit = "", .type = "", .meaning = "", .value = value, .choices = {}, .items = {}});
    }
  }
  return params;
}

Explanation explain(const Scenario& scenario, const FoundDecision& found, const Catalog& avoiders) {
  Explanation explanation{found.instant.vehicle, found.time, {}, {}};
  auto& sections = explanation.sections;
  if (!found.decision) {
    explanation.headline = headline_of_unasked(scenario, found);
    sections = {unasked_section(found)};
    if (found.words) sections.push_back(words_section(scenario, *found.words));
    sections.push_back(found_section(found));
    return explanation;
  }
  const KeptDecision& decision = *found.decision;
  const Vec3& commanded = decision.command().velocity;
  const DecisionFacts facts = facts_of(decision.situation(), decision.command());
  const std::vector<StrokeFacts> drawn = facts_of(decision.strokes, facts.preferred, commanded);
  explanation.headline = headline_of(scenario, found, facts, drawn);
  sections = {command_section(decision, facts), own_section(decision.situation(), facts),
              neighbours_section(scenario, facts)};
  if (found.words) sections.push_back(words_section(scenario, *found.words));
  if (!facts.obstacles.empty()) sections.push_back(obstacles_section(facts));
  for (ExplanationSection& section : drawn_sections(scenario, drawn, facts.preferred, commanded)) {
    sections.push_back(std::move(section));
  }
  const VehicleSpec& vehicle = scenario.vehicles[found.instant.vehicle];
  Choice avoider = vehicle.avoider;
  avoider.params = avoider_params(vehicle, scenario, avoiders);
  avoider.name = avoider_in_force(vehicle, decision.situation().limits, scenario.obstacles, avoiders);
  explanation.avoider = avoider.name;
  sections.push_back(method_section(avoider, avoiders));
  sections.push_back(found_section(found));
  return explanation;
}

}  // namespace fairway
