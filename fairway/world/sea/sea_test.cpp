// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/sea.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <thread>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

WaterSpec regular(double amplitude, double period, double direction = 0.0, double phase = 0.0) {
  WaterSpec spec;
  spec.waves.components = {{amplitude, period, direction, phase}};
  return spec;
}

WaterSpec everything() {
  WaterSpec spec;
  spec.waves.spectrum = SpectrumSpec{
      .significant_height_m = 1.0, .peak_period_s = 4.0, .direction_rad = 0.7, .spreading_count = 2};
  spec.current.sheared = ShearedCurrentSpec{.direction_rad = 1.0, .profile = {{0.0, 0.5}, {20.0, 0.1}}};
  spec.current.gauss_markov = GaussMarkovCurrentSpec{
      .mean_speed_mps = 0.3, .deviation_mps = 0.1, .direction_rad = 2.0, .direction_deviation_rad = 0.2};
  return spec;
}

bool same(const Water& a, const Water& b) {
  return a.current_n == b.current_n && a.current_rate_n == b.current_rate_n && a.elevation == b.elevation &&
         a.slope_n == b.slope_n && a.density == b.density;
}

TEST(Sea, WithoutWavesItIsItsCurrent) {
  WaterSpec spec;
  spec.current_n = {0.1, -0.2, 0.05};
  spec.density_kgpm3 = 1025.0;
  const Water water = Sea{spec, Rng{1}}.water_at({1, 2, 3}, 4.0);
  EXPECT_TRUE(same(water, {.current_n = spec.current_n, .density = 1025.0}));
}

TEST(Sea, ARegularWaveRunsWhereItIsSentWithItsPeriodAndLength) {
  // 10 s: 2 pi g / omega^2 = 156.1 m; it moves g / omega = 15.6 m/s towards the east
  const Sea sea{regular(0.5, 10.0, pi / 2), Rng{1}};
  const double length = 9.81 * 100.0 / (2 * pi);
  EXPECT_NEAR(sea.water_at({0, 0, 0}, 0.0).elevation, 0.5, 1e-15);
  EXPECT_NEAR(sea.water_at({77, length, 0}, 0.0).elevation, 0.5, 1e-12);
  EXPECT_NEAR(sea.water_at({0, 0, 0}, 10.0).elevation, 0.5, 1e-12);
  EXPECT_NEAR(sea.water_at({0, length / 4, 0}, 2.5).elevation, 0.5, 1e-12);
  EXPECT_NEAR(sea.water_at({0, 0, 0}, 5.0).elevation, -0.5, 1e-12);
}

TEST(Sea, UnderACrestTheWaterRunsWithTheWaveAndDecaysWithDepth) {
  const Sea sea{regular(0.5, 10.0, pi / 2), Rng{1}};
  const double omega = 2 * pi / 10.0, k = omega * omega / 9.81;
  EXPECT_LT((sea.water_at({0, 0, 0}, 0.0).current_n - Vec3{0, 0.5 * omega, 0}).norm(), 1e-12);
  EXPECT_LT((sea.water_at({0, 0, 7}, 0.0).current_n - Vec3{0, 0.5 * omega * std::exp(-k * 7), 0}).norm(),
            1e-12);
  EXPECT_LT((sea.water_at({0, 0, 0}, 7.5).current_n - Vec3{0, 0, -0.5 * omega}).norm(), 1e-12)
      << "a quarter period before the crest it rises";
}

TEST(Sea, ThePhaseIsThatOfTheElevationAtTheOrigin) {
  EXPECT_NEAR((Sea{regular(0.5, 10.0, 1.0, pi / 3), Rng{1}}.water_at({0, 0, 0}, 0.0).elevation), 0.25, 1e-12);
}

TEST(Sea, SlopeIsTheGradientOfTheElevation) {
  const Sea sea{everything(), Rng{3}};
  constexpr double h = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p{3.0 * i, -2.0 * i, 0.0};
    const auto up = [&](const Vec3& q) { return sea.water_at(q, 5.0).elevation; };
    const Water water = sea.water_at(p, 5.0);
    EXPECT_NEAR(water.slope_n.x(), (up(p + Vec3{h, 0, 0}) - up(p - Vec3{h, 0, 0})) / (2 * h), 1e-8);
    EXPECT_NEAR(water.slope_n.y(), (up(p + Vec3{0, h, 0}) - up(p - Vec3{0, h, 0})) / (2 * h), 1e-8);
  }
}

TEST(Sea, TheSurfaceRisesAsTheWaterInIt) {
  // to first order; a current without waves would carry the waves along, which is left out
  const Sea sea{regular(0.1, 6.0, 0.3), Rng{3}};
  constexpr double h = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const double t = 0.7 * i;
    const double rise =
        (sea.water_at({1, 2, 0}, t + h).elevation - sea.water_at({1, 2, 0}, t - h).elevation) / (2 * h);
    EXPECT_NEAR(rise, -sea.water_at({1, 2, 0}, t).current_n.z(), 1e-8);
  }
}

TEST(Sea, TheRateIsTheAccelerationOfTheWaterThatIsThere) {
  // dv/dt along the way of the water, by differences: at all depths, with shear, and at the surface
  const Sea sea{everything(), Rng{4}};
  constexpr double h = 1e-5;
  for (const double depth : {-0.3, 0.5, 4.0, 25.0}) {
    for (int i = 0; i < 20; ++i) {
      const Vec3 p{3.0 * i, -2.0 * i, depth};
      const double t = 1.3 * i;
      const Water water = sea.water_at(p, t);
      const Vec3 ahead = sea.water_at(p + h * water.current_n, t + h).current_n;
      const Vec3 behind = sea.water_at(p - h * water.current_n, t - h).current_n;
      EXPECT_LT((water.current_rate_n - (ahead - behind) / (2 * h)).norm(), 1e-7) << depth;
    }
  }
}

TEST(Sea, TheFlowOfWavesHasNoSourcesAndNoVortices) {
  WaterSpec spec = everything();
  spec.current = {};
  const Sea sea{spec, Rng{4}};
  constexpr double h = 1e-5;
  const Vec3 p{3, 4, 2};
  std::array<Vec3, 3> gradient;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3 step = h * Vec3::Unit(static_cast<Eigen::Index>(j));
    gradient[j] = (sea.water_at(p + step, 5.0).current_n - sea.water_at(p - step, 5.0).current_n) / (2 * h);
  }
  EXPECT_NEAR(gradient[0].x() + gradient[1].y() + gradient[2].z(), 0.0, 1e-8);
  EXPECT_NEAR(gradient[0].y(), gradient[1].x(), 1e-8);
  EXPECT_NEAR(gradient[0].z(), gradient[2].x(), 1e-8);
  EXPECT_NEAR(gradient[1].z(), gradient[2].y(), 1e-8);
}

TEST(Sea, WavesAddLinearly) {
  WaterSpec both = regular(0.5, 8.0, 0.3);
  both.waves.components.push_back({0.2, 3.0, -1.0, 0.5});
  WaterSpec second;
  second.waves.components = {both.waves.components[1]};
  const Vec3 p{5, -3, 1};
  const Water sum = Sea{both, Rng{1}}.water_at(p, 2.0);
  const Water a = Sea{regular(0.5, 8.0, 0.3), Rng{1}}.water_at(p, 2.0);
  const Water b = Sea{second, Rng{1}}.water_at(p, 2.0);
  EXPECT_LT((sum.current_n - a.current_n - b.current_n).norm(), 1e-15);
  EXPECT_NEAR(sum.elevation, a.elevation + b.elevation, 1e-15);
}

TEST(Sea, TheWavesOfThePaperHaveThePublishedSize) {
  // campos2019, table I: 4 sqrt(m_0) = 0.221 m, at most 0.13 m, and the second one's length is 21.4 m
  WaterSpec spec;
  spec.waves.components = {{0.06, 12.6, pi}, {0.04, 3.7, 3 * pi / 4}, {0.03, 6.3, pi / 4}};
  const Sea sea{spec, Rng{1}};
  double squares = 0.0, highest = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double elevation = sea.water_at({0, 0, 0}, 0.5 * i).elevation;
    squares += elevation * elevation / 20'000;
    highest = std::fmax(highest, std::abs(elevation));
  }
  EXPECT_NEAR(4 * std::sqrt(squares), 0.221, 0.002);
  EXPECT_LE(highest, 0.13);
  EXPECT_GT(highest, 0.12);
}

TEST(Sea, TheSameSeedIsTheSameSeaInAnyThread) {
  const WaterSpec spec = everything();
  std::array<Water, 2> seen;
  const auto look = [&spec](Water& into) {
    Sea sea{spec, Rng{8}};
    for (int i = 0; i < 1000; ++i) sea.advance(0.05);
    into = sea.water_at({1, 2, 3}, 50.0);
  };
  std::thread first{look, std::ref(seen[0])}, second{look, std::ref(seen[1])};
  first.join();
  second.join();
  EXPECT_TRUE(same(seen[0], seen[1]));
  Sea other{spec, Rng{9}};
  EXPECT_FALSE(same(seen[0], other.water_at({1, 2, 3}, 50.0)));
}

TEST(Sea, WavesAndCurrentDrawFromStreamsOfTheirOwn) {
  WaterSpec calm = everything();
  calm.waves = {};
  Sea with{everything(), Rng{8}}, without{calm, Rng{8}};
  for (int i = 0; i < 100; ++i) {
    with.advance(0.05);
    without.advance(0.05);
  }
  // at 1 km the waves are gone
  EXPECT_LT(
      (with.water_at({0, 0, 1000}, 5.0).current_n - without.water_at({0, 0, 1000}, 5.0).current_n).norm(),
      1e-15);
}

TEST(Sea, ItsCurrentIsItsWaterWithoutWhatTheWavesDo) {
  Sea sea{everything(), Rng{8}};
  WaterSpec calm = everything();
  calm.waves = {};
  Sea flat{calm, Rng{8}};
  for (int i = 0; i < 100; ++i) {
    sea.advance(0.05);
    flat.advance(0.05);
  }
  EXPECT_EQ(sea.current_at(3.0), flat.water_at({1, 2, 3}, 5.0).current_n);
  EXPECT_NE(sea.current_at(3.0), sea.water_at({1, 2, 3}, 5.0).current_n);
  EXPECT_TRUE(flat.waves().empty());
  EXPECT_FALSE(sea.waves().empty());
}

TEST(Sea, ACopyIsASnapshot) {
  Sea sea{everything(), Rng{8}};
  const Sea before = sea;
  const Water then = sea.water_at({1, 2, 3}, 1.0);
  for (int i = 0; i < 100; ++i) sea.advance(0.05);
  EXPECT_TRUE(same(before.water_at({1, 2, 3}, 1.0), then));
  EXPECT_FALSE(same(sea.water_at({1, 2, 3}, 1.0), then));
  Sea again = before;
  for (int i = 0; i < 100; ++i) again.advance(0.05);
  EXPECT_TRUE(same(sea.water_at({1, 2, 3}, 1.0), again.water_at({1, 2, 3}, 1.0)));
}

}  // namespace
}  // namespace fairway
