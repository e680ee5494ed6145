// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/parts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/scenario/fleet.hpp"

namespace fairway::yaml {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What every kind of perception has.
Block<PerceptionSpec> perception_ranges() {
  constexpr Bounds range = above_to(0.0, 1e7);
  return {key("range_m", &PerceptionSpec::range_m, unless(infinity, number(range)),
              "Nobody farther away is perceived. Default: no such limit."),
          key("obstacle_range_m", &PerceptionSpec::obstacle_range_m, unless(infinity, number(range)),
              "An obstacle that is not charted, or drifts, is perceived this near to the vehicle's sphere. "
              "Default: no such limit.")};
}

Form<PerceptionSpec> perception() {
  const Block<PerceptionSpec> ranges = perception_ranges();
  const std::vector<std::string_view> names{"range_m", "obstacle_range_m"};
  Tree schema = choice("kind", Needed::yes).schema;
  Tree* properties = schema.find("anyOf")->items[1].find("properties");
  for (const Key<PerceptionSpec>& range : ranges)
    properties->set(range.name, detail::described(range.schema, range.meaning));

  return {.read =
              [ranges, names](const Value& value) {
                PerceptionSpec spec{.kind = read_choice(value, "kind", Needed::no, names)};
                if (spec.kind.name.empty()) spec.kind.name = "perfect";
                for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
                  const std::string& key = value.tree().keys[i];
                  const auto named = [&](const Key<PerceptionSpec>& range) { return range.name == key; };
                  const auto range = std::ranges::find_if(ranges, named);
                  if (range != ranges.end()) range->read(value.entry(i), spec);
                  const bool slip = range == ranges.end() && (key == "range" || key.starts_with("range_"));
                  if (slip) value.refuse_key(i, "unknown key; did you mean range_m?");
                }
                return spec;
              },
          .write = [ranges](const PerceptionSpec& spec) -> std::optional<Tree> {
            Tree tree = write_choice(spec.kind, "kind");
            const std::optional<Tree> given = write_block(ranges, spec);
            if (!given) return tree;
            if (!tree.is_map()) tree = Tree::map({{"kind", Tree::quote(spec.kind.name)}});
            for (std::size_t i = 0; i < given->keys.size(); ++i) tree.set(given->keys[i], given->items[i]);
            return tree;
          },
          .schema = std::move(schema)};
}

Block<Exam> exam_block() {
  return {key("crit_dist_m", &Exam::crit_dist_m, number(from_to(0.0, 1e6)),
              "A neighbour this near is detected. Default {}."),
          key("safety_distance_m", &Exam::safety_distance_m, number(from_to(0.0, 1e6)),
              "Centres this near have collided. Default {}."),
          key("time_coefficient_ratio", &Exam::time_coefficient_ratio, number(above_to(0.0, 1e6)),
              "Stuck after this many times the time of the straight way. Default {}."),
          key("progress_window_s", &Exam::progress_window_s, number(above_to(0.0, 1e6)),
              "Whoever comes neither nearer to its goal nor to a new place for so long makes no progress. "
              "Default {}.")};
}

/// A collision is looked for among those who are detected.
Form<Exam> exam_form() {
  Form<Exam> form = block_form(exam_block());
  form.read = [read = form.read](const Value& value) {
    const Exam exam = read(value);
    if (exam.crit_dist_m < exam.safety_distance_m)
      value.refuse(
          fmt::format("crit_dist_m is {:g} and safety_distance_m {:g}: who is not detected does not "
                      "collide; expected the first to be no less",
                      exam.crit_dist_m, exam.safety_distance_m));
    return exam;
  };
  return form;
}

/// The version of this format. It stands in the file and not in the Scenario.
Key<Scenario> format_version() {
  return {.name = "fairway",
          .meaning = "The version of this format.",
          .needed = Needed::yes,
          .read =
              [](const Value& value, Scenario&) {
                if (!value.tree().is_scalar() || value.tree().text != "1")
                  value.expected("the format's version, 1");
              },
          .write = [](const Scenario&) -> std::optional<Tree> { return Tree::word("1"); },
          .schema = Tree::map({{"const", Tree::word("1")}})};
}

/// Whether it is short enough is seen by whoever knows the vehicles.
Key<Scenario> step() {
  Key<Scenario> entry = key("step_s", &Scenario::step_s, number(from_to(1e-5, 1.0)),
                            "The control period and integration step, short enough for every vehicle's "
                            "fastest motion. Default {}.");
  entry.read = [read = entry.read](const Value& value, Scenario& scenario) {
    read(value, scenario);
    scenario.step_where = value.tree().where.location();
  };
  return entry;
}

Key<Scenario> missions() {
  return {.name = "missions",
          .meaning = "Missions by name, to be shared with {run: name}.",
          .read = [](const Value& value, Scenario&) { check_missions(value); },
          .write = [](const Scenario&) -> std::optional<Tree> { return {}; },
          .schema = missions_schema()};
}

/// Read as a vehicle of which nothing is missing, so that a slip is found even if every vehicle says
/// better; what it says has by then been copied to the vehicles.
Key<Scenario> defaults() {
  const Form<VehicleSpec> form = vehicle();
  return {.name = "defaults",
          .meaning = "Any keys of a vehicle, for the vehicles that do not say.",
          .read =
              [read = form.read](const Value& value, Scenario&) {
                Reading partial = value.reading();
                partial.partial = true;
                read(Value{value.tree(), value.path(), partial});
              },
          .write = [](const Scenario&) -> std::optional<Tree> { return {}; },
          .schema = form.schema};
}

Key<Scenario> vehicles() {
  Key<Scenario> entry =
      key("vehicles", &Scenario::vehicles, list_of(vehicle(), "vehicles"), "Who takes part.", Needed::yes);
  entry.read = [form = vehicle()](const Value& value, Scenario& scenario) {
    value.expect_list("vehicles");
    const std::size_t count = value.tree().items.size();
    if (count == 0 || count > max_vehicles) {
      const std::string given = count == 0 ? "zero" : std::to_string(count);
      value.refuse(fmt::format("{} vehicles; a scenario has 1 to {}", given, max_vehicles));
    }
    scenario.vehicles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) scenario.vehicles.push_back(form.read(value.entry(i)));
  };
  entry.schema.set("minItems", Tree::word("1"));
  entry.schema.set("maxItems", Tree::word(std::to_string(max_vehicles)));
  return entry;
}

Expectation read_expectation(const Value& value, const std::string& metric) {
  constexpr Bounds any = from_to(-1e300, 1e300);
  Expectation expected{.metric = metric, .where = value.tree().where.location()};
  if (value.tree().is_scalar()) {
    expected.min = expected.max = value.number(any);
    return expected;
  }
  if (!value.tree().is_map() || value.tree().items.empty()) value.expected("a number, or {min: …, max: …}");
  detail::check_keys(value, {"min", "max"}, {});
  for (std::size_t i = 0; i < value.tree().keys.size(); ++i) {
    const Value bound = value.entry(i);
    if (bound.tree().is_map()) bound.expected("a number");
    (value.tree().keys[i] == "min" ? expected.min : expected.max) = bound.number(any);
  }
  if (expected.min > expected.max) value.refuse("min is above max");
  return expected;
}

}  // namespace

Form<std::vector<Expectation>> expectations() {
  Tree number = Tree::map({{"type", Tree::quote("number")}});
  Tree bounds = detail::object_schema({{"min", number}, {"max", number}}, {});
  bounds.set("minProperties", Tree::word("1"));
  return {.read =
              [](const Value& value) {
                value.expect_map("a number or {min: …, max: …} for each metric");
                std::vector<Expectation> list;
                for (std::size_t i = 0; i < value.tree().items.size(); ++i) {
                  list.push_back(read_expectation(value.entry(i), value.tree().keys[i]));
                }
                return list;
              },
          .write = [](const std::vector<Expectation>& list) -> std::optional<Tree> {
            Tree map = Tree::map();
            for (const Expectation& e : list) {
              if (e.min == e.max) {
                map.set(e.metric, Tree::number(e.min));
                continue;
              }
              Tree range = Tree::map();
              if (e.min != -infinity) range.set("min", Tree::number(e.min));
              if (e.max != infinity) range.set("max", Tree::number(e.max));
              if (!range.items.empty()) map.set(e.metric, std::move(range));
            }
            if (map.items.empty()) return {};
            return map;
          },
          .schema = Tree::map(
              {{"type", Tree::quote("object")},
               {"additionalProperties", Tree::map({{"anyOf", Tree::list({number, std::move(bounds)})}})}})};
}

std::uint64_t seed_of(const Tree& document, std::optional<std::uint64_t> given) {
  if (given) return *given;
  const Tree* written = document.is_map() ? document.find("seed") : nullptr;
  if (written == nullptr) return Scenario{}.seed;
  Reading reading{0};
  return Value{*written, "seed", reading}.whole<std::uint64_t>();
}

const Block<Scenario>& scenario_block() {
  static const Block<Scenario> block{
      format_version(),
      key("name", &Scenario::name, name(), "As in the file's name.", Needed::yes),
      key("summary", &Scenario::summary, text(), "One line about it."),
      step(),
      key("steps_per_decision_count", &Scenario::steps_per_decision, integer(1, 10000),
          "Avoiders decide at every so many steps. Default {}."),
      key("duration_s", &Scenario::duration_s, number(above_to(0.0, 1e7)),
          "The run ends here at the latest. Default {}."),
      key("seed", &Scenario::seed, seed(), "Of everything that is drawn. Default {}."),
      key("water", &Scenario::water, water(), "The water."),
      key("exam", &Scenario::exam, exam_form(), "How encounters are counted."),
      key("perception", &Scenario::perception, perception(),
          "What a vehicle makes of what is round it: perfect, or sonar. Default: perfect."),
      key("exchange", &Scenario::exchange, choice_unless("perfect", "kind"),
          "What vehicles tell each other, and when: perfect, none, or acoustic. Default: perfect."),
      key("navigation", &Scenario::navigation, choice_unless("perfect", "kind"),
          "How well vehicles know where they are: perfect, or drifting. Default: perfect."),
      key("coincident_start", &Scenario::coincident_start, flag(),
          "Vehicles may start at one place. Default {}."),
      key("stop_when_done", &Scenario::stop_when_done, flag(),
          "End when everyone has arrived or is stuck. Default {}."),
      key("obstacles", &Scenario::obstacles, list_of(obstacle(), "obstacles"),
          "What is solid. Nothing here reacts to anyone."),
      missions(),
      defaults(),
      vehicles(),
      fleet(),
      key("expect", &Scenario::expect, expectations(), "Bounds that a run must keep, by metric."),
  };
  return block;
}

}  // namespace fairway::yaml
