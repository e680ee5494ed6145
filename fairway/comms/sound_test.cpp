// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/sound.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ctime>

namespace fairway {
namespace {

/// What sound loses to sea water by the formula of Thorp (1967), in the form of Jensen et al., Computational
/// Ocean Acoustics (2011), equation 1.47: about 4 C, pH 8, at 1000 m. [dB/km]
double thorp_absorption(double frequency_khz) {
  const double f2 = frequency_khz * frequency_khz;
  return 3.3e-3 + 0.11 * f2 / (1.0 + f2) + 44.0 * f2 / (4100.0 + f2) + 3.0e-4 * f2;
}

TEST(Sound, AbsorptionIsThatOfFrancoisAndGarrison) {
  // Lurton, An Introduction to Underwater Acoustics (2010): the Mediterranean, 14 C, 38.5 psu, 100 kHz, by
  // depth
  const auto mediterranean = [](double depth) {
    return francois_garrison_absorption(
        100.0, {.temperature_degc = 14.0, .salinity_psu = 38.5, .depth_m = depth, .ph = 8.0});
  };
  EXPECT_NEAR(mediterranean(0.0), 40.0, 0.5);
  EXPECT_NEAR(mediterranean(2000.0), 30.0, 0.5);
  EXPECT_NEAR(mediterranean(6000.0), 16.0, 0.5);
}

TEST(Sound, AbsorptionIsThatOfThorpWhereHisFormulaHolds) {
  // Thorp's is for about 4 C at 1000 m; from 50 kHz on it is a third above the other
  const SeaWater deep{.temperature_degc = 4.0, .salinity_psu = 35.0, .depth_m = 1000.0, .ph = 8.0};
  for (const double frequency : {1.0, 5.0, 10.0, 25.0}) {
    const double thorp = thorp_absorption(frequency);
    EXPECT_NEAR(francois_garrison_absorption(frequency, deep) / thorp, 1.0, 0.2) << frequency << " kHz";
  }
}

TEST(Sound, WaterThatIsWarmerThanTwentyDegreesIsNoOther) {
  // the formula has two branches for the viscosity, which meet within what it claims
  SeaWater below, above;
  below.temperature_degc = 20.0;
  above.temperature_degc = 20.0001;
  EXPECT_NEAR(francois_garrison_absorption(800.0, below) / francois_garrison_absorption(800.0, above), 1.0,
              0.01);
}

TEST(Sound, NoiseFallsByAboutEighteenDecibelsADecade) {
  // Stojanovic (2007): 50 - 18 log10(f / 1 kHz) approximates it without wind
  for (const double frequency : {1.0, 3.0, 10.0, 30.0})
    EXPECT_NEAR(ambient_noise(frequency, 0.5, 0.0), 50.0 - 18.0 * std::log10(frequency), 6.5) << frequency;
  EXPECT_GT(ambient_noise(10.0, 0.5, 10.0), ambient_noise(10.0, 0.5, 0.0) + 10.0);
  EXPECT_NEAR(ambient_noise(500.0, 0.5, 0.0), -15.0 + 20.0 * std::log10(500.0), 1.0) << "heat alone, far up";
}

TEST(Sound, IsLostBySpreadingAndByAbsorption) {
  EXPECT_EQ(transmission_loss(0.1, 2.0, 10.0), 0.0);
  EXPECT_NEAR(transmission_loss(100.0, 2.0, 0.0), 40.0, 1e-12);
  EXPECT_NEAR(transmission_loss(1000.0, 1.5, 5.0), 45.0 + 5.0 * 0.999, 1e-12);
}

TEST(Sound, IsStoppedByWhatComesWithinACentimetreOfItsWay) {
  const Vec3 a{0, 0, 10}, b{100, 0, 10};
  const auto sphere = [](double east, double radius) {
    return Obstacle{.kind = Obstacle::Kind::sphere, .position = {30, east, 10}, .radius = radius};
  };
  EXPECT_TRUE(is_in_shadow(sphere(5.0, 6.0), a, b));
  EXPECT_TRUE(is_in_shadow(sphere(5.0, 4.991), a, b));
  EXPECT_FALSE(is_in_shadow(sphere(5.0, 4.989), a, b));
  EXPECT_FALSE(is_in_shadow(sphere(5.0, 6.0), a, {20, 0, 10})) << "it ends before";

  const Obstacle wall{.kind = Obstacle::Kind::segment, .from = {50, -5, 0}, .to = {50, 5, 20}};
  EXPECT_TRUE(is_in_shadow(wall, a, b));
  EXPECT_FALSE(is_in_shadow(wall, a + Vec3{0, 0, 1}, b + Vec3{0, 0, 1})) << "a thin one, and below it";

  const std::array<Vec3, 3> corners{Vec3{40, -5, 0}, Vec3{60, -5, 0}, Vec3{50, 5, 0}};
  const Obstacle pier{.kind = Obstacle::Kind::polygon, .vertices = corners};
  EXPECT_TRUE(is_in_shadow(pier, a, b));
  EXPECT_TRUE(is_in_shadow(pier, a, {50, 0, 10})) << "it ends inside";
  EXPECT_TRUE(is_in_shadow(pier, a + Vec3{0, 5.009, 0}, b + Vec3{0, 5.009, 0}));
  EXPECT_FALSE(is_in_shadow(pier, a + Vec3{0, 5.011, 0}, b + Vec3{0, 5.011, 0}));
}

TEST(Sound, IsJudgedAsSoonBesideALongWall) {
  // on 5 km of way 2 cm beside it there are 250 000 times 2 cm
  const Obstacle wall{.kind = Obstacle::Kind::segment, .from = {0, 0.02, 10}, .to = {5000, 0.02, 10}};
  const std::clock_t began = std::clock();
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(is_in_shadow(wall, {0, 0, 10}, {5000, 0, 10}));
  EXPECT_LT(std::clock() - began, CLOCKS_PER_SEC) << "one in 10 us takes a hundredth of it";
}

TEST(Sound, PacketsErrAsTheirBitsDo) {
  // one bit in 1e5 errs at 13.35 dB (Proakis, figure 5.4-4); of 512 then 0.51 %
  EXPECT_NEAR(packet_error_ratio(13.35, 1), 1.0e-5, 0.02e-5);
  EXPECT_NEAR(packet_error_ratio(13.35, 512), 5.1e-3, 0.1e-3);
  EXPECT_NEAR(packet_error_ratio(20.0, 512), 512 * 0.5 * std::exp(-50.0), 1e-24)
      << "far below the last place of 1";
  EXPECT_NEAR(packet_error_ratio(-100.0, 1), 0.5, 1e-9) << "a bit of noise alone is right by chance";
  EXPECT_EQ(packet_error_ratio(-100.0, 512), 1.0);
}

}  // namespace
}  // namespace fairway
