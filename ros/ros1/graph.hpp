// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ros/bridge/messages.hpp"

namespace fairway::ros1 {

using bridge::Keep;

/// Takes messages of one type to whoever listens.
template <class Message>
class Publisher {
 public:
  Publisher() = default;
  explicit Publisher(const ros::Publisher& publisher) : publisher_{publisher} {}

  void publish(const Message& message) const { publisher_.publish(message); }
  std::size_t listeners() const { return publisher_.getNumSubscribers(); }

 private:
  ros::Publisher publisher_;
};

/// A node's topics and services. What comes in is handled by handle(), in the thread that calls it.
class Graph {
 public:
  Graph() {
    node_.setCallbackQueue(&queue_);
    idle_node_.setCallbackQueue(&idle_queue_);
  }
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  template <class Message>
  Publisher<Message> advertise(const std::string& topic, Keep keep = Keep::few) {
    constexpr std::array<std::uint32_t, 4> kept{10, 2, 100, 10};
    const std::uint32_t size = kept[static_cast<std::size_t>(keep)];
    return Publisher<Message>{node_.advertise<Message>(topic, size, keep == Keep::latched)};
  }

  /// A message that does not wake waits until another comes, or until handle() has waited long enough.
  template <class Message, class Handle>
  void subscribe(const std::string& topic, Keep keep, Handle handle, bool wakes = true) {
    constexpr std::array<std::uint32_t, 4> kept{10, 1, 100, 10};
    const boost::function<void(const boost::shared_ptr<const Message>&)> listens =
        [handle](const boost::shared_ptr<const Message>& message) { handle(*message); };
    ros::NodeHandle& node = wakes ? node_ : idle_node_;
    subscribers_.emplace_back(
        topic, node.subscribe<Message>(topic, kept[static_cast<std::size_t>(keep)], listens,
                                       ros::VoidConstPtr{}, ros::TransportHints().tcpNoDelay()));
  }

  template <class Service, class Answer>
  void offer(const std::string& name, Answer answer) {
    using Request = typename Service::Request;
    using Response = typename Service::Response;
    const boost::function<bool(Request&, Response&)> call = [answer](Request& request, Response& response) {
      answer(request, response);
      return true;
    };
    services_.push_back(node_.advertiseService(name, call));
  }

  /// The full names of the services.
  std::vector<std::string> services() const {
    std::vector<std::string> names;
    for (const ros::ServiceServer& service : services_) names.push_back(service.getService());
    return names;
  }

  /// Publishers of a topic that is subscribed to; 0 if it is not.
  std::size_t sources(const std::string& topic) const {
    for (const auto& [name, subscriber] : subscribers_)
      if (name == topic) return subscriber.getNumPublishers();
    return 0;
  }

  /// Waits for what arrives, no longer than this [s], and handles all of it.
  void handle(double longest) {
    queue_.callAvailable(ros::WallDuration{longest});
    idle_queue_.callAvailable();
  }

 private:
  ros::CallbackQueue queue_, idle_queue_;
  ros::NodeHandle node_, idle_node_;
  std::vector<std::pair<std::string, ros::Subscriber>> subscribers_;  // by topic
  std::vector<ros::ServiceServer> services_;
};

}  // namespace fairway::ros1
