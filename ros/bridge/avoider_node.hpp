// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/avoider_duty.hpp"
#include "ros/bridge/messages.hpp"
#include "ros/bridge/watchdog.hpp"

namespace fairway::bridge {

/// The avoider of one vehicle in a graph: its topics, which are the same in every middleware. A node adds its
/// clock, and what it is told by other means.
template <class Middleware>
class AvoiderNode : public AvoiderOutlet {
 public:
  /// Until `goes_on` says no.
  void run(const std::function<bool()>& goes_on) {
    constexpr double round_s = 0.01;  // the loop comes round so often at least
    Watchdog watchdog{duty_.host().watchdog_period(), [this](double stood_still) {
                        if (const auto clock = now()) duty_.raise_alarm(stood_still, *clock);
                      }};
    while (goes_on()) {
      graph_.handle(round_s);
      watchdog.come_round();
      const auto clock = now();
      if (!clock) continue;  // a simulation that has not begun
      duty_.settle(*clock);
      duty_.come_round(*clock);
    }
  }

 protected:
  using Graph = typename Middleware::Graph;
  using Clock = typename Middleware::Clock;

  /// Throws std::runtime_error, in one line, for settings that cannot be used. `simulated`: the graph's clock
  /// is a simulation's. `options` are the graph's.
  template <class... Options>
  AvoiderNode(const AvoiderNodeSettings& settings, bool simulated, const Options&... options)
      : settings_{timed(settings, simulated)}, duty_{settings_, *this}, graph_{options...} {
    command_ = graph_.template advertise<TwistStamped>(settings.advisory ? "advice" : "velocity_command");
    diagnostics_ = graph_.template advertise<DiagnosticArray>("/diagnostics");
    status_ = graph_.template advertise<String>("status");
    record_ = graph_.template advertise<UInt8MultiArray>("team_record");
    if (duty_.host().speaks()) speech_ = graph_.template advertise<UInt8MultiArray>("speech");
    if (settings.draw) sketch_ = graph_.template advertise<MarkerArray>("sketch", Keep::newest);
  }

  /// The graph's now [s]; nothing before the first of a simulation's clock.
  virtual std::optional<double> now() const = 0;

  void hear_orders() {
    graph_.template subscribe<PoseStamped>("goal", Keep::latched, [this](const PoseStamped& m) {
      duty_.hear_goal(place(m), m.header.frame_id, seconds(m));
    });
    graph_.template subscribe<Path>("path", Keep::few, [this](const Path& m) {
      std::vector<Triple> places;
      std::vector<std::string> frames{m.header.frame_id};
      for (const PoseStamped& pose : Middleware::elements(m.poses)) {
        places.push_back(place(pose));
        frames.emplace_back(pose.header.frame_id);
      }
      duty_.hear_path(places, frames, seconds(m));
    });
  }

  /// After the orders: where they are known, they are known before the navigation of their instant.
  void hear_fleet() {
    for (std::size_t mate = 0; mate < duty_.host().team().size(); ++mate) hear_mate(mate);
    graph_.template subscribe<Odometry>("odometry", navigation(), [this](const Odometry& m) {
      world_ = m.header.frame_id;
      own_stamp_ = Middleware::nanoseconds(m.header.stamp);
      if (const auto clock = now()) duty_.hear_own(motion_of<Middleware>(m, settings_.frame), world_, *clock);
    });
  }

  AvoiderNodeSettings settings_;
  AvoiderDuty duty_;
  Graph graph_;

 private:
  using DiagnosticArray = typename Middleware::DiagnosticArray;
  using MarkerArray = typename Middleware::MarkerArray;
  using Odometry = typename Middleware::Odometry;
  using Path = typename Middleware::Path;
  using PoseStamped = typename Middleware::PoseStamped;
  using String = typename Middleware::String;
  using TwistStamped = typename Middleware::TwistStamped;
  using UInt8MultiArray = typename Middleware::UInt8MultiArray;
  template <class Message>
  using Publisher = typename Middleware::template Publisher<Message>;

  static AvoiderNodeSettings timed(AvoiderNodeSettings settings, bool simulated) {
    settings.wall_clock = !simulated;
    return settings;
  }

  Triple place(const PoseStamped& m) const { return place_of(m.pose.position, settings_.frame); }
  template <class Message>
  static double seconds(const Message& m) {
    return seconds_of(Middleware::nanoseconds(m.header.stamp));
  }
  /// An old odometry is of no use when a newer one is there, unless a fleet waits for the answer to each.
  Keep navigation() const { return settings_.lockstep ? Keep::many : Keep::newest; }

  /// What mates tell waits until it is needed: to wake up for each of it would double the work. In lockstep
  /// each may be the last that is missing.
  void hear_mate(std::size_t mate) {
    const std::string topics = "/" + topic_name(duty_.host().team()[mate]);
    const bool wakes = settings_.lockstep;
    if (settings_.input != AvoiderInput::team_record) {
      const auto on_goal = [this, mate](const PoseStamped& m) {
        duty_.hear_mate_goal(mate, place(m), seconds(m));
      };
      const auto on_odometry = [this, mate](const Odometry& m) {
        if (const auto clock = now())
          duty_.hear_mate(mate, motion_of<Middleware>(m, settings_.frame), *clock);
      };
      graph_.template subscribe<PoseStamped>(topics + "/goal", Keep::latched, on_goal, wakes);
      graph_.template subscribe<Odometry>(topics + "/odometry", navigation(), on_odometry, wakes);
    }
    if (settings_.input != AvoiderInput::odometry) {
      const auto on_record = [this](const UInt8MultiArray& m) {
        const auto& bytes = Middleware::elements(m.data);
        if (const auto clock = now()) duty_.hear_record(bytes.data(), bytes.size(), *clock);
      };
      graph_.template subscribe<UInt8MultiArray>(topics + "/team_record", Keep::few, on_record, wakes);
    }
    if (duty_.host().speaks()) {
      const auto on_speech = [this, mate](const UInt8MultiArray& m) {
        const auto& bytes = Middleware::elements(m.data);
        if (const auto clock = now()) duty_.hear_speech(mate, bytes.data(), bytes.size(), *clock);
      };
      graph_.template subscribe<UInt8MultiArray>(topics + "/speech", Keep::few, on_speech, wakes);
    }
  }

  /// The watchdog's thread sends commands and diagnoses too: what they are made of does not change.
  Writer<Middleware> writer() const { return Writer<Middleware>{settings_.frame}; }
  void send_command(const BodyVelocity& velocity, double time) final {
    auto writer = this->writer();
    auto command = writer.twist(velocity, time, topic_name(duty_.vehicle()));
    // seconds of the wall's clock have no nanoseconds: whoever waits for a stamp gets the one that came
    if (seconds_of(own_stamp_) == time) command.header.stamp = Middleware::stamp(own_stamp_);
    command_.publish(command);
  }
  void send_record(const std::vector<std::uint8_t>& bytes) final { record_.publish(writer().record(bytes)); }
  void send_speech(const std::vector<std::uint8_t>& bytes) final { speech_.publish(writer().record(bytes)); }
  void send_status(const std::string& json) final { status_.publish(writer().text(json)); }
  void send_diagnosis(const Diagnosis& diagnosis, double time) final {
    diagnostics_.publish(writer().diagnosis(diagnosis, duty_.vehicle(), time));
  }
  void send_marks(const std::vector<Mark>& marks, double time) final {
    sketch_.publish(Writer<Middleware>{settings_.frame, world_}.markers(marks, time, duty_.vehicle()));
  }

  Publisher<TwistStamped> command_;
  Publisher<DiagnosticArray> diagnostics_;
  Publisher<String> status_;
  Publisher<UInt8MultiArray> record_;
  Publisher<UInt8MultiArray> speech_;
  Publisher<MarkerArray> sketch_;
  std::string world_{"world"};              // of the own odometry, as soon as it is known
  std::atomic<std::int64_t> own_stamp_{0};  // of the own odometry [ns]
};

}  // namespace fairway::bridge
