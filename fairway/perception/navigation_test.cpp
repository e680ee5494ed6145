// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/navigation.hpp"

#include <gtest/gtest.h>

#include "fairway/core/testing/refusal.hpp"

namespace fairway {
namespace {

VehicleState state() {
  VehicleState x;
  x.p_n = {100, -200, 30};
  x.q_nb = quaternion_of({.roll = 0.1, .pitch = -0.2, .yaw = 2.0});
  x.v_b = {1.0, 0.1, -0.05};
  x.omega_b = {0.01, 0.02, 0.03};
  return x;
}

const ParamValues wandering{{"position_sigma_m", 2.0},  {"position_correlation_s", 50.0},
                            {"heading_sigma_deg", 3.0}, {"heading_correlation_s", 20.0},
                            {"depth_sigma_m", 0.1},     {"velocity_sigma_mps", 0.05}};

TEST(Navigation, PerfectIsTheTruthToTheBit) {
  Navigation navigation{"perfect", {}, Rng{1}};
  const VehicleState x = state();
  const VehicleState believed = navigation.estimate(x, 0.05);
  EXPECT_EQ(believed.p_n, x.p_n);
  EXPECT_EQ(believed.q_nb.coeffs(), x.q_nb.coeffs());
  EXPECT_EQ(believed.v_b, x.v_b);
  EXPECT_EQ(believed.omega_b, x.omega_b);
  EXPECT_EQ(navigation.position_sigma(), 0.0);
  EXPECT_EQ(Navigation("drifting", wandering, Rng{1}).position_sigma(), 2.0);
  EXPECT_EQ(
      Navigation("drifting", {{"position_sigma_m", 2.0}, {"stated_ratio", 0.5}}, Rng{1}).position_sigma(),
      1.0);
}

TEST(Navigation, ErrorsHaveTheirStandardDeviationsFromTheFirstTickOn) {
  const int runs = 2000;
  const VehicleState x = state();
  // after the first tick and after two minutes
  for (const int ticks : {1, 120}) {
    Vec3 place = Vec3::Zero();
    Vec3 speed = Vec3::Zero();
    double heading = 0.0;
    for (int run = 0; run < runs; ++run) {
      Navigation navigation{"drifting", wandering, Rng{1}.stream("run", run)};
      VehicleState believed;
      for (int i = 0; i < ticks; ++i) believed = navigation.estimate(x, 1.0);
      place += (believed.p_n - x.p_n).cwiseAbs2() / runs;
      speed += (believed.v_b - x.v_b).cwiseAbs2() / runs;
      const double off = wrap_angle(yaw_of(believed.q_nb) - yaw_of(x.q_nb));
      heading += off * off / runs;
    }
    // a sample variance errs by sqrt(2 / runs) of itself
    const double error = 4.0 * std::sqrt(2.0 / runs);
    EXPECT_NEAR(place.x() / 4.0, 1.0, error);
    EXPECT_NEAR(place.y() / 4.0, 1.0, error);
    EXPECT_NEAR(place.z() / 0.01, 1.0, error);
    for (const double variance : speed) EXPECT_NEAR(variance / 0.0025, 1.0, error);
    EXPECT_NEAR(heading / (radians(3) * radians(3)), 1.0, error);
  }
}

TEST(Navigation, PositionAndHeadingStayAlikeForTheirCorrelationTimes) {
  const VehicleState x = state();
  const int runs = 2000;
  double place = 0.0;
  double heading = 0.0;
  for (int run = 0; run < runs; ++run) {
    Navigation navigation{"drifting", wandering, Rng{2}.stream("run", run)};
    const VehicleState first = navigation.estimate(x, 1.0);
    VehicleState later = first;
    for (int i = 0; i < 20; ++i) later = navigation.estimate(x, 1.0);
    const auto off = [&](const VehicleState& believed) {
      return wrap_angle(yaw_of(believed.q_nb) - yaw_of(x.q_nb)) / radians(3);
    };
    place += (first.p_n - x.p_n).x() * (later.p_n - x.p_n).x() / 4.0 / runs;
    heading += off(first) * off(later) / runs;
  }
  EXPECT_NEAR(place, std::exp(-20.0 / 50.0), 4.0 / std::sqrt(runs) * 1.2);
  EXPECT_NEAR(heading, std::exp(-20.0 / 20.0), 4.0 / std::sqrt(runs) * 1.1);
}

TEST(Navigation, TheEstimateOfTheCurrentIsOffByABiasThatChangesNoOtherDraw) {
  const Vec3 current{0.3, -0.1, 0.02};
  EXPECT_EQ(Navigation("perfect", {}, Rng{1}).current(current), current);
  EXPECT_EQ(Navigation("drifting", wandering, Rng{1}).current(current), current);
  ParamValues params = wandering;
  params.emplace_back("current_sigma_mps", 0.05);
  Vec3 variance = Vec3::Zero();
  const int runs = 2000;
  for (int run = 0; run < runs; ++run) {
    const Rng rng = Rng{1}.stream("run", run);
    Navigation biased{"drifting", params, rng};
    Navigation plain{"drifting", wandering, rng};
    const Vec3 off = biased.current(current) - current;
    ASSERT_EQ(biased.estimate(state(), 1.0).p_n, plain.estimate(state(), 1.0).p_n);
    ASSERT_EQ(biased.current(current) - current, off) << "constant";
    variance += off.cwiseAbs2() / runs;
  }
  const double error = 4.0 * std::sqrt(2.0 / runs);
  EXPECT_NEAR(variance.x() / 0.0025, 1.0, error);
  EXPECT_NEAR(variance.y() / 0.0025, 1.0, error);
  EXPECT_EQ(variance.z(), 0.0);
}

TEST(Navigation, TheHeadingIsTurnedAboutTheVerticalAndNothingElse) {
  const VehicleState x = state();
  const VehicleState believed = Navigation{"drifting", wandering, Rng{3}}.estimate(x, 0.1);
  const Euler truth = euler_of(x.q_nb);
  const Euler belief = euler_of(believed.q_nb);
  EXPECT_NEAR(belief.roll, truth.roll, 1e-12);
  EXPECT_NEAR(belief.pitch, truth.pitch, 1e-12);
  EXPECT_NE(belief.yaw, truth.yaw);
  EXPECT_NEAR(believed.q_nb.norm(), 1.0, 1e-12);
}

TEST(Navigation, TheStepOfTimeDoesNotChangeTheStatistics) {
  const VehicleState x = state();
  double variance = 0.0;
  const int runs = 500;
  for (int run = 0; run < runs; ++run) {
    Navigation navigation{"drifting", wandering, Rng{4}.stream("run", run)};
    VehicleState believed;
    for (int i = 0; i < 1000; ++i) believed = navigation.estimate(x, 0.001);
    variance += (believed.p_n - x.p_n).head<2>().squaredNorm() / 8.0 / runs;
  }
  EXPECT_NEAR(variance, 1.0, 4.0 / std::sqrt(runs));
}

TEST(Navigation, TheSameSeedGivesTheSameBitsAndACopyGoesOnAlike) {
  const VehicleState x = state();
  Navigation a{"drifting", wandering, Rng{5}};
  Navigation b{"drifting", wandering, Rng{5}};
  Navigation other{"drifting", wandering, Rng{6}};
  EXPECT_EQ(a.estimate(x, 0.1).p_n, b.estimate(x, 0.1).p_n);
  EXPECT_NE(a.estimate(x, 0.1).p_n, other.estimate(x, 0.1).p_n);
  Navigation copy = a;
  EXPECT_EQ(a.estimate(x, 0.1).q_nb.coeffs(), copy.estimate(x, 0.1).q_nb.coeffs());
}

TEST(Navigation, WithoutErrorsDriftingIsTheTruth) {
  const VehicleState x = state();
  Navigation navigation{"drifting",
                        {{"position_sigma_m", 0.0},
                         {"depth_sigma_m", 0.0},
                         {"velocity_sigma_mps", 0.0},
                         {"heading_sigma_deg", 0.0}},
                        Rng{7}};
  const VehicleState believed = navigation.estimate(x, 0.1);
  EXPECT_EQ(believed.p_n, x.p_n);
  EXPECT_EQ(believed.v_b, x.v_b);
  EXPECT_TRUE(believed.q_nb.isApprox(x.q_nb));
}

TEST(Navigation, WhatCannotBeIsRefusedWithOneLine) {
  const auto refusal = [](std::string_view kind, const ParamValues& params) {
    return refusal_by([&] { Navigation{kind, params, Rng{1}}; });
  };
  EXPECT_EQ(refusal("drifting", {{"position_sigma_m", -1.0}}),
            "position_sigma_m: is -1; expected a number in [0, 1000]");
  EXPECT_EQ(refusal("drifting", {{"heading_sigma", 1.0}}),
            "heading_sigma: unknown parameter; did you mean heading_sigma_deg?");
  EXPECT_EQ(refusal("perfect", {{"depth_sigma_m", 1.0}}),
            "depth_sigma_m: perfect navigation takes no parameters");
  EXPECT_EQ(refusal("driftin", {}), "kind: unknown navigation; did you mean drifting?");
}

}  // namespace
}  // namespace fairway
