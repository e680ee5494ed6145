// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ros/ros2/messages.hpp"

namespace fairway::ros2 {

/// How a topic is kept and sent. The defaults are ROS 2's.
struct Qos {
  bool reliable{true};
  bool latched{false};  ///< transient local: who comes late gets the last ones
  std::int32_t depth{10};
  /// For subscriptions: takes what latched publishers sent before, and what others send. DDS has no such
  /// subscription: it is two, and what comes by both is handled once.
  bool either{false};
};

inline constexpr Qos default_qos{};
inline constexpr Qos latched_qos{true, true, 1};
inline constexpr Qos either_qos{true, false, 10, true};
/// For subscriptions: takes what reliable and best effort publishers send.
inline constexpr Qos sensor_qos{false, false, 10};

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

  template <class Message>
  Publisher<Message> advertise(const std::string& topic, const Qos& qos = default_qos) {
    return Publisher<Message>{writer(topic, descriptor<Message>(), qos)};
  }

  /// `handle` is called by handle_all(), in the order of subscribing and, within a topic, of arrival.
  template <class Message, class Handle>
  void subscribe(const std::string& topic, Handle handle, const Qos& qos = default_qos) {
    reader(topic, descriptor<Message>(), qos, [handle = std::move(handle)](const void* message) {
      handle(*static_cast<const Message*>(message));
    });
  }

  /// Tells the graph the node's name and its topics: when all of them are there.
  void announce();

  /// Waits until a message is there or wake() was called, at most so long.
  void wait(std::chrono::nanoseconds longest);
  void wake();
  /// Handles all messages that are there, until none is left. Returns how many.
  std::size_t handle_all();
  /// Publishers that are matched to our subscription of `topic` now; 0 if there is none.
  std::size_t sources(const std::string& topic) const;

  const GraphOptions& options() const { return options_; }

 private:
  struct Subscription;
  using Seen = std::map<dds_instance_handle_t, dds_time_t>;  // the last message of each publisher

  dds_entity_t writer(const std::string& topic, const dds_topic_descriptor_t& type, const Qos& qos);
  void reader(const std::string& topic, const dds_topic_descriptor_t& type, const Qos& qos,
              std::function<void(const void*)> handle);
  void reader(const std::string& topic, const dds_topic_descriptor_t& type, const Qos& qos,
              std::function<void(const void*)> handle, std::shared_ptr<Seen> seen);
  dds_entity_t topic(const std::string& name, const dds_topic_descriptor_t& type);

  GraphOptions options_;
  dds_entity_t domain_{};
  dds_entity_t participant_{};
  dds_entity_t waitset_{};
  dds_entity_t guard_{};
  std::vector<dds_entity_t> writers_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  Publisher<ParticipantEntitiesInfo> discovery_;
};

}  // namespace fairway::ros2
