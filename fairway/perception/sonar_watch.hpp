// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "fairway/core/echo.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/perception/merge.hpp"
#include "fairway/perception/nearest_first.hpp"
#include "fairway/perception/scene.hpp"
#include "fairway/perception/sonar/contact_finder.hpp"
#include "fairway/perception/sonar/sonar.hpp"
#include "fairway/perception/tracker/tracker.hpp"

namespace fairway {

/// All parameters of the sonar perception, as one list.
struct SonarWatchParams : SonarParams, TrackerParams, MergeParams {
  static consteval auto fields() {
    return std::tuple_cat(SonarParams::fields(), TrackerParams::fields(), MergeParams::fields());
  }
};

/// The watch that one vehicle keeps with a sonar: it pings when it is due, follows what it sees, and knows of
/// the others by both eye and ear. A value: a copy goes on as the original does.
class SonarWatch {
 public:
  /// Memory for messages of `told_count` vehicles. Throws InputError for a parameter that is unknown or out
  /// of range, and for parameters that contradict each other.
  SonarWatch(const ParamValues& params, std::size_t told_count, Rng rng);

  /// Pings if it is time: the n-th ping, from 0, is at the first call at or after n / rate. Does not
  /// allocate.
  void sense(const Scene& scene, const Viewpoint& own);

  /// Whoever tells within `reach` of the believed place, whatever the tracker follows, and of both only one:
  /// nearest first, ties by id. Does not allocate after the first call.
  void report(const Scene& scene, const Viewpoint& own, const Reach& reach, std::vector<Track>& tracks);

  /// The echoes of the last ping.
  std::span<const Echo> echoes() const { return echoes_; }

 private:
  SonarWatch(const SonarWatchParams& params, std::size_t told_count, Rng rng);

  double rate_;
  Sonar sonar_;
  ContactFinder finder_;
  Tracker tracker_;
  Merge merge_;
  Rng echo_rng_;
  Rng false_rng_;
  double pings_{};  // due so far
  std::vector<Echo> echoes_;
  std::vector<Contact> contacts_;
  std::vector<Track> seen_;
  std::vector<Track> known_;
  std::vector<Near> near_;
};

}  // namespace fairway
