// SPDX-License-Identifier: Apache-2.0
// From echoes to tracks: sonar, contacts and tracker together.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "fairway/perception/sonar/contact_finder.hpp"
#include "fairway/perception/testing/ospa.hpp"
#include "fairway/perception/testing/quiet_sonar.hpp"
#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {
namespace {

constexpr double ping_period = 1.0 / 15.0;

/// A sonar at rest that watches balls pass, with noise, 10 % misses and 2 false echoes a ping.
class Watch {
 public:
  Watch(const std::vector<Mover>& others, Rng rng)
      : movers_{movers_round({}, others)}, rng_{rng}, false_rng_{rng.stream("false")} {}

  /// The tracks after the next ping, by id.
  const std::vector<Track>& next() {
    for (Mover& mover : movers_) mover.position += ping_period * mover.velocity;
    time_ += ping_period;
    sonar_.ping({}, {.movers = movers_}, rng_, false_rng_, echoes_);
    finder_.find(echoes_, {}, {}, contacts_);
    tracker_.update(time_, contacts_, sonar_.fan({}));
    tracks_.clear();
    tracker_.report(time_, tracks_);
    return tracks_;
  }

  /// The places of the balls [m, NED].
  std::vector<Vec3> places() const {
    std::vector<Vec3> places;
    for (std::size_t i = 1; i < movers_.size(); ++i) places.push_back(movers_[i].position);
    return places;
  }

 private:
  SonarParams params_{.missed_ratio = 0.1, .false_echoes_count = 2.0, .heading_sigma_deg = 0.0};
  Sonar sonar_{params_};
  ContactFinder finder_{params_};
  Tracker tracker_{{}};
  std::vector<Mover> movers_;
  Rng rng_;
  Rng false_rng_;
  double time_{};
  std::vector<Echo> echoes_;
  std::vector<Contact> contacts_;
  std::vector<Track> tracks_;
};

TEST(SonarChain, TwoThatCrossAreFollowedWithTheirIdsAndWithinAMetre) {
  double mean_ospa = 0.0;
  int kept = 0;
  const int runs = 20;
  for (int run = 0; run < runs; ++run) {
    // one passes 6 m behind the other, which hides it for some 4 s
    const std::vector<Mover> pair{ball({30, -12, 0}, 1.5, {0, 0.8, 0}), ball({36, 12, 0}, 1.5, {0, -0.8, 0})};
    Watch watch{pair, Rng{1}.stream("run", static_cast<std::uint64_t>(run))};
    std::vector<TrackId> ids(2);
    for (int i = 0; i < 450; ++i) {
      const auto& tracks = watch.next();
      const auto places = watch.places();
      std::vector<Vec3> found;
      for (const Track& track : tracks) found.push_back(track.position);
      if (i >= 15) mean_ospa += ospa(places, found, 10.0) / 435.0 / runs;
      const auto nearest = [&](const Vec3& place) {
        return std::ranges::min(tracks, {}, [&](const Track& t) { return (t.position - place).norm(); }).id;
      };
      if (i == 60) ids = {nearest(places[0]), nearest(places[1])};
      if (i == 449) kept += ids[0] == nearest(places[0]) && ids[1] == nearest(places[1]) ? 1 : 0;
    }
  }
  RecordProperty("ospa_m", std::to_string(mean_ospa));
  RecordProperty("kept", kept);
  EXPECT_LT(mean_ospa, 1.5);
  EXPECT_GE(kept, 17);
}

TEST(SonarChain, ErrorsOfAPassingTargetAreNotMuchLargerThanTold) {
  const int runs = 200;
  const int pings = 300;
  double nees = 0.0;
  double count = 0.0;
  for (int run = 0; run < runs; ++run) {
    Rng rng = Rng{2}.stream("run", static_cast<std::uint64_t>(run));
    const double course = rng.uniform(-pi, pi);
    const std::vector<Mover> one{
        ball({35, rng.uniform(-8, 8), 0}, 2.0, 0.5 * Vec3{std::cos(course), std::sin(course), 0})};
    Watch watch{one, rng};
    for (int i = 0; i < pings; ++i) {
      const auto& tracks = watch.next();
      const Vec3 place = watch.places()[0];
      if (i < 60) continue;
      for (const Track& track : tracks) {
        const Vec2 error = (track.position - place).head<2>();
        if (error.norm() > 5.0) continue;
        const Eigen::Matrix2d covariance = track.position_covariance.topLeftCorner<2, 2>();
        nees += error.dot(covariance.inverse() * error);
        count += 1.0;
      }
    }
  }
  nees /= count;
  RecordProperty("nees", std::to_string(nees));
  EXPECT_GT(count, 0.9 * runs * (pings - 60));
  // 2 if noise were white and Gaussian; the target does not manoeuvre, so the filter is on the safe side
  EXPECT_LT(nees, 3.0);
  EXPECT_GT(nees, 0.3);
}

}  // namespace
}  // namespace fairway
