// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "fairway/scenario/parts.hpp"
#include "fairway/scenario/tagged.hpp"

namespace fairway::yaml {
namespace {

void check_arrival(const Value& leg, const Leg&) {
  const bool both = leg.tree().find("box_m") != nullptr && leg.tree().find("arrival_m") != nullptr;
  if (both) leg.refuse("box_m and arrival_m both say when the leg is done; keep one");
}

/// The distance of arrival is written where there is no box.
Key<Leg> arrival() {
  Key<Leg> entry = key("arrival_m", &Leg::arrival_m, number(from_to(0.0, 1e6)),
                       "The leg is done this near the goal. Default {}.");
  entry.write = [write = entry.write](const Leg& leg) {
    return leg.box_m.isZero(0.0) ? write(leg) : std::nullopt;
  };
  return entry;
}

const Kinds<Leg>& leg_kinds() {
  static const auto position =
      key("position_m", &Leg::position, vector(anywhere), "The goal [n, e, d].", Needed::yes);
  static const auto speed =
      key("speed_mps", &Leg::speed_mps, number(above_to(0.0, 100.0)), "Along the leg. Default {}.");
  static const auto box = key("box_m", &Leg::box_m, unless(Vec3::Zero(), vector(from_to(0.0, 1e6))),
                              "The leg is done when the error is at most this along n, e and d.");
  static const Kinds<Leg> table{
      {"go_to",
       "Drive to a place by line of sight; nobody is avoided.",
       {position, speed, box, arrival()},
       check_arrival},
      {"keep_position",
       "Hold where the leg began.",
       {key("duration_s", &Leg::duration_s, number(from_to(0.0, 1e7)), "For how long.", Needed::yes)},
       {}},
      {"section",
       "Follow a straight line.",
       {key("from_m", &Leg::from, vector(anywhere), "Where the line begins [n, e, d].", Needed::yes),
        key("to_m", &Leg::position, vector(anywhere), "Where it ends [n, e, d].", Needed::yes), speed, box,
        arrival()},
       check_arrival},
      {"rendezvous",
       "Hold until every vehicle has come to its own rendezvous.",
       {key("agreed", &Leg::agreed, unless(false, flag()),
            "And until the vehicle's method sets out, if it is one that speaks.")},
       {}},
      {"transit", "Go to a place under the vehicle's avoider.", {position, speed, arrival()}, {}},
  };
  return table;
}

/// The mission that an item `{run: name}` names, or nothing if the item is a leg.
const std::string* run_target(const Value& item) {
  const Tree* target = item.tree().find("run");
  if (target == nullptr) return nullptr;
  if (item.tree().items.size() != 1) item.refuse("run stands alone: write {run: name}");
  if (!target->is_scalar() || target->text.empty()) item.entry(0).expected("the name of a mission");
  return &target->text;
}

const Tree& named_mission(const Value& item, const std::string& name) {
  const auto& missions = item.reading().missions;
  const auto found = missions.find(name);
  if (found != missions.end()) return *found->second;
  // sorted, so that the suggestion does not depend on the order of a hash table
  std::vector<std::string_view> known;
  for (const auto& [mission, tree] : missions) known.push_back(mission);
  std::ranges::sort(known);
  known.resize(std::min<std::size_t>(known.size(), 100));
  item.entry(0).refuse("no mission is named " + shown(name) +
                       suggestion(std::string_view(name).substr(0, 64), known));
}

/// Appends the legs of a list. `path` is that of the vehicle's mission, in which every leg counts
/// where it ends up.
void append_legs(const Value& list, const std::string& path, std::vector<Leg>& legs, std::size_t depth = 0) {
  list.expect_list("legs");
  if (depth > max_tree_depth)
    list.refuse(fmt::format("missions run one another more than {} deep", max_tree_depth));
  Reading& reading = list.reading();
  for (std::size_t i = 0; i < list.tree().items.size(); ++i) {
    const Value item = list.entry(i);
    if (reading.steps_left-- == 0) {
      reading.steps_left = 0;
      item.refuse("the missions of all vehicles have too many legs");
    }
    if (const std::string* name = run_target(item)) {
      append_legs({named_mission(item, *name), "missions." + *name, reading}, path, legs, depth + 1);
    } else {
      legs.push_back(
          read_tagged(Value{item.tree(), fmt::format("{}[{}]", path, legs.size()), reading}, leg_kinds()));
    }
  }
}

void append_places(const Value& list, std::vector<Location>& places) {
  for (std::size_t i = 0; i < list.tree().items.size(); ++i) {
    const Value item = list.entry(i);
    if (const std::string* name = run_target(item)) {
      append_places({named_mission(item, *name), "missions." + *name, list.reading()}, places);
    } else {
      places.push_back(item.tree().where.location());
    }
  }
}

/// Depth first over `{run: …}`. The way down may be as long as there are missions, so it is kept in a
/// vector and not on the call stack.
void refuse_cycles(const Value& missions) {
  const Tree& tree = missions.tree();
  std::unordered_map<std::string_view, std::size_t> index;
  for (std::size_t i = 0; i < tree.keys.size(); ++i) index.emplace(tree.keys[i], i);

  enum class Mark { fresh, open, done };
  std::vector<Mark> marks(tree.items.size(), Mark::fresh);
  struct Step {
    std::size_t mission;
    std::size_t item;
  };
  for (std::size_t first = 0; first < tree.items.size(); ++first) {
    std::vector<Step> way;
    if (marks[first] == Mark::fresh) way.push_back({first, 0});
    while (!way.empty()) {
      const std::size_t mission = way.back().mission;
      const std::size_t i = way.back().item++;
      marks[mission] = Mark::open;
      if (i >= tree.items[mission].items.size()) {
        marks[mission] = Mark::done;
        way.pop_back();
        continue;
      }
      const Value item = missions.entry(mission).entry(i);
      const std::string* name = run_target(item);
      if (name == nullptr) continue;
      const std::size_t target = index.at(*name);
      if (marks[target] == Mark::fresh) way.push_back({target, 0});
      if (marks[target] != Mark::open) continue;

      const auto begin = std::ranges::find(way, target, &Step::mission);
      std::string cycle;
      for (auto step = begin; step != way.end(); ++step) {
        if (step - begin < 20) cycle += shown(tree.keys[step->mission]) + " -> ";
        if (step - begin == 20) cycle += "... -> ";
      }
      item.entry(0).refuse("missions run each other without end: " + cycle + shown(*name));
    }
  }
}

}  // namespace

void check_missions(const Value& missions) {
  missions.expect_map("a list of legs for each name");
  for (std::size_t m = 0; m < missions.tree().items.size(); ++m) {
    const Value list = missions.entry(m);
    list.expect_list("legs");
    for (std::size_t i = 0; i < list.tree().items.size(); ++i) {
      const Value item = list.entry(i);
      if (const std::string* name = run_target(item)) {
        named_mission(item, *name);
      } else {
        read_tagged(item, leg_kinds());
      }
    }
  }
  refuse_cycles(missions);
}

Form<std::vector<Leg>> mission() {
  std::vector<Tree> items = tagged_schemas(leg_kinds());
  items.push_back(detail::object_schema(
      {{"run", detail::described(name().schema, "A named mission, spliced in.")}}, {"run"}));
  return {.read =
              [](const Value& value) {
                std::vector<Leg> legs;
                append_legs(value, value.path(), legs);
                return legs;
              },
          .write = [](const std::vector<Leg>& legs) -> std::optional<Tree> {
            if (legs.empty()) return {};
            Tree list = Tree::list();
            for (const Leg& leg : legs) list.items.push_back(write_tagged(leg, leg_kinds()));
            return list;
          },
          .schema = Tree::map({{"type", Tree::quote("array")},
                               {"items", Tree::map({{"oneOf", Tree::list(std::move(items))}})}})};
}

std::vector<Location> places_of_legs(const Value& mission) {
  std::vector<Location> places;
  append_places(mission, places);
  return places;
}

Tree missions_schema() {
  return Tree::map({{"type", Tree::quote("object")}, {"additionalProperties", mission().schema}});
}

}  // namespace fairway::yaml
