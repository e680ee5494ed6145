// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/inflate/inflate.hpp"

#include <gtest/gtest.h>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/chi.hpp"

namespace fairway {
namespace {

using encounters::OwnedSituation;

/// Answers with the radius of the first track as speed, a tenth of a m/s a metre.
template <bool is_planar>
struct Ruler {
  static constexpr AlgorithmInfo info{.name = "ruler", .planar = is_planar};
  using Params = NoParams;
  using Memory = NoMemory;
  Params params;
  Command decide(const Situation& s, Memory&, Context&) const noexcept {
    return {.velocity = {0.1 * s.tracks[0].radius, 0.0, 0.0}};
  }
};

/// The radius that an inner avoider is shown of a sphere of 1 m.
template <bool is_planar>
double shown_radius(const Mat3& covariance, const Inflate::Params& params = {}) {
  OwnedSituation e = encounters::head_on();
  e.tracks[0].position_covariance = covariance;
  Avoider avoider{Inflate{params}, Avoider{Ruler<is_planar>{}}};
  return 10.0 * avoider.decide(e).velocity.x();
}

/// In space, ellipsoids in axes turned by 0.7 rad about an axis aslant.
Mat3 turned(const Vec3& variances) {
  const Mat3 turn = Eigen::AngleAxisd{0.7, Vec3{1, 2, 3}.normalized()}.toRotationMatrix();
  return turn * variances.asDiagonal() * turn.transpose();
}

TEST(Inflate, ItsQuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(chi_quantile(0.95, 3), 2.795483, 1e-6);  // sqrt(7.814728)
  EXPECT_NEAR(chi_quantile(0.5, 3), 1.538172, 1e-6);   // sqrt(2.365974)
  EXPECT_NEAR(chi_quantile(0.99, 3), 3.368214, 1e-6);  // sqrt(11.344867)
  EXPECT_NEAR(chi_quantile(0.95, 2), 2.447747, 1e-6);  // sqrt(5.991465)
  EXPECT_NEAR(chi_quantile(0.99, 2), 3.034854, 1e-6);  // sqrt(9.210340)
  EXPECT_LT(chi_quantile(0.0, 3), 1e-3);
  EXPECT_EQ(chi_quantile(0.0, 2), 0.0);
}

TEST(Inflate, ASphereGrowsByTheLongestAxisOfTheError) {
  EXPECT_NEAR(shown_radius<false>(turned({0.01, 0.25, 0.04})), 1.0 + 2.795483 * 0.5, 1e-6);
}

TEST(Inflate, APlanarAvoiderIsShownTheHorizontalErrorOnly) {
  EXPECT_NEAR(shown_radius<true>(Vec3{0.01, 0.25, 9.0}.asDiagonal()), 1.0 + 2.447747 * 0.5, 1e-6);
}

TEST(Inflate, AStaleTrackDoesNotFillTheSea) {
  EXPECT_DOUBLE_EQ(shown_radius<false>(1e6 * Mat3::Identity(), {.max_growth_m = 7.0}), 8.0);
}

TEST(Inflate, MoreConfidenceIsALargerSphere) {
  const Mat3 covariance = 0.25 * Mat3::Identity();
  EXPECT_LT(shown_radius<false>(covariance, {.confidence_ratio = 0.5}),
            shown_radius<false>(covariance, {.confidence_ratio = 0.9}));
  EXPECT_NEAR(shown_radius<false>(covariance, {.confidence_ratio = 0.0}), 1.0, 1e-3);
}

TEST(Inflate, TheSphereHoldsTheErrorsThatItPromisesTo) {
  const Inflate inflate{Inflate::Params{.confidence_ratio = 0.9}};
  Track track;
  track.position_covariance = 0.25 * Mat3::Identity();
  const double growth = inflate.growth(track, false);
  Rng rng{3};
  int held = 0;
  constexpr int draws = 20000;
  for (int i = 0; i < draws; ++i) {
    const Vec3 error = 0.5 * Vec3{rng.normal(), rng.normal(), rng.normal()};
    held += error.norm() <= growth ? 1 : 0;
  }
  EXPECT_NEAR(held / double{draws}, 0.9, 0.008);  // 4 standard deviations of the binomial
}

TEST(Inflate, WithoutUncertaintyItAnswersAsTheInnerOneToTheBit) {
  for (const char* inner : {"orca3d", "apf", "direct", "orca3d+stop_and_wait"}) {
    for (std::uint64_t i = 0; i < 100; ++i) {
      const OwnedSituation e = encounters::crowd(8, Rng{i});
      Avoider alone = builtin_avoiders().make(inner, {}, Rng{7});
      Avoider wrapped = builtin_avoiders().make(std::string(inner) + "+inflate", {}, Rng{7});
      for (int step = 0; step < 3; ++step) EXPECT_EQ(wrapped.decide(e), alone.decide(e)) << inner << ' ' << i;
    }
  }
}

TEST(Inflate, WhoIsUncertainIsGivenAWiderBerth) {
  OwnedSituation e = encounters::head_on(9.0);
  e.tracks[0].position.y() = 0.5;
  const auto aside = [&] { return builtin_avoiders().make("orca3d+inflate").decide(e).velocity.y(); };
  const double certain = aside();
  e.tracks[0].position_covariance = 0.25 * Mat3::Identity();
  EXPECT_LT(certain, -0.05);
  EXPECT_LT(aside(), certain - 0.05);
}

TEST(Inflate, AroundAnyWrapperItKnowsWhetherTheMethodWithinThinksInThePlane) {
  const Catalog catalog = builtin_avoiders();
  OwnedSituation e = encounters::crowd(6, Rng{4});
  for (const Catalog::Entry& entry : catalog.entries()) {
    if (!entry.wraps) continue;
    for (const std::string inner : {"orca2d", "orca3d"}) {
      const std::string name = inner + "+" + std::string(entry.info.name);
      EXPECT_EQ(catalog.make(name).thinks_in_plane(), catalog.needs(name, &AlgorithmInfo::planar)) << name;
    }
    // what is uncertain upwards is nothing to it
    const std::string name = "orca2d+" + std::string(entry.info.name) + "+inflate";
    const auto answer = [&](double variance) {
      for (Track& t : e.tracks) t.position_covariance = Vec3{0.04, 0.01, variance}.asDiagonal();
      return catalog.make(name, {}, Rng{7}).decide(e);
    };
    EXPECT_EQ(answer(0.0), answer(9.0)) << name;
  }
}

}  // namespace
}  // namespace fairway
