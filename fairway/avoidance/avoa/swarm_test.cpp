// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/avoa/swarm.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fairway/avoidance/avoa/testing/random_spaces.hpp"

namespace fairway::avoa {
namespace {

/// The defaults of Avoa::Params.
constexpr Swarm::Settings settings{.particles = 30,
                                   .iterations = 60,
                                   .accepted_cost = 0.001,
                                   .inertia = 0.7,
                                   .personal = 1.4,
                                   .common = 1.4,
                                   .shake = {0.05, 0.05 * pi},
                                   .start = {0.3, 0.3 * pi}};

constexpr Candidate nobody{.cost = std::numeric_limits<double>::infinity()};

VelocityMetric metric_for(const PolarVelocity& desired) { return {desired, 1.5, 0.4, 0.2, 0.4}; }

/// The share of 1000 random scenes in which the swarm comes within 0.01 of the best cell.
double share_found(const Swarm::Settings& how) {
  int found = 0;
  VelocitySpace space;
  Swarm swarm;
  for (std::uint64_t scene = 0; scene < 1000; ++scene) {
    fill(space, 12, Rng{9}.stream("space", scene));
    const VelocityMetric metric = metric_for(any_desired(Rng{9}.stream("desired", scene)));
    Rng rng = Rng{9}.stream("swarm", scene);
    const double best = cheapest_cell(space, metric, nobody).cost;
    const double cost = swarm.search(space, metric, nobody, how, rng).cost;
    found += cost <= best + 0.01 ? 1 : 0;
    if (std::isinf(best)) {
      EXPECT_EQ(cost, best);
    }
  }
  return found / 1000.0;
}

TEST(Swarm, OfThirtyInSixtyIterationsIsWithinAHundredthOfTheBestCellIn99Of100Scenes) {
  EXPECT_GE(share_found(settings), 0.99);
}

TEST(Swarm, OfTenInTwentyIterationsFindsItLessOften) {
  Swarm::Settings hasty = settings;
  hasty.particles = 10;
  hasty.iterations = 20;
  EXPECT_LT(share_found(hasty), share_found(settings));
}

TEST(Swarm, AnswersAndEndsWithFeasibleVelocities) {
  VelocitySpace space;
  Swarm swarm;
  int searched = 0;
  for (std::uint64_t scene = 0; scene < 200; ++scene) {
    fill(space, 12, Rng{10}.stream("space", scene));
    if (space.feasible().empty()) continue;
    ++searched;
    Rng rng{scene};
    const Candidate best = swarm.search(space, metric_for(any_desired(Rng{scene})), nobody, settings, rng);
    const int cell = space.grid().cell_at(best.velocity.cartesian());
    ASSERT_NE(cell, VelocityGrid::outside);
    EXPECT_TRUE(space.is_feasible(cell));
    EXPECT_FALSE(zarco.contains(best.velocity));
    EXPECT_EQ(swarm.particles().size(), 30U);
    for (const Swarm::Particle& particle : swarm.particles()) {
      EXPECT_TRUE(space.is_feasible(space.grid().cell_at(particle.position.cartesian())));
      EXPECT_GE(particle.best_cost, best.cost);
    }
  }
  EXPECT_GT(searched, 150);
}

TEST(Swarm, IsNotAskedIfTheDesiredVelocityIsAccepted) {
  VelocitySpace space;
  fill(space, 3, Rng{11});
  Swarm swarm;
  Rng rng{1};
  const Candidate desired{{1.2, 0.0}, 0.001};
  const Candidate best = swarm.search(space, metric_for(desired.velocity), desired, settings, rng);
  EXPECT_EQ(best.velocity.speed, 1.2);
  EXPECT_TRUE(swarm.particles().empty());
  EXPECT_EQ(rng, Rng{1});
}

TEST(Swarm, StopsAsSoonAsItsBestIsAccepted) {
  VelocitySpace space;
  fill(space, 3, Rng{11});
  Swarm swarm;
  Swarm::Settings easy = settings;
  easy.accepted_cost = 1.0;
  Rng rng{1}, other{1};
  (void)swarm.search(space, metric_for({1.2, 0.0}), nobody, easy, rng);
  easy.iterations = 1;
  (void)swarm.search(space, metric_for({1.2, 0.0}), nobody, easy, other);
  EXPECT_EQ(rng, other);
}

TEST(Swarm, ShakesParticlesThatRest) {
  // one particle that neither starts with a step nor has better to go to finds nothing new unless it is
  // shaken
  VelocitySpace space;
  fill(space, 3, Rng{12});
  Swarm::Settings alone = settings;
  alone.particles = 1;
  alone.start = {};
  alone.accepted_cost = 0.0;
  const VelocityMetric metric = metric_for({1.2, 0.3});
  const auto result = [&](const Swarm::Settings& how) {
    Rng rng{2};
    return Swarm{}.search(space, metric, nobody, how, rng).cost;
  };
  alone.iterations = 1;
  const double placed = result(alone);
  alone.iterations = 60;
  EXPECT_LT(result(alone), placed);
  alone.shake = {};
  EXPECT_EQ(result(alone), placed);
}

TEST(Swarm, WithNowhereToBeAnswersWhatItBeganWith) {
  VelocitySpace space;
  space.begin({101, 1.5}, zarco, 2.0);
  space.finish(0.3);
  Swarm swarm;
  Rng rng{1};
  EXPECT_EQ(swarm.search(space, metric_for({1.2, 0.0}), nobody, settings, rng).cost, nobody.cost);
  EXPECT_TRUE(swarm.particles().empty());
}

}  // namespace
}  // namespace fairway::avoa
