// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <fstream>

#include "fairway/core/rng.hpp"
#include "fairway/core/text.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway {
namespace {

/// Numbers that a decimal is most likely to spoil: all magnitudes, few and many digits, zeros of both signs.
double awkward(Rng& rng, double lo, double hi) {
  switch (rng.index(8)) {
    case 0:
      return lo < 0 ? -0.0 : hi;
    case 1:
      return hi * 0x1p-1060;
    case 2:
      return static_cast<double>(static_cast<int>(rng.uniform(lo, hi)) + 1);
    default:
      return rng.uniform(lo, hi) * (lo < 0 ? std::pow(10.0, -static_cast<double>(rng.index(12))) : 1.0);
  }
}

Vec3 somewhere(Rng& rng) {
  return {awkward(rng, -1e5, 1e5), awkward(rng, -1e5, 1e5), awkward(rng, -1e3, 1e3)};
}

std::string word(Rng& rng) {
  static const std::vector<std::string> words{"a",         "orca3d+stop_and_wait",
                                              "5",         "true",
                                              "null",      "~",
                                              "",          " ",
                                              "a: b",      "#x",
                                              "a #b",      "two\nlines",
                                              "tab\there", "\"quoted\"",
                                              "it's",      "- a",
                                              "[x]",       "{x}",
                                              "&a",        "*a",
                                              "!t",        "%d",
                                              "@",         "`",
                                              "nan",       ".inf",
                                              "1e3",       "0x10",
                                              "südlich",   "back\\slash",
                                              "yes",       "<<",
                                              "a:",        "\x01\x7f",
                                              "a ",        "trailing-",
                                              "2.",        "-",
                                              "?",         "|",
                                              ">",         "\r\n"};
  return words[rng.index(words.size())];
}

std::string named(Rng& rng) { return "n" + word(rng); }

Choice choice(Rng& rng, bool may_be_empty) {
  Choice made{.name = may_be_empty && rng.index(2) == 0 ? "" : named(rng)};
  const std::uint64_t count = rng.index(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string key = word(rng) + std::to_string(i);
    switch (rng.index(3)) {
      case 0:
        made.params.emplace_back(key, awkward(rng, -1e9, 1e9));
        break;
      case 1:
        made.params.emplace_back(key, rng.index(2) == 0);
        break;
      default:
        made.params.emplace_back(key, word(rng));
    }
  }
  return made;
}

Leg leg(Rng& rng) {
  Leg made{.kind = static_cast<LegKind>(rng.index(5))};
  const bool line = made.kind == LegKind::section;
  const bool moves = line || made.kind == LegKind::go_to || made.kind == LegKind::transit;
  if (moves) {
    made.position = somewhere(rng);
    made.speed_mps = rng.uniform(0.1, 2.0);
    if (made.kind != LegKind::transit && rng.index(2) == 0) {
      made.box_m = Vec3{rng.uniform(0, 9), rng.uniform(0, 9), 0.0};
    } else {
      made.arrival_m = awkward(rng, 0.0, 20.0);
    }
  }
  if (line) made.from = somewhere(rng);
  if (made.kind == LegKind::keep_position) made.duration_s = awkward(rng, 0.0, 100.0);
  return made;
}

ObstacleSpec obstacle(Rng& rng) {
  ObstacleSpec made{.kind = static_cast<Obstacle::Kind>(rng.index(3))};
  const Vec3 far = Vec3{5e5, 0, 0} + somewhere(rng);
  if (made.kind == Obstacle::Kind::sphere) {
    made.position = far;
    made.radius = rng.uniform(1, 9);
  } else if (made.kind == Obstacle::Kind::segment) {
    made.from = far;
    made.to = far + Vec3{1, 1, 0};
  } else {
    made.vertices = {far, far + Vec3{10, 0, 0}, far + Vec3{10, rng.uniform(1, 9), 0}};
  }
  return made;
}

VehicleSpec vehicle(Rng& rng, std::uint32_t id) {
  VehicleSpec made{.id = id,
                   .name = named(rng) + std::to_string(id),  // its own, as its id is
                   .model = choice(rng, false),
                   .avoider = choice(rng, false),
                   .steering = choice(rng, true)};
  made.tracking = static_cast<Tracking>(rng.index(EnumNames<Tracking>::names.size()));
  made.position = somewhere(rng);
  made.yaw = rng.index(4) == 0 ? radians(rng.uniform(-360, 360)) : rng.uniform(-6.0, 6.0);
  if (rng.index(8) == 0) made.yaw = -0.0;
  made.speed = awkward(rng, -2, 2);
  made.start_delay_s = awkward(rng, 0, 60);
  made.radius_m = awkward(rng, 0, 9);
  made.priority = static_cast<std::int32_t>(rng.next());
  Limits& limits = made.limits;
  if (rng.index(2) == 0) limits.max_speed = awkward(rng, 0, 9);
  if (rng.index(2) == 0) limits.max_climb_rate = awkward(rng, 0, 9);
  if (rng.index(2) == 0) limits.max_acceleration = awkward(rng, 0, 9);
  if (rng.index(2) == 0) limits.max_turn_rate = rng.uniform(0, 9);
  if (rng.index(2) == 0) limits.min_depth = awkward(rng, 0, 9);
  if (rng.index(2) == 0) limits.max_depth = 10.0 + awkward(rng, 0, 9);
  Rng abilities = rng.stream("abilities", id);
  if (abilities.index(2) == 0) limits.min_speed = awkward(abilities, 0, 9);
  limits.sternway = abilities.index(2) == 0;
  limits.sway = abilities.index(2) == 0;
  for (std::uint64_t i = rng.index(5); i > 0; --i) made.mission.push_back(leg(rng));
  return made;
}

Scenario random_scenario(std::uint64_t seed) {
  Rng rng{seed};
  Scenario made{.name = named(rng),
                .summary = word(rng),
                .step_s = rng.uniform(1e-3, 1),
                .duration_s = rng.uniform(1, 1e4),
                .seed = rng.next()};
  made.water.density_kgpm3 = rng.uniform(900, 1100);
  made.water.current_n = Vec3{awkward(rng, -1, 1), awkward(rng, -1, 1), 0.0};
  made.coincident_start = true;
  made.stop_when_done = rng.index(2) == 0;
  const double safety = awkward(rng, 0, 9);
  made.exam = {safety + awkward(rng, 0, 9), safety, rng.uniform(1, 20), rng.uniform(1, 90)};
  made.perception.kind = choice(rng, false);
  if (rng.index(2) == 0) made.perception.range_m = rng.uniform(1, 1e3);
  for (std::uint64_t i = rng.index(4); i > 0; --i) made.obstacles.push_back(obstacle(rng));
  const auto count = static_cast<std::uint32_t>(1 + rng.index(4));
  for (std::uint32_t i = 0; i < count; ++i) made.vehicles.push_back(vehicle(rng, 3 * i));
  for (std::uint64_t i = rng.index(4); i > 0; --i) {
    Expectation expected{.metric = named(rng) + std::to_string(i)};
    if (rng.index(2) == 0) expected.min = awkward(rng, -9, 0);
    if (rng.index(2) == 0) expected.max = awkward(rng, 0.5, 9);
    if (expected.min > expected.max) std::swap(expected.min, expected.max);
    if (std::isinf(expected.min) && std::isinf(expected.max)) expected.min = expected.max = 0.25;
    made.expect.push_back(expected);
  }
  return made;
}

/// Everything in a scenario but where it was written, bit by bit: two scenarios are the same exactly
/// if their dumps are.
class Dump {
 public:
  explicit Dump(const Scenario& s) {
    add(s.name, s.summary, s.step_s, s.duration_s, s.seed, s.water.density_kgpm3, s.water.current_n,
        s.coincident_start, s.stop_when_done, s.exam.crit_dist_m, s.exam.safety_distance_m,
        s.exam.time_coefficient_ratio, s.exam.progress_window_s, s.perception.kind, s.perception.range_m);
    for (const ObstacleSpec& o : s.obstacles) {
      add(static_cast<std::uint64_t>(o.kind), o.position, o.radius, o.from, o.to);
      for (const Vec3& v : o.vertices) add(v);
    }
    for (const VehicleSpec& v : s.vehicles) {
      const Limits& l = v.limits;
      add(std::uint64_t{v.id}, v.name, v.model, v.avoider, static_cast<std::uint64_t>(v.tracking), v.steering,
          v.position, v.yaw, v.speed, v.start_delay_s, v.radius_m, static_cast<std::uint64_t>(v.priority),
          l.max_speed, l.max_climb_rate, l.max_acceleration, l.max_turn_rate, l.min_depth, l.max_depth,
          l.min_speed, std::uint64_t{l.sternway}, std::uint64_t{l.sway});
      for (const Leg& leg : v.mission) {
        add(static_cast<std::uint64_t>(leg.kind), leg.position, leg.from, leg.speed_mps, leg.box_m,
            leg.arrival_m, leg.duration_s);
      }
    }
    for (const Expectation& e : s.expect) add(e.metric, e.min, e.max);
  }
  const std::string& text() const { return text_; }

 private:
  template <class... T>
  void add(const T&... values) {
    (put(values), ...);
    text_ += '\n';
  }
  void put(double value) {
    text_ += number_text(value) + "=" + std::to_string(std::bit_cast<std::uint64_t>(value)) + " ";
  }
  void put(std::uint64_t value) { text_ += std::to_string(value) + " "; }
  void put(bool value) { text_ += value ? "on " : "off "; }
  void put(const std::string& value) { text_ += "<" + value + "> "; }
  void put(const Vec3& v) {
    for (const double c : v) put(c);
  }
  void put(const Choice& c) {
    put(c.name);
    for (const auto& [key, value] : c.params) {
      put(key);
      std::visit([this](const auto& v) { put(v); }, value);
    }
  }

  std::string text_;
};

TEST(WriteTest, AScenarioWrittenAndReadIsTheSameToTheBit) {
  int in_radians = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Scenario scenario = random_scenario(seed);
    const std::string yaml = to_yaml(scenario);
    in_radians += yaml.find("yaw_rad") != std::string::npos ? 1 : 0;
    const Scenario read = parse_scenario(yaml, "random.yaml");
    ASSERT_EQ(Dump(read).text(), Dump(scenario).text()) << "seed " << seed << "\n" << yaml;
    ASSERT_EQ(to_yaml(read), yaml);
  }
  EXPECT_GT(in_radians, 0) << "some angle has no decimal in degrees";
}

TEST(WriteTest, WhatWasReadIsWrittenInDegrees) {
  Rng rng{5};
  for (int i = 0; i < 2000; ++i) {
    const std::string degrees = number_text(rng.uniform(-360, 360));
    const Scenario s = parse_scenario(
        "{fairway: 1, name: a, vehicles: [{model: m, avoider: a, start: {position_m: [0, 0, 0], yaw_deg: " +
            degrees + "}}]}",
        "a");
    const std::string yaml = to_yaml(s);
    ASSERT_NE(yaml.find("yaw_deg"), std::string::npos) << degrees;
    ASSERT_EQ(parse_scenario(yaml, "a").vehicles[0].yaw, s.vehicles[0].yaw);
  }
}

TEST(WriteTest, TheTextIsWhatAPersonWouldWrite) {
  const Scenario s = parse_scenario(
      "{fairway: 1, name: a b, vehicles: [{model: {name: m, mass_kg: 2}, avoider: direct, start: "
      "{position_m: [0, 0.5, 1]}, "
      "limits: {max_speed_mps: 1}, mission: [{transit: {position_m: [1, 2, 3]}}, {rendezvous: {}}]}], "
      "expect: {collision_count: 0}}",
      "a");
  EXPECT_EQ(to_yaml(s), R"(fairway: 1
name: a b
step_s: 0.05
steps_per_decision_count: 1
duration_s: 600
seed: 1
water:
  density_kgpm3: 1000
  current_mps: [0, 0, 0]
exam:
  crit_dist_m: 6
  safety_distance_m: 3
  time_coefficient_ratio: 10
  progress_window_s: 30
perception: perfect
coincident_start: false
stop_when_done: true
vehicles:
  - id: 0
    name: robot0
    model:
      name: m
      mass_kg: 2
    avoider: direct
    start:
      position_m: [0, 0.5, 1]
      yaw_deg: 0
      speed_mps: 0
      delay_s: 0
    radius_m: 1
    priority_count: 0
    limits:
      max_speed_mps: 1
    mission:
      - transit:
          position_m: [1, 2, 3]
          speed_mps: 0.5
          arrival_m: 1
      - rendezvous: {}
expect:
  collision_count: 0
)");
}

std::string contents(const std::string& file) {
  std::ifstream stream{file};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

TEST(SchemaTest, TheCommittedSchemaIsTheOneOfThisCode) {
  const std::string file = FAIRWAY_SOURCE_DIR "/docs/schema/scenario.schema.json";
  if (std::getenv("FAIRWAY_UPDATE") != nullptr) std::ofstream{file} << scenario_schema();
  EXPECT_EQ(contents(file), scenario_schema()) << "run the test once with FAIRWAY_UPDATE=1 to write it";
}

/// JSON is YAML, so the reader can look at its own schema.
TEST(SchemaTest, ItIsWellFormedAndClosed) {
  const yaml::Tree schema = yaml::parse_tree(scenario_schema(), "schema");
  EXPECT_EQ(schema.find("additionalProperties")->text, "false");
  const yaml::Tree& properties = *schema.find("properties");
  for (const std::string key : {"fairway", "name", "vehicles", "fleet", "defaults", "missions", "expect"}) {
    ASSERT_NE(properties.find(key), nullptr) << key;
    EXPECT_NE(properties.find(key)->find("description"), nullptr) << key;
  }
  EXPECT_EQ(schema.find("required")->items.size(), 2U) << "vehicles or a fleet";
  EXPECT_EQ(properties.find("vehicles")->find("items")->find("required"), nullptr) << "defaults may say";
}

TEST(DocumentationTest, EveryExampleOfThePageIsAScenario) {
  const std::string page = contents(FAIRWAY_SOURCE_DIR "/docs/scenarios.md");
  int examples = 0;
  for (std::size_t from = page.find("```yaml\n"); from != std::string::npos;
       from = page.find("```yaml\n", from + 1)) {
    const std::size_t begin = from + 8;
    EXPECT_NO_THROW(parse_scenario(page.substr(begin, page.find("```", begin) - begin), "docs/scenarios.md"));
    ++examples;
  }
  EXPECT_GE(examples, 2);
}

/// A key that is not on the page does not exist for whoever reads it.
TEST(DocumentationTest, EveryKeyIsOnThePage) {
  const std::string page = contents(FAIRWAY_SOURCE_DIR "/docs/scenarios.md");
  std::vector<const yaml::Tree*> open;
  const yaml::Tree schema = yaml::parse_tree(scenario_schema(), "schema");
  open.push_back(&schema);
  while (!open.empty()) {
    const yaml::Tree& tree = *open.back();
    open.pop_back();
    for (const yaml::Tree& item : tree.items) open.push_back(&item);
    if (const yaml::Tree* properties = tree.find("properties");
        properties != nullptr && properties->is_map()) {
      for (const std::string& key : properties->keys) EXPECT_NE(page.find(key), std::string::npos) << key;
    }
  }
}

}  // namespace
}  // namespace fairway
