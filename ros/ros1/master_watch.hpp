// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace fairway::ros1 {

/// Keeps a node in the graph. A subscription whose connection has failed, as it may where many nodes begin at
/// once, is deaf for ever to roscpp: it is made anew. And it brings a node back after its master was
/// restarted: a new master knows nothing of it, and roscpp does not tell it. Existing connections are not
/// touched, neither while the master is away nor when it returns: topics and services are registered anew by
/// the master's own interface, publications and services at once, and subscriptions when other nodes have had
/// time to do the same, so that no subscriber is told of a list in which a publisher is still missing. Works
/// in a thread of its own; the node's loop notices nothing.
class MasterWatch {
 public:
  /// Begins to watch; after ros::start(), that is after the first NodeHandle. `services` are the full names
  /// of those that the node offers; its topics are found. `on_return` is called in the watch's thread after
  /// the node has been registered anew: for parameters, which are lost with the master.
  explicit MasterWatch(std::vector<std::string> services = {}, std::function<void()> on_return = {});
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// Whether the master answered when it was last asked, once a second.
  bool is_reachable() const { return reachable_; }
  /// How often it came back.
  int returns() const { return returns_; }

 private:
  void watch();
  void look(bool for_the_deaf);
  void rest(double seconds) const;
  void register_anew();
  void connect_the_deaf();

  std::vector<std::string> services_;
  std::function<void()> on_return_;
  std::set<std::string> told_deaf_;  // topics; the watch's alone
  std::optional<int> process_;       // of the master that knows this node; likewise
  std::atomic<int> returns_{0};
  std::atomic<bool> reachable_{true};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace fairway::ros1
