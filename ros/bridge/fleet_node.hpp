// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ros/bridge/fleet_duty.hpp"
#include "ros/bridge/fleet_marks.hpp"
#include "ros/bridge/messages.hpp"

namespace fairway::bridge {

/// A scenario as a live fleet in a graph: its topics, which are the same in every middleware. A node adds how
/// the run is paused. One thread: what comes in is handled between the steps.
template <class Middleware>
class FleetNode : public FleetOutlet {
 public:
  /// As FleetDuty::run(), or until `goes_on` says no.
  int run(std::function<bool()> goes_on) {
    goes_on_ = std::move(goes_on);
    return duty_.run(*this);
  }

 protected:
  using PoseStamped = typename Middleware::PoseStamped;
  template <class Message>
  using Publisher = typename Middleware::template Publisher<Message>;

  /// Throws std::runtime_error, in one line, for a scenario that cannot be used. `options` are the graph's.
  template <class... Options>
  explicit FleetNode(const FleetNodeSettings& settings, const Options&... options)
      : duty_{settings}, graph_{options...}, marks_{duty_.fleet()} {
    clock_ = graph_.template advertise<Clock>("/clock");
    transforms_ = graph_.template advertise<TFMessage>("/tf", Keep::many);
    markers_ = graph_.template advertise<MarkerArray>("/fairway/markers", Keep::newest);
    state_ = graph_.template advertise<String>("/fairway/state", Keep::latched);
    for (std::size_t i = 0; i < duty_.fleet().size(); ++i) {
      const std::string topics = "/" + duty_.fleet().vehicle(i).topic;
      ports_.push_back({graph_.template advertise<Odometry>(topics + "/odometry", Keep::many),
                        graph_.template advertise<Odometry>(topics + "/ground_truth", Keep::many),
                        graph_.template advertise<PoseStamped>(topics + "/goal", Keep::latched)});
    }
  }

  void hear_commands() {
    if (duty_.settings().autonomous) return;
    for (std::size_t i = 0; i < ports_.size(); ++i) {
      const auto on_command = [this, i](const TwistStamped& m) {
        duty_.command(i, velocity_of(m.twist, duty_.settings().frame),
                      Middleware::nanoseconds(m.header.stamp));
      };
      graph_.template subscribe<TwistStamped>(command_topic(i), Keep::many, on_command);
    }
  }

  struct Port {
    Publisher<typename Middleware::Odometry> odometry, truth;
    Publisher<PoseStamped> goal;
  };

  FleetDuty duty_;
  typename Middleware::Graph graph_;
  std::vector<Port> ports_;  // by vehicle

 private:
  using Clock = typename Middleware::Clock;
  using MarkerArray = typename Middleware::MarkerArray;
  using Odometry = typename Middleware::Odometry;
  using String = typename Middleware::String;
  using TFMessage = typename Middleware::TFMessage;
  using TwistStamped = typename Middleware::TwistStamped;

  Writer<Middleware> writer() const { return Writer<Middleware>{duty_.settings().frame}; }
  const std::string& topic(std::size_t vehicle) const { return duty_.fleet().vehicle(vehicle).topic; }
  std::string command_topic(std::size_t vehicle) const { return "/" + topic(vehicle) + "/velocity_command"; }

  void show_clock(double time) final {
    Clock clock{};
    clock.clock = Writer<Middleware>::stamp(time);
    clock_.publish(clock);
  }
  void show_goal(std::size_t vehicle, const Triple& goal, double time) final {
    ports_[vehicle].goal.publish(writer().goal(goal, time));
  }
  void show_navigation() final {
    for (std::size_t i = 0; i < ports_.size(); ++i)
      ports_[i].odometry.publish(writer().odometry(duty_.fleet().vehicle(i).estimate, topic(i)));
  }
  void show_truth() final {
    auto writer = this->writer();
    TFMessage transforms{};
    auto&& room = writer.room(transforms.transforms, ports_.size());
    for (std::size_t i = 0; i < ports_.size(); ++i) {
      const Motion& truth = duty_.fleet().vehicle(i).truth;
      ports_[i].truth.publish(writer.odometry(truth, topic(i)));
      room[i] = writer.transform(truth, topic(i));
    }
    transforms_.publish(transforms);
    marks_.see(duty_.fleet());
  }
  void show_state(const std::string& json) final { state_.publish(writer().text(json)); }
  void show_picture() final {
    if (markers_.listeners() == 0) return;
    markers_.publish(writer().markers(marks_.draw(duty_.fleet()), duty_.fleet().time(), "fairway"));
  }
  std::size_t listeners(std::size_t vehicle) final { return ports_[vehicle].odometry.listeners(); }
  bool is_steered(std::size_t vehicle) final { return graph_.sources(command_topic(vehicle)) > 0; }
  void handle(double longest) final { graph_.handle(longest); }
  bool goes_on() final { return goes_on_(); }

  FleetMarks marks_;
  std::function<bool()> goes_on_;
  Publisher<Clock> clock_;
  Publisher<TFMessage> transforms_;
  Publisher<MarkerArray> markers_;
  Publisher<String> state_;
};

}  // namespace fairway::bridge
