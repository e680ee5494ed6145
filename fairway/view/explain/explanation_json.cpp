// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "fairway/record/record_kinds.hpp"
#include "fairway/record/word_messages.hpp"
#include "fairway/view/explain/decision_facts.hpp"
#include "fairway/view/explain/explanation.hpp"
#include "fairway/view/explain/headline.hpp"
#include "fairway/view/explain/stroke_facts.hpp"

namespace fairway {
namespace {

using nlohmann::json;

/// To the precision that a reader of the page has a use for.
double readable(double value) { return std::round(value * 1e4) / 1e4; }

json exact(double value) { return std::isfinite(value) ? json(value) : json(); }
json exact(const Vec3& v) { return {exact(v.x()), exact(v.y()), exact(v.z())}; }
json exact(const std::optional<double>& value) { return value ? exact(*value) : json(); }
json exact(const Mat3& m) { return {exact(Vec3(m.row(0))), exact(Vec3(m.row(1))), exact(Vec3(m.row(2)))}; }

template <class Round>
json sections_json(const Explanation& explanation, Round&& round) {
  json sections = json::array();
  for (const ExplanationSection& section : explanation.sections) {
    json table;
    if (!section.table.columns.empty()) {
      json rows = json::array();
      for (const auto& row : section.table.rows) {
        json cells = json::array();
        for (const ExplanationTable::Cell& cell : row) {
          const auto* number = std::get_if<double>(&cell);
          cells.push_back(number != nullptr ? round(*number) : json(std::get<std::string>(cell)));
        }
        rows.push_back(std::move(cells));
      }
      table = {{"columns", section.table.columns}, {"rows", std::move(rows)}};
    }
    sections.push_back({{"title", section.title}, {"lines", section.lines}, {"table", std::move(table)}});
  }
  return sections;
}

template <class T>
json member_json(const T& value) {
  if constexpr (std::same_as<T, Wrench>) {
    return {{"force_n", exact(Vec3(value.template head<3>()))},
            {"moment_nm", exact(Vec3(value.template tail<3>()))}};
  } else if constexpr (detail::Id<T>) {
    return number(value);
  } else if constexpr (std::is_enum_v<T>) {
    return enum_name(value);
  } else if constexpr (std::integral<T> || std::same_as<T, std::string_view>) {
    return value;
  } else {
    return exact(value);
  }
}
template <class T>
json member_json(const std::optional<T>& value) {
  return value ? member_json(*value) : json();
}

/// All members of a record, by their names with units.
template <RecordType R>
json record_json(const R& record) {
  json all;
  for_each_member<R>([&](const auto& m) { all[m.name_with_unit()] = member_json(record.*m.at); });
  return all;
}

json approach_json(const ClosestApproach& approach) {
  return {{"time_s", exact(approach.time)}, {"distance_m", exact(approach.distance)}};
}

json neighbour_json(const Scenario& scenario, const NeighbourFacts& n) {
  json neighbour = record_json(n.track);
  neighbour.update({{"name", track_name(scenario, n.track.id)},
                    {"range_m", exact(n.range)},
                    {"bearing_rad", exact(n.bearing)},
                    {"deeper_m", exact(n.below)},
                    {"closing_mps", exact(n.closing)},
                    {"radii_m", exact(n.radii)},
                    {"closest_approach", approach_json(n.at_present)},
                    {"closest_approach_preferred", approach_json(n.preferred)},
                    {"closest_approach_commanded", approach_json(n.commanded)},
                    {"right_of_way", enum_name(n.precedence)}});
  return neighbour;
}

json obstacle_json(const ObstacleFacts& o) {
  return {{"kind", enum_name(o.kind)},
          {"nearest_m", exact(o.nearest)},
          {"distance_m", exact(o.distance)},
          {"bearing_rad", exact(o.bearing)}};
}

json stroke_json(const Stroke& stroke, const Vec3& preferred, const Vec3& commanded) {
  json points = json::array();
  for (const Vec3& point : stroke.points) points.push_back(exact(point));
  json out{{"kind", enum_name(stroke.kind)}, {"meaning", stroke.meaning}, {"points", std::move(points)}};
  if (stroke.kind == Stroke::Kind::half_space) {
    out["preferred_margin_mps"] = exact(margin_of(stroke, preferred));
    out["commanded_margin_mps"] = exact(margin_of(stroke, commanded));
  } else if (stroke.kind == Stroke::Kind::region) {
    out["contains_preferred"] = contains(stroke, preferred);
    out["contains_commanded"] = contains(stroke, commanded);
  } else if (stroke.kind == Stroke::Kind::sphere) {
    out["radius_m"] = exact(stroke.size);
  } else if (stroke.kind == Stroke::Kind::image) {
    out.update({{"side", stroke.side},
                {"reach_mps", exact(stroke.size)},
                {"yaw_rad", exact(stroke.yaw)},
                {"rgb", stroke.rgb}});
  }
  return out;
}

json decision_json(const Scenario& scenario, const KeptDecision& decision) {
  const Situation& s = decision.situation();
  const Command& command = decision.command();
  const DecisionFacts facts = facts_of(s, command);
  json goal = record_json(s.goal);
  goal.update({{"distance_m", exact(facts.goal_distance)}, {"bearing_rad", exact(facts.goal_bearing)}});
  json neighbours = json::array();
  for (const NeighbourFacts& n : facts.neighbours) neighbours.push_back(neighbour_json(scenario, n));
  json obstacles = json::array();
  for (const ObstacleFacts& o : facts.obstacles) obstacles.push_back(obstacle_json(o));
  json strokes = json::array();
  for (const Stroke& stroke : decision.strokes) {
    strokes.push_back(stroke_json(stroke, facts.preferred, command.velocity));
  }
  return {{"tick", count(decision.tick)},
          {"time_s", exact(s.time)},
          {"period_s", exact(s.period)},
          {"own", record_json(s.own)},
          {"goal", std::move(goal)},
          {"limits", record_json(s.limits)},
          {"preferred_mps", exact(facts.preferred)},
          {"command", record_json(command)},
          {"deviation",
           {{"size_mps", exact(facts.deviation.size)},
            {"faster_mps", exact(facts.deviation.speed)},
            {"upwards_mps", exact(facts.deviation.climb)},
            {"starboard_rad", exact(facts.deviation.turn)}}},
          {"binding", facts.binding},
          {"shortfall", enum_name(facts.shortfall)},
          {"neighbours", std::move(neighbours)},
          {"obstacles", std::move(obstacles)},
          {"strokes", std::move(strokes)}};
}

json word_json(const Scenario& scenario, const FoundWord& word) {
  const VehicleSpec& vehicle = scenario.vehicles[word.from];
  return {{"id", vehicle.id},
          {"name", vehicle.name},
          {"age_s", exact(word.age)},
          {"bytes", hexadecimal(word.speech)},
          {"text", word.text}};
}

json words_json(const Scenario& scenario, const FoundWords& words) {
  json heard = json::array();
  for (const FoundWord& word : words.heard) heard.push_back(word_json(scenario, word));
  return {{"said", words.said ? word_json(scenario, *words.said) : json()}, {"heard", std::move(heard)}};
}

}  // namespace

json page_json(const Explanation& explanation) {
  return {{"vehicle", explanation.vehicle},
          {"time_s", explanation.time},
          {"headline", explanation.headline},
          {"sections", sections_json(explanation, [](double value) { return json(readable(value)); })}};
}

json exact_json(const Scenario& scenario, const FoundDecision& found, const Explanation& explanation) {
  const VehicleSpec& vehicle = scenario.vehicles[found.instant.vehicle];
  json difference;
  if (found.difference) {
    difference = {{"quantity", found.difference->quantity},
                  {"recorded", found.difference->a},
                  {"found", found.difference->b}};
  }
  return {{"scenario", scenario.name},
          {"seed", scenario.seed},
          {"vehicle", {{"index", found.instant.vehicle}, {"id", vehicle.id}, {"name", vehicle.name}}},
          {"avoider", explanation.avoider.empty() ? vehicle.avoider->name : explanation.avoider},
          {"tick", count(found.tick)},
          {"time_s", exact(found.time)},
          {"phase", enum_name(found.phase)},
          {"progress",
           {{"state", enum_name(found.progress.state)},
            {"last_progress_s", exact(found.progress.last_progress)},
            {"since_s", exact(found.progress.since)},
            {"with", found.progress.with ? json(number(*found.progress.with)) : json()}}},
          {"recorded_command_to_the_bit", !found.difference},
          {"difference", std::move(difference)},
          {"headline", explanation.headline},
          {"sections", sections_json(explanation, [](double value) { return exact(value); })},
          {"words", found.words ? words_json(scenario, *found.words) : json()},
          {"decision", found.decision ? decision_json(scenario, *found.decision) : json()}};
}

}  // namespace fairway
