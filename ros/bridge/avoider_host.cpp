// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/avoider_host.hpp"

#include <algorithm>
#include <span>

#include "fairway/avoidance/drawing.hpp"
#include "ros/bridge/avoider_parts.hpp"
#include "ros/bridge/avoider_setup.hpp"

namespace fairway::bridge {

Fix fix_of(const Motion& motion) {
  const auto& [w, x, y, z] = motion.q_nb;
  return {.time = motion.time,
          .state = {.p_n = vec_of(motion.position_n),
                    .q_nb = Eigen::Quaterniond{w, x, y, z},
                    .v_b = vec_of(motion.v_b),
                    .omega_b = vec_of(motion.omega_b)},
          .position_sigma = motion.position_sigma};
}

Triple triple_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 vec_of(const Triple& v) { return {v[0], v[1], v[2]}; }

struct AvoiderHost::Self {
  explicit Self(AvoiderSetup setup)
      : obstacles{std::move(setup.obstacles)},
        algorithm{std::move(setup.algorithm)},
        helm{std::move(setup.pilot), std::move(setup.helm), std::move(setup.avoider)} {
    for (const TeamMate& mate : helm.setup().team) team.push_back(mate.name);
  }

  const TeamMate& mate(std::size_t index) const { return helm.setup().team[index]; }

  /// From the point that was reached to the next of the path; false at its end.
  bool go_on() {
    if (reached + 1 >= path.size()) return false;
    const Leg leg{.kind = LegKind::section,
                  .position = vec_of(path[reached + 1]),
                  .from = vec_of(path[reached]),
                  .speed_mps = speed,
                  .arrival_m = helm.setup().arrival};
    ++reached;
    return helm.follow(leg);
  }

  void forget_path() {
    path.clear();
    reached = 0;
  }

  std::vector<ObstacleSpec> obstacles;  // hold the vertices of the helm's chart
  std::string algorithm;
  Helm helm;
  std::vector<std::string> team;
  std::vector<Triple> path;
  std::size_t reached{};  // of the path: the point that it goes to, or is at
  double speed{};         // along the path [m/s]
  Drawing drawing;
  Order order;
};

AvoiderHost::AvoiderHost(const AvoiderOptions& options)
    : self_{std::make_unique<Self>(avoider_setup(options))} {}
AvoiderHost::AvoiderHost(AvoiderHost&&) noexcept = default;
AvoiderHost& AvoiderHost::operator=(AvoiderHost&&) noexcept = default;
AvoiderHost::~AvoiderHost() = default;

const std::vector<std::string>& AvoiderHost::team() const { return self_->team; }
double AvoiderHost::period() const { return self_->helm.pilot().period(); }
double AvoiderHost::watchdog_period() const { return self_->helm.setup().policy.watchdog_s; }
std::string AvoiderHost::algorithm() const { return self_->algorithm; }
bool AvoiderHost::speaks() const { return self_->helm.speaks(); }

const char* AvoiderHost::own_motion(const Motion& motion, double now) {
  return enum_name(self_->helm.own_fix(fix_of(motion), now));
}

const char* AvoiderHost::neighbour_motion(std::size_t mate, const Motion& motion, double now) {
  if (mate >= self_->team.size()) return enum_name(FixVerdict::invalid);
  return enum_name(self_->helm.neighbour_fix(self_->mate(mate).id, fix_of(motion), now));
}

void AvoiderHost::neighbour_goal(std::size_t mate, const std::optional<Triple>& goal) {
  if (mate >= self_->team.size()) return;
  self_->helm.neighbour_goal(self_->mate(mate).id, goal ? std::optional{vec_of(*goal)} : std::nullopt);
}

const char* AvoiderHost::team_record(const std::uint8_t* bytes, std::size_t size, double now) {
  return enum_name(self_->helm.team_record({bytes, size}, now));
}

bool AvoiderHost::speech(std::size_t mate, const std::uint8_t* bytes, std::size_t size, double now) {
  return mate < self_->team.size() && self_->helm.speech(self_->mate(mate).id, {bytes, size}, now, now);
}

void AvoiderHost::turns(double next, double period) { self_->helm.turns(next, period); }

bool AvoiderHost::go_to(const Triple& position_n, double speed_mps) {
  if (!self_->helm.go_to(vec_of(position_n), speed_mps)) return false;
  self_->forget_path();
  return true;
}

bool AvoiderHost::follow(const Triple& from_n, const Triple& to_n, double speed_mps) {
  const Leg leg{.kind = LegKind::section,
                .position = vec_of(to_n),
                .from = vec_of(from_n),
                .speed_mps = speed_mps,
                .arrival_m = self_->helm.setup().arrival};
  if (!self_->helm.follow(leg)) return false;
  self_->forget_path();
  return true;
}

bool AvoiderHost::follow_path(const std::vector<Triple>& points_n, double speed_mps) {
  // every leg is tried on a copy, so that a path is taken whole or not at all
  Helm trial = self_->helm;
  if (points_n.empty() || !trial.go_to(vec_of(points_n.front()), speed_mps)) return false;
  for (const Triple& point : points_n) {
    if (!trial.go_to(vec_of(point), speed_mps)) return false;
  }
  self_->path = points_n;
  self_->path.erase(std::unique(self_->path.begin(), self_->path.end()), self_->path.end());
  self_->reached = 0;
  self_->speed = speed_mps;
  return self_->helm.go_to(vec_of(points_n.front()), speed_mps);
}

void AvoiderHost::keep_position() {
  self_->forget_path();
  self_->helm.keep_position();
}

void AvoiderHost::stand_by() {
  self_->forget_path();
  self_->helm.stand_by();
}

bool AvoiderHost::is_complete(double time) const { return self_->helm.common_time() >= time - 1e-9; }

const Order& AvoiderHost::update(double now, bool draw) {
  Self& self = *self_;
  Drawing drawing;
  Sketch* const sketch = draw ? &drawing : nullptr;
  const HelmOrder* given = &self.helm.update(now, sketch);
  while (given->state == HelmState::arrived && self.go_on()) given = &self.helm.update(now, sketch);
  if (given->decided || !draw) self.drawing = std::move(drawing);

  const BodyRequest& request = given->request;
  self.order = {.time = given->time,
                .in_charge = given->in_charge,
                .decided = given->decided,
                .request = {request.surge_mps, request.sway_mps, request.heave_mps, request.yaw_rate_radps},
                .velocity_n = triple_of(given->command.velocity),
                .mode = enum_name(given->command.mode),
                .state = enum_name(given->state),
                .reason = std::string(given->reason)};
  return self.order;
}

const Order& AvoiderHost::order() const { return self_->order; }

bool AvoiderHost::is_too_far_to_tell() const { return !can_be_told(self_->helm.own().position); }

std::vector<std::uint8_t> AvoiderHost::own_record(double now) const {
  const std::optional<TeamRecord> record = self_->helm.own_record(now);
  return record ? std::vector<std::uint8_t>(record->begin(), record->end()) : std::vector<std::uint8_t>{};
}

std::vector<std::uint8_t> AvoiderHost::own_speech() const {
  const Speech speech = self_->helm.own_speech();
  return {speech.view().begin(), speech.view().end()};
}

Diagnosis AvoiderHost::diagnosis(double now) const { return diagnosis_of(self_->helm, now); }

std::vector<Mark> AvoiderHost::marks() const {
  return marks_of(self_->drawing, self_->helm.own(), self_->helm.pilot().ship().limits->max_speed);
}

std::optional<Triple> AvoiderHost::goal() const {
  const std::optional<Vec3> goal = self_->helm.goal();
  return goal ? std::optional{triple_of(*goal)} : std::nullopt;
}

}  // namespace fairway::bridge
