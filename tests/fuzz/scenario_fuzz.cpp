// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

/// Reads a scenario; lines "--set path=value" before it are overrides. What is accepted must survive
/// being written and read again. True if it was accepted; only InputError is caught.
bool read_scenario(std::string_view text) {
  Overrides overrides;
  while (text.starts_with("--set ")) {
    const std::string_view line = text.substr(6, text.find('\n') - 6);
    const std::size_t equals = line.find('=');
    overrides.emplace_back(line.substr(0, equals),
                           equals == std::string_view::npos ? "" : line.substr(equals + 1));
    text.remove_prefix(std::min(text.size(), 6 + line.size() + 1));
  }
  Scenario scenario;
  try {
    scenario = parse_scenario(text, "fuzz", overrides);
  } catch (const InputError&) {
    return false;
  }
  const std::string written = to_yaml(scenario);
  if (to_yaml(parse_scenario(written, "written")) != written) __builtin_trap();
  return true;
}

}  // namespace
}  // namespace fairway

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fairway::read_scenario({reinterpret_cast<const char*>(data), size});
  return 0;
}

#ifndef FAIRWAY_LIBFUZZER

#include "tests/fuzz/mutate.hpp"

namespace fairway {
namespace {

const std::vector<std::string> samples{
    R"(fairway: 1
name: all
step_s: 0.1
water: {density_kgpm3: 1025, current_mps: [0.1, {normal: [0, 0.1]}, 0]}
exam: {crit_dist_m: {uniform: [5, 7]}}
perception: {kind: perfect, range_m: 100}
obstacles:
  - sphere: {position_m: [50, 0, 5], radius_m: 2}
  - segment: {from_m: [60, -5, 0], to_m: [60, 5, 0]}
  - polygon: {vertices_m: [[70, 0], [80, 0], [80, 10, 3]]}
missions:
  out: [{transit: {position_m: [20, 0, 5]}}]
  back: [{run: out}, {keep_position: {duration_s: 5}}]
defaults: {model: {name: m, mass_kg: 52}, avoider: orca3d, limits: {max_speed_mps: 0.5}}
vehicles:
  - {id: 4, start: {position_m: [0, 0, 5], yaw_deg: 30}, mission: [{run: back}, {rendezvous: {}}]}
  - start: {position_m: [10, -10, 5], delay_s: 1}
    mission: [{go_to: {position_m: [1, 2, 3], box_m: [1, 1, 1]}}]
expect: {collision_count: 0, makespan_s: {max: 120}}
)",
    R"(fairway: 1
name: rough
water:
  waves: {spectrum: jonswap, significant_height_m: {uniform: [0.1, 1]}, peak_period_s: 4, direction: [1, 1]}
  current:
    sheared: {direction_deg: 90, profile: [{depth_m: 0, speed_mps: 0.2}, {depth_m: 10, speed_mps: 0}]}
    gauss_markov: {mean_speed_mps: 0.1, deviation_mps: 0.05, max_speed_mps: 1, direction_deviation_deg: 20}
vehicles: [{model: m, avoider: a, start: {position_m: [0, 0, 0]}}]
)",
    R"(fairway: 1
name: regular
water: {waves: [{amplitude_m: 0.1, period_s: 4, phase_deg: 90}, {amplitude_m: 1, period_s: 9, direction_deg: 5}]}
vehicles: [{model: m, avoider: a, start: {position_m: [0, 0, 0]}}]
)",
    R"(--set vehicles[*].avoider.time_horizon_s=5
--set exam.crit_dist_m={uniform: [4, 5]}
fairway: 1
name: "two"
vehicles:
- &first {model: a, avoider: b, start: {position_m: [1, 2, 3], yaw_rad: 0.1}}
- {model: a, avoider: {algorithm: b, gain_ratio: .5, on: true}, start: {position_m: [1, 2, 6]}, id: 7}
)",
    "fairway: 1\nname: |\n  long\n  text\nmissions:\n  a: &x\n  - run: b\n  b: [{run: c}]\n  c: "
    "[]\nvehicles: [{model: m, avoider: a, "
    "start: {position_m: &p [0, 0, 0]}, mission: [{section: {from_m: *p, to_m: [1, 1, 1], arrival_m: 2}}, "
    "{run: a}]}]\n"};

// clang-format off
const std::vector<std::string> words{
    "-1", "0", "1e999", "1e-320", ".inf", ".nan", "nan", "-0", "18446744073709551616", "9007199254740993",
    "true", "null", "~", "''", "\"\\x\"", "[", "]", "{", "}", "[[", "{a: ", "- ", "? ", ": ", "&a ", "*a",
    "*x", "*first", "!!str ", "!t ", "|\n", ">-\n", "#", "%YAML 1.2\n", "---\n", "...\n", "\t", "\n",
    "\n  ", "\r\n", "\0", "\xff\xfe", "\xc3\xa9", "\"", "'", ",", "<<: *first", "{uniform: [0, 1]}",
    "{normal: [0, 1e6]}", "{run: back}", "run", "--set vehicles[*].radius_m=1\n", "--set name\n", "[*]",
    "[0]", ".", "radius", "radius_m", "max_speed", "vehicles", "yaw_rad", "{transit: {}}",
    "{polygon: {vertices_m: [[0, 0], [1, 0], [1, 1]]}}", "fairway", "id", "start", "position_m"};
// clang-format on

TEST(ScenarioFuzzTest, NothingButARefusalComesOfBadInput) {
  expect_refusals_alone(samples, words, read_scenario, 20'000, 400);
}

}  // namespace
}  // namespace fairway

#endif
