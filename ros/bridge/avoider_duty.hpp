// SPDX-License-Identifier: Apache-2.0
// C++17. What the node of an avoider does, whatever its middleware.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/avoider_host.hpp"
#include "ros/bridge/node_settings.hpp"

namespace fairway::bridge {

/// Where the answers go: a middleware's publishers. All of it in fairway's frame.
class AvoiderOutlet {
 public:
  virtual ~AvoiderOutlet() = default;
  /// To the vehicle, or, while it only advises, to people. `time` is that of the navigation that is answered
  /// [s].
  virtual void send_command(const BodyVelocity& velocity, double time) = 0;
  virtual void send_record(const std::vector<std::uint8_t>& bytes) = 0;
  /// What the method says, in the place of the record.
  virtual void send_speech(const std::vector<std::uint8_t>& bytes) = 0;
  virtual void send_status(const std::string& json) = 0;
  virtual void send_diagnosis(const Diagnosis& diagnosis, double time) = 0;
  virtual void send_marks(const std::vector<Mark>& marks, double time) = 0;
  virtual void warn(const std::string& words) = 0;
};

/// Hears navigation and orders, and answers: at once what is new, in lockstep when everyone's navigation of
/// an instant is there, and by the clock what does not come. Messages only change what is known; settle(),
/// after all that had arrived was handed in, answers.
class AvoiderDuty {
 public:
  /// Throws std::runtime_error, in one line, for settings that cannot be used.
  AvoiderDuty(const AvoiderNodeSettings& settings, AvoiderOutlet& outlet);

  const AvoiderHost& host() const { return host_; }
  const std::string& vehicle() const { return settings_.vehicle; }

  // what it hears; `clock` is the graph's now [s]; places in NED
  void hear_own(const Motion& motion, const std::string& frame_id, double clock);
  void hear_mate(std::size_t mate, const Motion& motion, double clock);
  void hear_mate_goal(std::size_t mate, const Triple& place, double stamp);
  void hear_record(const std::uint8_t* bytes, std::size_t size, double clock);
  void hear_speech(std::size_t mate, const std::uint8_t* bytes, std::size_t size, double clock);

  // What it shall do; in lockstep from the instant on that it is stamped with, be that still to come or just
  // answered; stamped 0, at once. Each says why it is refused, which warns too; empty if it is accepted.
  // `speed` [m/s]; 0: as set up.
  std::string go_to(const Triple& place, const std::string& frame_id, double stamp, double speed = 0.0);
  /// `frame_ids` are those of the path and of its places, which are one but for those that are empty.
  std::string follow(const std::vector<Triple>& places, const std::vector<std::string>& frame_ids,
                     double stamp);
  /// At once, along the line from `start` to `end` [m, NED].
  std::string follow_section(const Triple& start, const Triple& end, double speed);
  // The same by a topic, where a latched message comes again with every new connection: one that is the last
  // of its topic that was taken once more, stamp and all, is passed over with a warning.
  void hear_goal(const Triple& place, const std::string& frame_id, double stamp);
  void hear_path(const std::vector<Triple>& places, const std::vector<std::string>& frame_ids, double stamp);
  void keep_position();
  void stand_by();

  /// After everything that had arrived: the answers that are due to it.
  void settle(double clock);
  /// Now and then, at least every hundredth of a second: what is due by the clock, and reports.
  void come_round(double clock);
  /// Called by a watchdog's thread when the loop has stood still for so long [s].
  void raise_alarm(double stood_still, double clock);

 private:
  double clock_at(double clock);
  double clock_at(double clock, double stamp);
  void begin_again(double now);
  void judge(const std::string& whose, const char* verdict);
  struct Task {
    const char* word{};          // "goal", "section" or "path"
    std::vector<Triple> places;  // [m, NED]
    double stamp{};              // [s]
    double speed{};              // [m/s]; 0: as set up
  };
  std::string accept(const Task& task, const std::string& frame_id);
  std::string take_up(Task task);
  bool is_told_again(const std::optional<Task>& last, const Task& task) const;
  void drop_task();
  std::string refused(const Task& task, const std::string& why) const;
  void hear_told();
  void hear_frame(const std::string& frame_id);
  void answer(double now, double stamp);
  void tell_team(double now);
  void report(bool at_once);
  std::string status(const Order& order) const;
  Diagnosis with_counts(Diagnosis diagnosis) const;

  using Steady = std::chrono::steady_clock;
  struct Told {
    std::size_t mate{};
    Triple place{};  // [m, NED]
    double stamp{};  // [s]
  };

  AvoiderNodeSettings settings_;
  AvoiderOutlet& outlet_;
  AvoiderHost host_;
  double now_{};                               // [s]
  std::string own_frame_;                      // of the own odometry, empty before the first
  std::string goal_frame_;                     // of what it was told before that to do
  std::optional<double> own_;                  // time of the own navigation last accepted [s]
  std::optional<double> answered_;             // in lockstep, the last instant answered [s]
  std::optional<Task> next_task_;              // in lockstep, of an instant that is still to come
  std::vector<Told> told_;                     // in lockstep, what is known from the next instant on
  std::optional<Task> last_goal_, last_path_;  // that were heard by their topics
  bool told_too_far_{};                        // it was warned that it is
  bool lets_go_{};                             // it was told to leave the vehicle to others
  bool is_news_{};                             // own navigation has come since the last answer
  double next_record_{};                       // [s]
  std::string reported_;                       // state and reason last reported
  Diagnosis diagnosis_;                        // last looked at
  Steady::time_point looked_, diagnosed_, drawn_, warned_, frame_warned_;
  std::atomic<std::int64_t> refused_{0};
  std::atomic<std::int64_t> alarms_{0};
  std::atomic<bool> in_charge_{false};
};

}  // namespace fairway::bridge
