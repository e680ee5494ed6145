// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fairway/core/angles.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/testing/refusal.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {
namespace {

using testing::HasSubstr;

/// A document whose water is `water`, from column 8 of line 3.
std::string document(const std::string& water) {
  return "fairway: 1\nname: a\nwater: " + water +
         "\nvehicles: [{model: m, avoider: direct, start: {position_m: [0, 0, 0]}}]\n";
}

WaterSpec water_of(const std::string& water) { return parse_scenario(document(water), "f.yaml").water; }

std::string water_refusal(const std::string& water) {
  return refusal_by([&] { water_of(water); });
}

TEST(WaterTest, WavesOneByOneArriveWithTheirDirectionInAnySpelling) {
  const WaterSpec spec = water_of(
      "{waves: [{amplitude_m: 0.06, period_s: 12.6, direction: [-1.0, 0.0]}, {amplitude_m: 0.04, period_s: "
      "3.7, direction: [-0.7, 0.7], phase_deg: 90}, {amplitude_m: 0.03, period_s: 6.3, direction_deg: 45}, "
      "{amplitude_m: 0.03, period_s: 6.3, direction_rad: 0.1, phase_rad: 0.2}]}");
  ASSERT_EQ(spec.waves.components.size(), 4U);
  EXPECT_FALSE(spec.waves.spectrum);
  const auto& w = spec.waves.components;
  EXPECT_EQ(w[0].amplitude_m, 0.06);
  EXPECT_EQ(w[0].period_s, 12.6);
  EXPECT_EQ(w[0].direction_rad, pi);
  EXPECT_EQ(w[0].phase_rad, 0.0);
  EXPECT_NEAR(w[1].direction_rad, radians(135), 1e-15) << "of any length";
  EXPECT_EQ(w[1].phase_rad, radians(90));
  EXPECT_EQ(w[2].direction_rad, radians(45));
  EXPECT_EQ(w[3].direction_rad, 0.1);
  EXPECT_EQ(w[3].phase_rad, 0.2);
}

TEST(WaterTest, ASpectrumArrivesWithItsDefaults) {
  const WaterSpec spec = water_of(
      "{waves: {spectrum: jonswap, significant_height_m: 0.5, peak_period_s: {uniform: [3, 5]}, "
      "peakedness_ratio: 0, direction_deg: 30, spreading_count: 2, components_count: 70}}");
  ASSERT_TRUE(spec.waves.spectrum);
  EXPECT_EQ(spec.waves.spectrum->spectrum, SpectrumKind::jonswap);
  EXPECT_EQ(spec.waves.spectrum->significant_height_m, 0.5);
  EXPECT_EQ(spec.waves.spectrum->peak_period_s, Rng{1}.stream("water.waves.peak_period_s").uniform(3, 5));
  EXPECT_EQ(spec.waves.spectrum->peakedness_ratio, 0.0);
  EXPECT_EQ(spec.waves.spectrum->direction_rad, radians(30));
  EXPECT_EQ(spec.waves.spectrum->spreading_count, 2);
  EXPECT_EQ(spec.waves.spectrum->components_count, 70);

  const WaterSpec least =
      water_of("{waves: {spectrum: pierson_moskowitz, significant_height_m: 0.5, peak_period_s: 4}}");
  EXPECT_EQ(least.waves.spectrum->spectrum, SpectrumKind::pierson_moskowitz);
  EXPECT_EQ(least.waves.spectrum->spreading_count, 0);
  EXPECT_EQ(least.waves.spectrum->components_count, 50);
}

TEST(WaterTest, CurrentsThatChangeArrive) {
  const WaterSpec spec = water_of(
      "{current: {sheared: {direction: [0, 2], profile: [{depth_m: 0, speed_mps: 0.5}, {depth_m: 20, "
      "speed_mps: -0.1}]}, gauss_markov: {mean_speed_mps: 0.3, deviation_mps: 0.1, correlation_time_s: 60, "
      "min_speed_mps: 0.1, max_speed_mps: 0.6, direction_deg: 45, direction_deviation_deg: 10, "
      "direction_correlation_time_s: 500}}}");
  ASSERT_TRUE(spec.current.sheared && spec.current.gauss_markov);
  EXPECT_EQ(spec.current.sheared->direction_rad, pi / 2);
  ASSERT_EQ(spec.current.sheared->profile.size(), 2U);
  EXPECT_EQ(spec.current.sheared->profile[1].depth_m, 20.0);
  EXPECT_EQ(spec.current.sheared->profile[1].speed_mps, -0.1);
  const GaussMarkovCurrentSpec& wandering = *spec.current.gauss_markov;
  EXPECT_EQ(wandering.mean_speed_mps, 0.3);
  EXPECT_EQ(wandering.deviation_mps, 0.1);
  EXPECT_EQ(wandering.correlation_time_s, 60.0);
  EXPECT_EQ(wandering.min_speed_mps, 0.1);
  EXPECT_EQ(wandering.max_speed_mps, 0.6);
  EXPECT_EQ(wandering.direction_rad, radians(45));
  EXPECT_EQ(wandering.direction_deviation_rad, radians(10));
  EXPECT_EQ(wandering.direction_correlation_time_s, 500.0);
}

TEST(WaterTest, CalmWaterSaysNothingOfWaves) {
  const WaterSpec spec = water_of("{density_kgpm3: 1025}");
  EXPECT_TRUE(spec.waves.calm());
  EXPECT_TRUE(spec.current.none());
  EXPECT_TRUE(water_of("{waves: [], current: {}}").waves.calm());
}

TEST(WaterTest, WhatIsReadIsWrittenAndReadAgainToTheSameBits) {
  for (const std::string text :
       {"{waves: [{amplitude_m: 0.1, period_s: 3.7, direction: [-0.7, 0.7], phase_deg: 33.3}, {amplitude_m: "
        "0.2, period_s: 4, direction: [0.3, -0.1]}]}",
        "{waves: {spectrum: jonswap, significant_height_m: 0.5, peak_period_s: {normal: [4, 0.3]}, "
        "direction: [1, 3], spreading_count: 3}, current: {gauss_markov: {mean_speed_mps: 0.3, "
        "deviation_mps: 0.1, direction_rad: 0.1, direction_deviation_deg: 7}}}",
        "{waves: {spectrum: pierson_moskowitz, significant_height_m: 0.5, peak_period_s: 4}, current: "
        "{sheared: {profile: [{depth_m: 0, speed_mps: {uniform: [0, 1]}}, {depth_m: 9, speed_mps: 0}]}}}"}) {
    const std::string yaml = to_yaml(parse_scenario(document(text), "f.yaml"));
    const Scenario again = parse_scenario(yaml, "written.yaml");
    EXPECT_EQ(to_yaml(again), yaml);
    const WaterSpec first = water_of(text);
    ASSERT_EQ(again.water.waves.components.size(), first.waves.components.size());
    for (std::size_t i = 0; i < first.waves.components.size(); ++i) {
      EXPECT_EQ(again.water.waves.components[i].direction_rad, first.waves.components[i].direction_rad);
      EXPECT_EQ(again.water.waves.components[i].phase_rad, first.waves.components[i].phase_rad);
    }
    ASSERT_EQ(again.water.waves.spectrum.has_value(), first.waves.spectrum.has_value());
    if (first.waves.spectrum) {
      EXPECT_EQ(again.water.waves.spectrum->peak_period_s, first.waves.spectrum->peak_period_s);
      EXPECT_EQ(again.water.waves.spectrum->direction_rad, first.waves.spectrum->direction_rad);
      EXPECT_EQ(again.water.waves.spectrum->spectrum, first.waves.spectrum->spectrum);
    }
    ASSERT_EQ(again.water.current.sheared.has_value(), first.current.sheared.has_value());
    ASSERT_EQ(again.water.current.gauss_markov.has_value(), first.current.gauss_markov.has_value());
    if (first.current.sheared) {
      EXPECT_EQ(again.water.current.sheared->profile[0].speed_mps,
                first.current.sheared->profile[0].speed_mps);
    }
    if (first.current.gauss_markov) {
      EXPECT_EQ(again.water.current.gauss_markov->max_speed_mps, first.current.gauss_markov->max_speed_mps);
    }
  }
}

TEST(WaterTest, BadWavesAreRefusedWithTheirPlace) {
  const std::string wave = "{waves: [{amplitude_m: 0.1, period_s: ";
  EXPECT_EQ(water_refusal(wave + "0}]}"),
            "f.yaml:3:46: water.waves[0].period_s: expected a number in [0.1, 1000], got 0");
  EXPECT_THAT(water_refusal(wave + "-3}]}"),
              HasSubstr("waves[0].period_s: expected a number in [0.1, 1000]"));
  EXPECT_EQ(water_refusal(wave + "3, direction: [0, 0]}]}"),
            "f.yaml:3:60: water.waves[0].direction: [0, 0] points nowhere");
  EXPECT_THAT(water_refusal(wave + "3, direction: [1, 0, 0]}]}"),
              HasSubstr("water.waves[0].direction: expected two numbers [n, e], got a list of 3"));
  EXPECT_THAT(water_refusal(wave + "3, direction: [1, 0], direction_deg: 3}]}"),
              HasSubstr("water.waves[0].direction_deg: given before as direction; keep one"));
  EXPECT_THAT(water_refusal("{waves: [{period_s: 3}]}"),
              HasSubstr("water.waves[0]: the key amplitude_m is missing"));
  EXPECT_THAT(water_refusal("{waves: [{amplitude_m: -1, period_s: 3}]}"),
              HasSubstr("amplitude_m: expected a number in (0, 100], got -1"));
  EXPECT_THAT(water_refusal("{waves: rough}"),
              HasSubstr("water.waves: expected a list of waves, or a mapping of a spectrum, got rough"));
  // 9.81 x 4 / (2 pi) = 6.25 m long, a seventh of it 0.89 m high
  EXPECT_EQ(water_refusal("{waves: [{amplitude_m: 0.44, period_s: 2}]}"), "accepted");
  EXPECT_EQ(water_refusal("{waves: [{amplitude_m: 0.45, period_s: 2}]}"),
            "f.yaml:3:17: water.waves[0]: a wave that is 0.9 m high breaks where it is 6.25 m long, as one "
            "of 2 s is; at most 0.89 m");
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "{amplitude_m: 1, period_s: 3},";
  EXPECT_EQ(water_refusal("{waves: [" + many + "]}"),
            "f.yaml:3:16: water.waves: 1001 waves; at most 1000 are accepted");
}

TEST(WaterTest, BadSpectraAreRefusedWithTheirPlace) {
  const std::string sea = "{waves: {significant_height_m: 1, peak_period_s: 5, spectrum: ";
  EXPECT_EQ(water_refusal(sea + "jonswop}}"),
            "f.yaml:3:70: water.waves.spectrum: unknown spectrum; did you mean jonswap?");
  EXPECT_EQ(water_refusal(sea + "jonswap, peakedness_ratio: 0.5}}"),
            "f.yaml:3:97: water.waves.peakedness_ratio: expected 0 or a number in [1, 7], got 0.5");
  EXPECT_THAT(water_refusal(sea + "jonswap, peakedness_ratio: 8}}"),
              HasSubstr("peakedness_ratio: expected a number in [0, 7], got 8"));
  EXPECT_THAT(water_refusal(sea + "pierson_moskowitz, peakedness_ratio: 3}}"),
              HasSubstr("water.waves.peakedness_ratio: only jonswap has one"));
  EXPECT_THAT(water_refusal(sea + "jonswap, components_count: 1001}}"),
              HasSubstr("components_count: expected a whole number in [1, 1000], got 1001"));
  EXPECT_THAT(water_refusal(sea + "jonswap, spreading_count: -1}}"),
              HasSubstr("spreading_count: expected a whole number in [0, 100], got -1"));
  EXPECT_THAT(water_refusal(sea + "jonswap, direction: [0, 0]}}"), HasSubstr("[0, 0] points nowhere"));
  EXPECT_THAT(water_refusal("{waves: {spectrum: jonswap, significant_height_m: 0, peak_period_s: 5}}"),
              HasSubstr("significant_height_m: expected a number in (0, 100], got 0"));
  EXPECT_THAT(water_refusal("{waves: {spectrum: jonswap, significant_height_m: 1, peak_period_s: 2}}"),
              HasSubstr("water.waves: a wave that is 1 m high breaks where it is 6.25 m long"));
  EXPECT_THAT(water_refusal("{waves: {spectrum: jonswap, significant_height_m: 1}}"),
              HasSubstr("water.waves: the key peak_period_s is missing"));
}

TEST(WaterTest, BadCurrentsAreRefusedWithTheirPlace) {
  const std::string profile = "{current: {sheared: {profile: ";
  EXPECT_EQ(water_refusal(profile + "[{depth_m: 1, speed_mps: 1}]}}}"),
            "f.yaml:3:38: water.current.sheared.profile: a profile needs at least two points, got 1");
  EXPECT_EQ(
      water_refusal(profile + "[{depth_m: 5, speed_mps: 1}, {depth_m: 1, speed_mps: 0}]}}}"),
      "f.yaml:3:67: water.current.sheared.profile[1]: depth_m is 1, not below that of the point before, 5");
  EXPECT_THAT(water_refusal("{current: {sheared: {}}}"),
              HasSubstr("water.current.sheared: the key profile is missing"));

  const std::string wandering = "{current: {gauss_markov: {mean_speed_mps: 0.3, deviation_mps: ";
  EXPECT_THAT(water_refusal(wandering + "-0.1}}}"),
              HasSubstr("current.gauss_markov.deviation_mps: expected a number in [0, 10], got -0.1"));
  EXPECT_EQ(water_refusal(wandering + "0.1, min_speed_mps: 0.5, max_speed_mps: 0.2}}}"),
            "f.yaml:3:33: water.current.gauss_markov: min_speed_mps is above max_speed_mps");
  EXPECT_THAT(water_refusal(wandering + "0.1, max_speed_mps: 0.2}}}"),
              HasSubstr("mean_speed_mps is 0.3, not in [0, 0.2] of min_speed_mps and max_speed_mps"));
  EXPECT_THAT(water_refusal(wandering + "0.1, correlation_time_s: 0}}}"),
              HasSubstr("correlation_time_s: expected a number in (0, 1e+07], got 0"));
  EXPECT_EQ(water_refusal("{current: {gauss_markov: {mean_speed_mps: 5, deviation_mps: 2}}}"),
            "f.yaml:3:33: water.current.gauss_markov: mean_speed_mps and three times deviation_mps come to "
            "11 m/s; expected at most 10, or a max_speed_mps");
  EXPECT_EQ(
      water_refusal("{current: {gauss_markov: {mean_speed_mps: 5, deviation_mps: 2, max_speed_mps: 8}}}"),
      "accepted");
  EXPECT_EQ(water_refusal("{current_mps: [1, 0, 0], current: {}}"),
            "f.yaml:3:33: water.current: given before as current_mps; keep one");
  EXPECT_THAT(water_refusal("{current: [1, 0, 0]}"),
              HasSubstr("water.current: expected a mapping: sheared, gauss_markov, got a list of 3"));
}

}  // namespace
}  // namespace fairway
