// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_duty.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace fairway::bridge {
namespace {

constexpr std::chrono::milliseconds look_period{200};       // at the own state, for changes to report
constexpr std::chrono::milliseconds diagnose_period{1000};  // without changes
constexpr std::chrono::milliseconds draw_period{100};
constexpr std::chrono::seconds warn_period{5};
constexpr double restart_s = 1.0;  // what tells the time and is behind by more has begun again
constexpr double early_s = 0.1;    // a clock that is behind navigation by so much is still on its way
constexpr double lead_s = 60.0;    // a fleet that waits for nobody may be ahead by so much
constexpr double lockstep_patience_s = 1.0;  // then it answers although somebody is missing

bool is_due(std::chrono::steady_clock::time_point& last, std::chrono::steady_clock::duration period) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last < period) return false;
  last = now;
  return true;
}

std::string bare(const std::string& frame_id) {
  return !frame_id.empty() && frame_id.front() == '/' ? frame_id.substr(1) : frame_id;
}

std::string in_other_frame(const std::string& frame_id, const std::string& own) {
  return "it is in the frame '" + frame_id + "'; own odometry is in '" + own + "'";
}

/// What about an order cannot be carried out.
std::string fault_of(const std::vector<Triple>& places, double speed) {
  const auto is_place = [](const Triple& place) {
    return std::all_of(place.begin(), place.end(), [](double x) { return std::isfinite(x); });
  };
  if (!std::all_of(places.begin(), places.end(), is_place)) return "a position is not a number";
  if (!(speed > 0.0) || !std::isfinite(speed))
    return "a speed of " + std::to_string(speed) + " m/s; expected more than 0";
  return places.empty() ? "no position is given" : "out of what the avoider accepts";
}

}  // namespace

AvoiderDuty::AvoiderDuty(const AvoiderNodeSettings& settings, AvoiderOutlet& outlet)
    : settings_{settings}, outlet_{outlet}, host_{settings} {}

/// The time to go by: the graph's clock, but never behind navigation that has come: the clock of a simulation
/// and its odometry travel apart, so either may be first. In lockstep navigation is the clock, as long as it
/// comes: the other may be long on its way, as a fleet that waits for nobody else is fast.
double AvoiderDuty::clock_at(double clock) {
  if (settings_.lockstep) return clock - now_ < lockstep_patience_s ? now_ : now_ = clock;
  if (clock < now_ - restart_s) begin_again(clock);
  return now_ = std::max(now_, clock);
}

void AvoiderDuty::begin_again(double now) {
  now_ = now;
  last_goal_.reset();
  last_path_.reset();
}

double AvoiderDuty::clock_at(double clock, double stamp) {
  const double now = clock_at(clock);
  const double early = settings_.lockstep ? lead_s : early_s;
  return now_ = stamp > now && stamp <= clock + early ? stamp : now;
}

void AvoiderDuty::hear_own(const Motion& motion, const std::string& frame_id, double clock) {
  hear_frame(frame_id);
  if (settings_.lockstep && motion.time < now_ - restart_s) begin_again(motion.time);
  const std::string_view verdict = host_.own_motion(motion, clock_at(clock, motion.time));
  judge("own odometry", verdict.data());
  if (verdict == "accepted") own_ = motion.time;
  is_news_ = true;
}

/// What it was told to do before it knew its own frame may turn out to be in another, and so may everything
/// if the frame becomes another.
void AvoiderDuty::hear_frame(const std::string& frame_id) {
  if (frame_id.empty()) return;
  const std::string before = std::exchange(own_frame_, frame_id);
  if (!before.empty() && bare(before) != bare(own_frame_)) {
    goal_frame_.clear();
    if (is_due(frame_warned_, warn_period))
      outlet_.warn("what it was told to do is dropped: own odometry was in the frame '" + before +
                   "' and is in '" + own_frame_ + "' now");
    return drop_task();
  }
  if (goal_frame_.empty()) return;
  const std::string told_in = std::exchange(goal_frame_, "");
  if (bare(told_in) == bare(own_frame_)) return;
  outlet_.warn("what it was told to do is dropped: " + in_other_frame(told_in, own_frame_));
  drop_task();
}

void AvoiderDuty::hear_mate(std::size_t mate, const Motion& motion, double clock) {
  judge("odometry of " + host_.team()[mate],
        host_.neighbour_motion(mate, motion, clock_at(clock, motion.time)));
}

/// In a simulation, what is told at an instant is heard at the next: in lockstep likewise here, whichever
/// message comes first.
void AvoiderDuty::hear_mate_goal(std::size_t mate, const Triple& place, double stamp) {
  if (settings_.lockstep) {
    told_.push_back({mate, place, stamp});
  } else {
    host_.neighbour_goal(mate, place);
  }
}

void AvoiderDuty::hear_record(const std::uint8_t* bytes, std::size_t size, double clock) {
  judge("a team record", host_.team_record(bytes, size, clock_at(clock)));
}

void AvoiderDuty::hear_speech(std::size_t mate, const std::uint8_t* bytes, std::size_t size, double clock) {
  const bool is_heard = host_.speech(mate, bytes, size, clock_at(clock));
  judge("what " + host_.team()[mate] + " says", is_heard ? "accepted" : "invalid");
}

void AvoiderDuty::judge(const std::string& whose, const char* verdict) {
  if (std::string_view{verdict} == "accepted") return;
  ++refused_;
  if (is_due(warned_, warn_period)) outlet_.warn(whose + " is refused: " + verdict);
}

std::string AvoiderDuty::refused(const Task& task, const std::string& why) const {
  outlet_.warn(std::string{"a "} + task.word + " is refused: " + why);
  return "refused: " + why;
}

/// A place in another frame than that of the own navigation is not what it seems to be.
std::string AvoiderDuty::accept(const Task& task, const std::string& frame_id) {
  if (!frame_id.empty() && !own_frame_.empty() && bare(frame_id) != bare(own_frame_))
    return refused(task, in_other_frame(frame_id, own_frame_));
  if (own_frame_.empty()) goal_frame_ = frame_id;
  if (settings_.lockstep && own_ && task.stamp > *own_ && task.stamp <= *own_ + lead_s) {
    next_task_ = task;
    return "";
  }
  return take_up(task);
}

std::string AvoiderDuty::take_up(Task task) {
  next_task_.reset();
  const std::string_view word = task.word;
  const std::vector<Triple>& places = task.places;
  if (task.speed == 0.0) task.speed = settings_.speed_mps;
  const bool accepted = word == "path"      ? host_.follow_path(places, task.speed)
                        : word == "section" ? host_.follow(places[0], places[1], task.speed)
                                            : host_.go_to(places[0], task.speed);
  if (!accepted) return refused(task, fault_of(places, task.speed));
  if (task.stamp == 0.0 || answered_ == task.stamp) answered_.reset();
  return "";
}

std::string AvoiderDuty::go_to(const Triple& place, const std::string& frame_id, double stamp, double speed) {
  return accept({"goal", {place}, stamp, speed}, frame_id);
}

std::string AvoiderDuty::follow(const std::vector<Triple>& places, const std::vector<std::string>& frame_ids,
                                double stamp) {
  const Task task{"path", places, stamp, 0.0};
  std::string frame;
  for (const std::string& other : frame_ids) {
    if (frame.empty()) frame = other;
    if (!other.empty() && bare(other) != bare(frame))
      return refused(task, "it is in the frames '" + frame + "' and '" + other + "'");
  }
  return accept(task, frame);
}

std::string AvoiderDuty::follow_section(const Triple& start, const Triple& end, double speed) {
  return take_up({"section", {start, end}, 0.0, speed});
}

bool AvoiderDuty::is_told_again(const std::optional<Task>& last, const Task& task) const {
  const bool again = last && last->places == task.places && last->stamp == task.stamp;
  if (again)
    outlet_.warn(
        std::string{"a "} + task.word +
        " is passed over: it is the last one again, as comes with a new connection; one that is meant "
        "anew has another stamp");
  return again;
}

void AvoiderDuty::hear_goal(const Triple& place, const std::string& frame_id, double stamp) {
  const Task task{"goal", {place}, stamp, 0.0};
  if (!is_told_again(last_goal_, task) && go_to(place, frame_id, stamp).empty()) last_goal_ = task;
}

void AvoiderDuty::hear_path(const std::vector<Triple>& places, const std::vector<std::string>& frame_ids,
                            double stamp) {
  const Task task{"path", places, stamp, 0.0};
  if (!is_told_again(last_path_, task) && follow(places, frame_ids, stamp).empty()) last_path_ = task;
}

void AvoiderDuty::keep_position() {
  next_task_.reset();
  answered_.reset();
  host_.keep_position();
}

void AvoiderDuty::stand_by() {
  lets_go_ = true;
  drop_task();
}

void AvoiderDuty::drop_task() {
  next_task_.reset();
  host_.stand_by();
}

void AvoiderDuty::settle(double clock) {
  if (settings_.lockstep) {
    if (!own_ || answered_ == own_ || !host_.is_complete(*own_)) return;
    if (next_task_ && next_task_->stamp <= *own_) take_up(*next_task_);
    hear_told();
    answered_ = own_;
    answer(clock_at(clock), *own_);
  } else if (is_news_) {
    const double now = clock_at(clock);
    const bool is_fresh = own_ && *own_ > host_.order().time;
    answer(now, is_fresh ? *own_ : now);
  }
  is_news_ = false;
}

/// The goals that mates told before this instant.
void AvoiderDuty::hear_told() {
  const auto earlier =
      std::stable_partition(told_.begin(), told_.end(), [this](const Told& t) { return t.stamp >= *own_; });
  for (auto told = earlier; told != told_.end(); ++told) host_.neighbour_goal(told->mate, told->place);
  told_.erase(earlier, told_.end());
}

void AvoiderDuty::come_round(double clock) {
  const double now = clock_at(clock);
  const double patience = settings_.lockstep ? lockstep_patience_s : 1.0 / settings_.rate_hz;
  if (now - host_.order().time >= patience || now < host_.order().time) answer(now, now);
  tell_team(now);
  report(false);
}

void AvoiderDuty::answer(double now, double stamp) {
  const Order& order = host_.update(now, settings_.draw);
  const bool was_in_charge = in_charge_.exchange(order.in_charge, std::memory_order_relaxed);
  if (order.in_charge) {
    outlet_.send_command(order.request, stamp);
  } else if (was_in_charge && !lets_go_) {
    outlet_.send_command({}, stamp);  // what was asked for last is not meant any more
  }
  lets_go_ = false;
  if (settings_.draw && order.decided && is_due(drawn_, draw_period)) outlet_.send_marks(host_.marks(), now);
  if (order.state + order.reason != reported_) report(true);
}

void AvoiderDuty::tell_team(double now) {
  constexpr double long_ago = 100.0;  // [s]: the clock has begun again
  if (settings_.record_rate_hz <= 0.0 || (now < next_record_ && next_record_ - now < long_ago)) return;
  const double period = 1.0 / settings_.record_rate_hz;
  next_record_ = now + period;
  host_.turns(next_record_, period);
  const std::vector<std::uint8_t> speech = host_.own_speech();
  if (!speech.empty()) return outlet_.send_speech(speech);
  const std::vector<std::uint8_t> record = host_.own_record(now);
  if (!record.empty()) return outlet_.send_record(record);
  if (!std::exchange(told_too_far_, host_.is_too_far_to_tell()) && told_too_far_)
    outlet_.warn(
        "no team record is sent: it is farther from the origin of its frame than one can tell, "
        "83.9 km; the team needs an origin near by");
}

void AvoiderDuty::report(bool at_once) {
  if (!is_due(looked_, at_once ? Steady::duration{} : look_period)) return;
  const Order& order = host_.order();
  const Diagnosis::Level before = diagnosis_.level;
  diagnosis_ = host_.diagnosis(now_);
  reported_ = order.state + order.reason;
  outlet_.send_status(status(order));
  if (is_due(diagnosed_, at_once || before != diagnosis_.level ? Steady::duration{} : diagnose_period))
    outlet_.send_diagnosis(with_counts(diagnosis_), now_);
}

Diagnosis AvoiderDuty::with_counts(Diagnosis diagnosis) const {
  diagnosis.values.insert(diagnosis.values.begin(), {{"algorithm", host_.algorithm()},
                                                     {"advisory", settings_.advisory ? "true" : "false"},
                                                     {"refused_count", std::to_string(refused_.load())},
                                                     {"watchdog_count", std::to_string(alarms_.load())}});
  return diagnosis;
}

std::string AvoiderDuty::status(const Order& order) const {
  const Frame frame = settings_.frame;
  nlohmann::json values = nlohmann::json::object();
  for (const auto& [key, value] : diagnosis_.values) values[key] = value;
  const nlohmann::json status{
      {"vehicle", vehicle()},
      {"algorithm", host_.algorithm()},
      {"time_s", now_},
      {"advisory", settings_.advisory},
      {"in_charge", order.in_charge},
      {"state", order.state},
      {"mode", order.mode},
      {"reason", order.reason},
      {"summary", diagnosis_.summary},
      {"velocity_mps", world_in(frame, order.velocity_n)},
      {"command_mps",
       body_in(frame, {order.request.surge_mps, order.request.sway_mps, order.request.heave_mps})},
      {"yaw_rate_radps", body_in(frame, {0, 0, order.request.yaw_rate_radps})[2]},
      {"refused_count", refused_.load()},
      {"watchdog_count", alarms_.load()},
      {"values", values},
  };
  return status.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// It touches nothing that the loop may be in the middle of.
void AvoiderDuty::raise_alarm(double stood_still, double clock) {
  alarms_.fetch_add(1);
  const bool sends = in_charge_.load(std::memory_order_relaxed) && !settings_.advisory;
  if (sends) outlet_.send_command({}, clock);
  Diagnosis diagnosis;
  diagnosis.level = Diagnosis::Level::error;
  diagnosis.summary = "watchdog: the loop has stood still for " + std::to_string(stood_still) + " s" +
                      (sends ? "; the vehicle is told to stand still" : "");
  outlet_.send_diagnosis(with_counts(diagnosis), clock);
}

}  // namespace fairway::bridge
