// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fairway/avoidance/situation.hpp"
#include "fairway/core/params.hpp"
#include "fairway/perception/contact.hpp"
#include "fairway/perception/fan.hpp"
#include "fairway/perception/tracker/assignment.hpp"
#include "fairway/perception/tracker/still_or_moving.hpp"

namespace fairway {

struct TrackerParams {
  double velocity_change_mps = 0.1;
  double first_speed_mps = 1.0;
  double still_ratio = 0.3;
  double still_change_m = 0.05;
  double gate_ratio = 0.99;
  int birth_hits_count = 5;
  int birth_pings_count = 8;
  int death_missed_count = 30;
  double death_sigma_m = 5.0;
  double death_unseen_s = 20.0;
  double radius_change_mps = 0.05;
  int max_tracks_count = 64;
  bool contacts_react = false;

  static consteval auto fields() {
    return std::tuple{
        field<&TrackerParams::velocity_change_mps>(
            {0, 100}, "standard deviation of what a target does to each component of its velocity in 1 s"),
        field<&TrackerParams::first_speed_mps>(
            {0.001, 100}, "standard deviation of each component of a velocity not yet observed"),
        field<&TrackerParams::still_ratio>({0, 0.99},
                                           "probability that what is new stands still; 0: nothing ever does"),
        field<&TrackerParams::still_change_m>(
            {0.001, 100}, "standard deviation of what the place of a target that stands still does in 1 s"),
        field<&TrackerParams::gate_ratio>({0.5, 0.999999},
                                          "probability that a target's own contact passes its gate"),
        field<&TrackerParams::birth_hits_count>({1, 64},
                                                "a track is reported once it has so many contacts ..."),
        field<&TrackerParams::birth_pings_count>({1, 64}, "... in so many pings, else it is forgotten"),
        field<&TrackerParams::death_missed_count>(
            {1, 100000},
            "pings that should have shown a target and did not after which it is given up, if they "
            "are not fewer than those that did; each contact makes up for two"),
        field<&TrackerParams::death_sigma_m>(
            {0.01, 10000}, "horizontal standard deviation at which a target out of view is given up"),
        field<&TrackerParams::death_unseen_s>(
            {0, 1e6}, "... or so long after its last contact: what stands still may have left"),
        field<&TrackerParams::radius_change_mps>(
            {0, 100}, "standard deviation of what the radius seen of a target does in 1 s"),
        field<&TrackerParams::max_tracks_count>({1, 512}, "at a time, those not yet reported among them"),
        field<&TrackerParams::contacts_react>(
            "whether what is only seen is counted on to avoid us as we avoid it"),
    };
  }
};

/// Throws InputError where one parameter contradicts another.
void check(const TrackerParams& params);

/// Follows many targets from contacts that are noisy, missed, and false: a Kalman filter each, gates, the
/// best assignment of all, birth by M contacts in N pings, death by misses or uncertainty. A value: a copy
/// goes on as the original does. Allocates when made, then never.
class Tracker {
 public:
  /// Throws InputError where the parameters contradict each other.
  explicit Tracker(const TrackerParams& params);

  /// The contacts of one ping at `time` [s], which never runs backwards. Only a target within `view` can be
  /// missed. Of more contacts than capacity() the first are taken. O(n^2 m) for n tracks, m contacts.
  void update(double time, std::span<const Contact> contacts, const Fan& view);

  /// Appends all established tracks as they are at `time` [s], in order of id.
  void report(double time, std::vector<Track>& tracks) const;

  /// As many contacts of one ping as are looked at: twice the tracks.
  std::size_t capacity() const { return 2 * static_cast<std::size_t>(params_.max_tracks_count); }

 private:
  struct Target {
    StillOrMoving motion;
    Mat3 lasting = Mat3::Zero();  // of the last contact's error
    double seen{};                // when [s]
    double radius{};
    double radius_variance{};
    int pings{};   // since birth
    int hits{};    // of them
    int missed{};  // not made up for
    TrackId id{};
    bool established{false};
  };

  void assign(std::span<const Contact> contacts, bool established);
  double distance_to(const Contact& contact, const Target& target) const;
  void correct(Target& target, const Contact& contact, double period) const;
  void miss(Target& target, const Fan& view) const;
  void establish();
  bool is_lost(const Target& target) const;
  void bear(const Contact& contact);

  TrackerParams params_;
  StillOrMoving::Noise noise_;
  double gate_;  // of the squared Mahalanobis distance of position and radius
  std::uint32_t next_id_{first_tracker_id};
  double time_{};
  std::vector<Target> targets_;  // in order of birth
  Assignment assignment_;
  std::vector<std::size_t> rows_;                       // targets that take part in an assignment
  std::vector<std::optional<std::size_t>> contact_of_;  // each target's
  std::vector<char> used_;                              // each contact
};

}  // namespace fairway
