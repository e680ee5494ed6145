// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/sonar/contact_finder.hpp"

#include <gtest/gtest.h>

#include "fairway/core/testing/allocations.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"

namespace fairway {
namespace {

std::vector<Contact> contacts_of(const SonarParams& params, const VehicleState& own,
                                 const std::vector<Mover>& others,
                                 const std::vector<Obstacle>& obstacles = {}, Rng rng = Rng{1}) {
  std::vector<Contact> contacts;
  ContactFinder{params}.find(echoes_of(params, own, others, obstacles, rng), obstacles, own, contacts);
  return contacts;
}

TEST(ContactFinder, ABallIsFoundWhereItIsInAnyAttitude) {
  VehicleState own;
  own.p_n = {100, -50, 20};
  own.q_nb = quaternion_of({.roll = 0.2, .pitch = -0.1, .yaw = 2.5});
  const Vec3 centre = own.p_n + own.q_nb * Vec3{25, 10, 0};
  const auto contacts = contacts_of(quiet_sonar(), own, {ball(centre, 3)});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_LT((contacts[0].position - centre).norm(), 0.15);
  EXPECT_NEAR(contacts[0].radius, 3.0, 0.15);
}

/// Mean and root mean square error, and the mean of its square over the variance told.
struct Accuracy {
  double radius_bias{};
  double along_bias{};
  double across_rms{};
  double nees{};  // in the horizontal plane: 2 if consistent
};

Accuracy accuracy(double distance, double radius) {
  const SonarParams params{.false_echoes_count = 0.0, .heading_sigma_deg = 0.0};
  const int runs = 400;
  Accuracy sum;
  for (int i = 0; i < runs; ++i) {
    Rng rng = Rng{5}.stream("run", i);
    const double bearing = rng.uniform(-0.5, 0.5);
    const Vec3 along{std::cos(bearing), std::sin(bearing), 0};
    const Vec3 centre = distance * along;
    const auto contacts = contacts_of(params, {}, {ball(centre, radius)}, {}, rng);
    EXPECT_GE(contacts.size(), 1U);
    if (contacts.empty()) continue;
    const Vec3 error = contacts[0].position - centre;
    sum.radius_bias += (contacts[0].radius - radius) / runs;
    sum.along_bias += along.dot(error) / runs;
    sum.across_rms += (error - along.dot(error) * along).squaredNorm() / runs;
    const Eigen::Matrix2d covariance = contacts[0].covariance.topLeftCorner<2, 2>();
    sum.nees += error.head<2>().dot(covariance.inverse() * error.head<2>()) / runs;
  }
  sum.across_rms = std::sqrt(sum.across_rms);
  return sum;
}

TEST(ContactFinder, CentreAndRadiusAreNearlyUnbiasedAndAsUncertainAsTold) {
  for (const auto& [distance, radius] :
       {std::pair{10.0, 1.0}, {20.0, 2.0}, {40.0, 2.0}, {40.0, 4.0}, {80.0, 2.0}}) {
    const Accuracy a = accuracy(distance, radius);
    SCOPED_TRACE(testing::Message() << distance << " m, radius " << radius << " m: radius bias "
                                    << a.radius_bias << ", along " << a.along_bias << ", across "
                                    << a.across_rms << ", nees " << a.nees);
    EXPECT_LT(std::abs(a.radius_bias), 0.1 * radius);
    EXPECT_LT(std::abs(a.along_bias), 0.1 * radius);
    EXPECT_LT(a.nees, 4.0);
    EXPECT_GT(a.nees, 0.7);
  }
}

/// Mean error of centre and radius of a ball of 2 m, one side of which is out of sight, and the mean square
/// of the former over the variance told.
Vec3 errors_cut_off(const Vec3& centre, const std::vector<Mover>& others) {
  const SonarParams params{.false_echoes_count = 0.0, .heading_sigma_deg = 0.0};
  const int runs = 200;
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < runs; ++i) {
    std::vector<Mover> all = others;
    all.push_back(ball(centre, 2));
    const auto contacts = contacts_of(params, {}, all, {}, Rng{6}.stream("run", i));
    const auto off = [&](const Contact& contact) { return (contact.position - centre).norm(); };
    const Contact nearest = std::ranges::min(contacts, {}, off);
    const Vec2 error = (nearest.position - centre).head<2>();
    const Eigen::Matrix2d covariance = nearest.covariance.topLeftCorner<2, 2>();
    mean +=
        Vec3{off(nearest), std::abs(nearest.radius - 2.0), error.dot(covariance.inverse() * error)} / runs;
  }
  return mean;
}

TEST(ContactFinder, WhatReachesOutOfTheFanIsFittedByTheArcInSight) {
  const Vec3 near = errors_cut_off(6.0 * Vec3{std::cos(1.1), std::sin(1.1), 0}, {});
  EXPECT_LT(near.x(), 0.4);
  EXPECT_LT(near.y(), 0.4);
  EXPECT_LT(near.z(), 4.0);
}

TEST(ContactFinder, WhatIsHalfHiddenIsFittedByTheArcInSight) {
  const Vec3 hidden = errors_cut_off({20, 0, 0}, {ball({10, -1, 0}, 1)});
  EXPECT_LT(hidden.x(), 1.0);
  EXPECT_LT(hidden.y(), 1.0);
  EXPECT_LT(hidden.z(), 4.0);
}

TEST(ContactFinder, TheElevationIsNotKnownAndTheCovarianceSaysSo) {
  SonarParams params = quiet_sonar();
  const auto contacts = contacts_of(params, {}, {ball({40, 0, 5}, 2)});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].position.z(), 0.0, 1e-9);
  const double sigma = std::sqrt(contacts[0].covariance(2, 2));
  EXPECT_NEAR(sigma, (40.0 * std::sin(radians(10)) + 2.0) / std::sqrt(3.0), 0.3);
  EXPECT_NEAR(contacts[0].lasting(2, 2), sigma * sigma, 1e-3);
}

TEST(ContactFinder, DoubtAboutTheHeadingLiesAcrossTheLineOfSight) {
  SonarParams params = quiet_sonar();
  params.heading_sigma_deg = 1.0;
  const auto contacts = contacts_of(params, {}, {ball({50, 0, 0}, 2)});
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_NEAR(contacts[0].lasting(1, 1), std::pow(50 * radians(1), 2), 0.05);
  EXPECT_NEAR(contacts[0].lasting(0, 0), 0.0, 1e-9);
}

TEST(ContactFinder, TwoBallsApartAreTwoContactsNearestFirst) {
  const auto contacts = contacts_of(SonarParams{.false_echoes_count = 0.0}, {},
                                    {ball({40, -6, 0}, 2), ball({30, 6, 0}, 2), ball({20, 0, 0}, 1)});
  ASSERT_EQ(contacts.size(), 3U);
  EXPECT_NEAR(contacts[0].position.x(), 20, 0.6);
  EXPECT_NEAR(contacts[1].position.y(), 6, 0.6);
  EXPECT_NEAR(contacts[2].position.y(), -6, 0.6);
}

/// Of a hundred pings, those with so many contacts.
int pings_with(std::size_t count, const std::vector<Mover>& others) {
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const Rng rng = Rng{9}.stream("run", static_cast<std::uint64_t>(i));
    found += contacts_of({.false_echoes_count = 0.0}, {}, others, {}, rng).size() == count ? 1 : 0;
  }
  return found;
}

TEST(ContactFinder, TwoThatTouchAreToldApartAndOneIsNotTakenForTwo) {
  EXPECT_GE(pings_with(2, {ball({10, -1, 0}, 1), ball({10, 1, 0}, 1)}), 95);
  EXPECT_GE(pings_with(2, {ball({5, -0.4, 0}, 0.6), ball({5, 0.6, 0}, 0.4)}), 90);
  EXPECT_GE(pings_with(3, {ball({12, -2, 0}, 1), ball({12, 0, 0}, 1), ball({12, 2, 0}, 1)}), 90);
  for (const double distance : {6.0, 12.0, 24.0, 48.0})
    EXPECT_GE(pings_with(1, {ball({distance, 0, 0}, 1.5)}), 97) << distance;
}

TEST(ContactFinder, WhatReachesIntoTheLeastRangeIsAsUncertainAsItsArc) {
  const auto contacts = contacts_of({.false_echoes_count = 0.0}, {}, {ball({2.0, 0.8, 0}, 1.3)});
  ASSERT_FALSE(contacts.empty());
  for (const Contact& contact : contacts) EXPECT_GT(contact.radius_sigma, 0.2);
}

TEST(ContactFinder, AWallIsCutIntoPiecesThatCoverIt) {
  SonarParams params = quiet_sonar();
  const std::vector<Obstacle> wall{
      {.kind = Obstacle::Kind::segment, .from = {30, -25, 0}, .to = {30, 25, 0}, .charted = false}};
  const auto contacts = contacts_of(params, {}, {}, wall);
  ASSERT_GE(contacts.size(), 4U);
  for (int i = -24; i <= 24; ++i) {
    const double east = i;
    const bool covered = std::ranges::any_of(contacts, [&](const Contact& contact) {
      return (contact.position - Vec3{30, east, 0}).norm() <= contact.radius + 0.6;
    });
    EXPECT_TRUE(covered) << east;
  }
  for (const Contact& contact : contacts) EXPECT_LE(contact.radius, 12.0);
}

TEST(ContactFinder, WhatIsChartedIsDismissedAndWhatIsBeforeItIsNot) {
  std::vector<Obstacle> obstacles{{.kind = Obstacle::Kind::sphere, .position = {40, 0, 4}, .radius = 6},
                                  {.kind = Obstacle::Kind::segment, .from = {60, -30, 0}, .to = {50, 30, 0}}};
  SonarParams params;
  params.false_echoes_count = 0.0;
  EXPECT_TRUE(contacts_of(params, {}, {}, obstacles).empty());
  EXPECT_EQ(contacts_of(params, {}, {ball({25, 0, 0}, 1)}, obstacles).size(), 1U);
  for (Obstacle& obstacle : obstacles) obstacle.charted = false;
  EXPECT_GE(contacts_of(params, {}, {}, obstacles).size(), 2U);
}

TEST(ContactFinder, TheEstimatePlacesWhatTheTruthShows) {
  const SonarParams params = quiet_sonar();
  VehicleState believed;
  believed.p_n = {3, -2, 1};
  believed.q_nb = quaternion_of({.yaw = 0.1});
  std::vector<Contact> contacts;
  ContactFinder{params}.find(echoes_of(params, {}, {ball({30, 0, 0}, 2)}), {}, believed, contacts);
  ASSERT_EQ(contacts.size(), 1U);
  EXPECT_LT((contacts[0].position - (believed.p_n + believed.q_nb * Vec3{30, 0, 0})).norm(), 0.2);
}

TEST(ContactFinder, AnyEchoesGiveFiniteContactsAndNoAllocations) {
  const SonarParams params;
  ContactFinder finder{params};
  const std::vector<Obstacle> obstacles{
      {.kind = Obstacle::Kind::sphere, .position = {40, 0, 0}, .radius = 6}};
  std::vector<Echo> echoes;
  std::vector<Contact> contacts;
  contacts.reserve(300);
  echoes.reserve(300);
  Rng rng{1};
  long before = 0;
  for (int i = 0; i < 300; ++i) {
    if (i == 5) before = allocation_count();
    echoes.clear();
    const auto count = i < 5 ? 256 : rng.index(256);
    for (std::uint64_t k = 0; k < count; ++k)
      echoes.push_back({rng.index(4) == 0 ? 0.0 : rng.uniform(0, 100), rng.uniform(-1.2, 1.2)});
    std::ranges::sort(echoes, {}, &Echo::bearing);
    finder.find(echoes, obstacles, {}, contacts);
    for (const Contact& contact : contacts) {
      ASSERT_TRUE(is_finite(contact.position));
      ASSERT_TRUE(contact.covariance.allFinite());
      ASSERT_GT(contact.covariance.determinant(), 0.0);
      ASSERT_GE(contact.radius, 0.0);
      ASSERT_GT(contact.radius_sigma, 0.0);
    }
  }
  EXPECT_EQ(allocation_count() - before, 0);
}

}  // namespace
}  // namespace fairway
