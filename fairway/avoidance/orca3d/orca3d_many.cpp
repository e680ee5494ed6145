// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "fairway/avoidance/orca3d/columns.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"

namespace fairway {
namespace {

/// Without symmetry nothing is drawn.
Command decide_alone(const Orca3d& orca, const Situation& s) noexcept {
  Rng rng{0};
  Context context{rng};
  NoMemory memory;
  return orca.decide(s, memory, context);
}

/// As many vehicles as a kernel has lanes, or fewer.
class InLanes {
 public:
  InLanes(const Orca3d& orca, double period, const lanes::Kernel& kernel) : orca_{orca}, kernel_{kernel} {
    crowd_.time_horizon = orca.params.time_horizon_s;
    crowd_.period = period;
  }

  /// False if there is something about it that a kernel does not know.
  bool add(const Situation& s, Command& command) {
    std::array<const Track*, lanes::most_in_lanes + 1> near;
    const std::size_t count = orca::find_neighbours(s, orca_.params, near);
    if (!s.obstacles.empty() || orca_.params.interval(s) != crowd_.period || count > lanes::most_in_lanes)
      return false;
    if (count == 0) {
      command = {.velocity = s.preferred_velocity(), .mode = Mode::cruise};
      return true;
    }
    write_vehicle(lanes_, s.own, math::fmin(s.limits.max_speed, orca::fastest), s.preferred_velocity());
    for (std::size_t k = 0; k < count; ++k)
      orca::write_neighbour(s, orca_.params, *near[k], kernel_.lanes, neighbour(k) + lanes_);
    crowd_.neighbours = std::max(crowd_.neighbours, count);
    counts_[lanes_] = count;
    commands_[lanes_++] = &command;
    return true;
  }

  void decide() {
    if (lanes_ == 0) return;
    const std::size_t width = kernel_.lanes;
    for (std::size_t lane = lanes_; lane < width; ++lane) write_vehicle(lane, {}, 0.0, Vec3::Zero());
    for (std::size_t lane = 0; lane < width; ++lane)
      for (std::size_t k = counts_[lane]; k < crowd_.neighbours; ++k)
        orca::write_nobody(width, neighbour(k) + lane);
    alignas(64) std::array<double, 4 * lanes::most_lanes> answer;
    kernel_.decide(crowd_, answer.data());
    for (std::size_t lane = 0; lane < lanes_; ++lane) {
      const Vec3 velocity{answer[lane], answer[width + lane], answer[2 * width + lane]};
      *commands_[lane] = orca::command_of({velocity, answer[3 * width + lane]});
    }
  }

 private:
  void write_vehicle(std::size_t lane, const Ownship& own, double max_speed, const Vec3& preferred) {
    const std::size_t width = kernel_.lanes;
    orca::write_columns(own.position, own.velocity, own.radius, max_speed, width, crowd_.own + lane);
    for (std::size_t c = 0; c < 3; ++c)
      crowd_.preferred[c * width + lane] = preferred[static_cast<Eigen::Index>(c)];
  }
  double* neighbour(std::size_t k) { return crowd_.others + k * lanes::columns * kernel_.lanes; }

  lanes::Crowd crowd_;  // on the stack
  const Orca3d& orca_;
  const lanes::Kernel& kernel_;
  std::size_t lanes_ = 0;
  std::array<std::size_t, lanes::most_lanes> counts_{};
  std::array<Command*, lanes::most_lanes> commands_;
};

}  // namespace

bool Orca3d::decides_with(const Orca3d& other) const noexcept {
  return params.symmetry == Symmetry::none && (this == &other || params == other.params);
}

void Orca3d::decide_many(std::span<const Situation* const> situations,
                         std::span<Command* const> commands) const noexcept {
  const lanes::Kernel& kernel = lanes::kernel_for(situations.size());
  for (std::size_t first = 0; first < situations.size(); first += kernel.lanes) {
    InLanes in_lanes{*this, params.interval(*situations[first]), kernel};
    const std::size_t end = std::min(situations.size(), first + kernel.lanes);
    for (std::size_t i = first; i < end; ++i)
      if (!in_lanes.add(*situations[i], *commands[i])) *commands[i] = decide_alone(*this, *situations[i]);
    in_lanes.decide();
  }
}

}  // namespace fairway
