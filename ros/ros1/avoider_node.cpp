// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/avoider_node.hpp"

#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cctype>
#include <string>

#include "ros/bridge/watchdog.hpp"
#include "ros/ros1/avoider_report.hpp"
#include "ros/ros1/conversions.hpp"

namespace fairway::ros1 {
namespace {

constexpr double look_period_s = 0.2;      // at the own state, for changes to report
constexpr double diagnose_period_s = 1.0;  // without changes
constexpr double draw_period_s = 0.1;
constexpr double idle_s = 0.01;  // the loop comes round so often at least

double clock_now() { return seconds_of(ros::Time::now()); }

bool is_due(ros::SteadyTime& last, double period) {
  const ros::SteadyTime now = ros::SteadyTime::now();
  if ((now - last).toSec() < period) return false;
  last = now;
  return true;
}

/// A vehicle's name as topics have it.
std::string topic_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace

AvoiderNode::AvoiderNode(const ros::NodeHandle& vehicle, const AvoiderSettings& settings)
    : settings_{settings},
      vehicle_{settings.host.vehicle},
      host_{settings.host},
      gate_{1 + host_.team().size()},
      vehicle_node_{vehicle},
      mates_node_{vehicle},
      marks_{settings.frame, "world"} {
  // what mates tell waits until it is needed: to wake up for each of it would double the work. In lockstep
  // each may be the last that is missing.
  vehicle_node_.setCallbackQueue(&queue_);
  mates_node_.setCallbackQueue(settings_.lockstep ? &queue_ : &mates_queue_);
  advertise();
  subscribe();
}

void AvoiderNode::advertise() {
  ros::NodeHandle& own = vehicle_node_;
  command_ =
      own.advertise<geometry_msgs::TwistStamped>(settings_.advisory ? "advice" : "velocity_command", 10);
  diagnostics_ = own.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
  status_ = own.advertise<std_msgs::String>("status", 10);
  record_ = own.advertise<std_msgs::UInt8MultiArray>("team_record", 10);
  if (settings_.draw) sketch_ = own.advertise<visualization_msgs::MarkerArray>("sketch", 2);
  services_ = {own.advertiseService("go_to", &AvoiderNode::go_to, this),
               own.advertiseService("section", &AvoiderNode::follow_section, this),
               own.advertiseService("keep_position", &AvoiderNode::keep_position, this),
               own.advertiseService("stand_by", &AvoiderNode::stand_by, this)};
}

template <class Message, class Listener>
void AvoiderNode::hear(ros::NodeHandle& whose, const std::string& topic, std::uint32_t kept,
                       Listener listener) {
  const boost::function<void(const boost::shared_ptr<const Message>&)> listens =
      [listener](const boost::shared_ptr<const Message>& message) { listener(*message); };
  subscribers_.push_back(whose.subscribe<Message>(topic, kept, listens, ros::VoidConstPtr{},
                                                  ros::TransportHints().tcpNoDelay()));
}

void AvoiderNode::subscribe() {
  // an old odometry is of no use when a newer one is there, unless a fleet waits for the answer to each
  const std::uint32_t kept = settings_.lockstep ? 100 : 1;
  hear<nav_msgs::Odometry>(vehicle_node_, "odometry", kept,
                           [this](const nav_msgs::Odometry& m) { on_own_odometry(m); });
  hear<geometry_msgs::PoseStamped>(vehicle_node_, "goal", 10,
                                   [this](const geometry_msgs::PoseStamped& m) { on_goal(m); });
  hear<nav_msgs::Path>(vehicle_node_, "path", 10, [this](const nav_msgs::Path& m) { on_path(m); });
  if (settings_.test_hooks) {
    hear<std_msgs::Float64>(vehicle_node_, "test_hang", 1, [](const std_msgs::Float64& m) {
      ros::WallDuration{std::clamp(m.data, 0.0, 60.0)}.sleep();
    });
  }
  for (std::size_t i = 0; i < host_.team().size(); ++i) hear_mate(i, "/" + topic_name(host_.team()[i]), kept);
}

void AvoiderNode::hear_mate(std::size_t mate, const std::string& topics, std::uint32_t kept) {
  if (settings_.input != AvoiderInput::team_record) {
    hear<nav_msgs::Odometry>(mates_node_, topics + "/odometry", kept,
                             [this, mate](const nav_msgs::Odometry& m) { on_mate_odometry(mate, m); });
    hear<geometry_msgs::PoseStamped>(mates_node_, topics + "/goal", 10,
                                     [this, mate](const geometry_msgs::PoseStamped& m) {
                                       host_.neighbour_goal(mate, place_of(m.pose.position, settings_.frame));
                                     });
  }
  if (settings_.input != AvoiderInput::odometry) {
    hear<std_msgs::UInt8MultiArray>(mates_node_, topics + "/team_record", 10,
                                    [this](const std_msgs::UInt8MultiArray& m) { on_record(m); });
  }
}

std::vector<std::string> AvoiderNode::services() const {
  std::vector<std::string> names;
  for (const ros::ServiceServer& service : services_) names.push_back(service.getService());
  return names;
}

void AvoiderNode::run() {
  bridge::Watchdog watchdog{host_.watchdog_period(),
                            [this](double stood_still) { raise_alarm(stood_still); }};
  while (ros::ok()) {
    queue_.callAvailable(ros::WallDuration{idle_s});
    mates_queue_.callAvailable();
    watchdog.come_round();
    answer_now();
    tell_team(clock_.now());
    report(false);
  }
}

void AvoiderNode::on_own_odometry(const nav_msgs::Odometry& odometry) {
  const bridge::Motion motion = motion_of(odometry, settings_.frame);
  own_frame_ = odometry.header.frame_id;
  if (settings_.lockstep) {
    own_stamp_ = odometry.header.stamp;
    gate_.hear(0, motion);
    answer_together();
    return;
  }
  mates_queue_.callAvailable();
  const double now = clock_.at(clock_now(), motion.time);
  answer(now, judge_own(motion, now) ? odometry.header.stamp : stamp_of(now));
}

void AvoiderNode::on_mate_odometry(std::size_t mate, const nav_msgs::Odometry& odometry) {
  const bridge::Motion motion = motion_of(odometry, settings_.frame);
  if (settings_.lockstep) {
    gate_.hear(mate + 1, motion);
    answer_together();
    return;
  }
  judge_mate(mate, motion, clock_.at(clock_now(), motion.time));
}

void AvoiderNode::on_record(const std_msgs::UInt8MultiArray& record) {
  judge("a team record", host_.team_record(record.data.data(), record.data.size(), clock_.at(clock_now())));
}

bool AvoiderNode::judge_own(const bridge::Motion& motion, double now) {
  return judge("own odometry", host_.own_motion(motion, now));
}

void AvoiderNode::judge_mate(std::size_t mate, const bridge::Motion& motion, double now) {
  judge("odometry of " + host_.team()[mate], host_.neighbour_motion(mate, motion, now));
}

/// Whether it is accepted.
bool AvoiderNode::judge(const std::string& whose, const std::string& verdict) {
  if (verdict == "accepted") return true;
  ROS_WARN_STREAM_THROTTLE(5.0, whose << " is refused: " << verdict);
  return false;
}

/// Time is that of the messages, whatever the clock shows: everyone's of one instant are answered together.
void AvoiderNode::answer_together() {
  if (!gate_.opens()) return;
  const double now = clock_.begin(gate_.motion(0).time);
  judge_own(gate_.motion(0), now);
  for (std::size_t i = 0; i < host_.team().size(); ++i) judge_mate(i, gate_.motion(i + 1), now);
  answer(now, own_stamp_);
}

/// What is due without new navigation: policies act on what does not come.
void AvoiderNode::answer_now() {
  if (settings_.lockstep || ros::Time::now().isZero()) return;  // zero: a simulation that has not begun
  const double now = clock_.at(clock_now());
  const double since = now - host_.order().time;
  if (since >= 1.0 / settings_.rate_hz || since < 0.0) answer(now, stamp_of(now));
}

void AvoiderNode::answer(double now, const ros::Time& stamp) {
  const bridge::Order& order = host_.update(now, settings_.draw);
  in_charge_.store(order.in_charge, std::memory_order_relaxed);
  if (order.in_charge) {
    geometry_msgs::TwistStamped command = twist_of(order.request, now, settings_.frame, vehicle_);
    command.header.stamp = stamp;
    command_.publish(command);
  }
  if (settings_.draw && order.decided) show_marks();
  if (order.state + order.reason != reported_) report(true);
}

/// Where what was drawn is: in the frame of the own navigation.
void AvoiderNode::show_marks() {
  if (!is_due(drawn_, draw_period_s)) return;
  marks_.begin(clock_.now());
  for (const bridge::Mark& mark : host_.marks()) marks_.add_mark(mark);
  sketch_.publish(marks_.finish());
}

void AvoiderNode::tell_team(double now) {
  if (settings_.record_rate_hz <= 0.0 || (now < next_record_ && next_record_ - now < 100.0)) return;
  next_record_ = now + 1.0 / settings_.record_rate_hz;
  std_msgs::UInt8MultiArray record;
  record.data = host_.own_record(now);
  if (!record.data.empty()) record_.publish(record);
}

void AvoiderNode::report(bool at_once) {
  if (!is_due(looked_, at_once ? 0.0 : look_period_s)) return;
  const bridge::Order& order = host_.order();
  const bridge::Diagnosis before = std::move(diagnosis_);
  diagnosis_ = host_.diagnosis(clock_.now());
  reported_ = order.state + order.reason;
  const AvoiderCircumstances circumstances{vehicle_,     host_.algorithm(),  settings_.frame,
                                           clock_.now(), settings_.advisory, alarms_.load()};
  std_msgs::String status;
  status.data = status_json(order, diagnosis_, circumstances);
  status_.publish(status);
  if (is_due(diagnosed_, at_once || before.level != diagnosis_.level ? 0.0 : diagnose_period_s)) {
    diagnostics_.publish(diagnostics_of(diagnosis_, circumstances));
  }
}

/// In the thread of the watchdog: it touches nothing that the loop may be in the middle of.
void AvoiderNode::raise_alarm(double stood_still) {
  const std::int64_t alarms = alarms_.fetch_add(1) + 1;
  const bool sends = in_charge_.load(std::memory_order_relaxed) && !settings_.advisory;
  const double now = clock_now();
  if (sends) command_.publish(twist_of({}, now, settings_.frame, vehicle_));
  bridge::Diagnosis diagnosis;
  diagnosis.level = bridge::Diagnosis::Level::error;
  diagnosis.summary = "watchdog: the loop has stood still for " + std::to_string(stood_still) + " s" +
                      (sends ? "; the vehicle is told to stand still" : "");
  AvoiderCircumstances circumstances;
  circumstances.vehicle = vehicle_;
  circumstances.time = now;
  circumstances.advisory = settings_.advisory;
  circumstances.alarms = alarms;
  diagnostics_.publish(diagnostics_of(diagnosis, circumstances));
}

}  // namespace fairway::ros1
