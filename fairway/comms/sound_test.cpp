// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/sound.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fairway {
namespace {

TEST(Sound, AbsorptionIsThatOfThorp) {
  // Jensen et al. (2011), equation 1.47, by hand: 0.0033 + 11 / 101 + 4400 / 4200 + 0.03
  EXPECT_NEAR(thorp_absorption(10.0), 1.18983, 1e-5);
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

TEST(Sound, TheTwoFormulasAgreeWhereBothHold) {
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
