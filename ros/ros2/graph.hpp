// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ros/bridge/messages.hpp"
#include "ros/ros2/messages.hpp"

namespace fairway::ros2 {

using bridge::Keep;

/// A node's place in the graph.
struct GraphOptions {
  std::string node{"fairway"};
  std::string space{"/"};  ///< the namespace; begins with a slash
  std::uint32_t domain{};
  bool loopback_only{};  ///< as ROS_LOCALHOST_ONLY=1; CYCLONEDDS_URI, where set, wins
  std::vector<std::pair<std::string, std::string>> remaps;  ///< from, to
};

/// The domain that ROS_DOMAIN_ID names, 0 without it. Throws std::runtime_error for what is not 0 to 232.
std::uint32_t domain_of_environment();
/// Whether ROS_LOCALHOST_ONLY is 1.
bool loopback_of_environment();

/// The full name in the graph: remapped, then `/absolute`, `~/of the node` or `in the namespace`.
std::string resolved(const GraphOptions& options, const std::string& topic);

/// Takes messages of one type to whoever listens. A handle; lives no longer than its graph.
template <class Message>
class Publisher {
 public:
  Publisher() = default;
  explicit Publisher(dds_entity_t writer) : writer_{writer} {}

  /// False where the message could not be sent: a reliable listener has not kept up for 20 ms.
  bool publish(const Message& message) const { return dds_write(writer_, &message) == DDS_RETCODE_OK; }
  /// Listeners that are matched now.
  std::size_t listeners() const {
    dds_publication_matched_status_t status{};
    return dds_get_publication_matched_status(writer_, &status) == DDS_RETCODE_OK ? status.current_count : 0;
  }
  /// Until every matched reliable listener's middleware has all that was sent, at most so long.
  bool wait_until_delivered(std::chrono::nanoseconds longest) const {
    return dds_wait_for_acks(writer_, longest.count()) == DDS_RETCODE_OK;
  }

 private:
  dds_entity_t writer_{};
};

/// A node in a ROS 2 graph: topics over Cyclone DDS with ROS 2's names, types and QoS, and its name as
/// `ros2 node list` reads it. One thread publishes and handles; publishers may be used from others.
class Graph {
 public:
  /// Throws std::runtime_error with what the middleware says.
  explicit Graph(GraphOptions options);
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;
  ~Graph();

  /// Reliable, and, where it is latched, transient local; so many as `Keep` says of it.
  template <class Message>
  Publisher<Message> advertise(const std::string& topic, Keep keep = Keep::few) {
    return Publisher<Message>{writer(topic, descriptor<Message>(), keep)};
  }

  /// `handle` is called by handle(), in the order of subscribing and, within a topic, of arrival. What is
  /// kept as `newest` comes of reliable and best effort publishers alike, as `latched` of latched ones and
  /// others, and else of reliable ones alone.
  template <class Message, class Handle>
  void subscribe(const std::string& topic, Keep keep, Handle handle, bool /*wakes*/ = true) {
    reader(topic, descriptor<Message>(), keep, [handle = std::move(handle)](const void* message) {
      handle(*static_cast<const Message*>(message));
    });
  }

  /// Tells the graph the node's name and its topics: when all of them are there.
  void announce();

  /// Waits for what arrives, no longer than this [s], and handles all messages, until none is left.
  void handle(double longest);
  /// Publishers that are matched to our subscription of `topic` now; 0 if there is none.
  std::size_t sources(const std::string& topic) const;

 private:
  struct Subscription;

  dds_entity_t writer(const std::string& topic, const dds_topic_descriptor_t& type, Keep keep);
  void reader(const std::string& topic, const dds_topic_descriptor_t& type, Keep keep,
              const std::function<void(const void*)>& handle);
  bool handle_some();
  dds_entity_t topic(const std::string& name, const dds_topic_descriptor_t& type);

  GraphOptions options_;
  dds_entity_t domain_{};
  dds_entity_t participant_{};
  dds_entity_t waitset_{};
  std::vector<dds_entity_t> writers_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  Publisher<ParticipantEntitiesInfo> discovery_;
};

}  // namespace fairway::ros2
