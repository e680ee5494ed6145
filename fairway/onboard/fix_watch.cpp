// SPDX-License-Identifier: Apache-2.0
#include "fairway/onboard/fix_watch.hpp"

#include <cmath>

#include "fairway/core/math.hpp"

namespace fairway {
namespace {

// beyond these no number is a vehicle's, whatever it is
constexpr double absurd_position = 1e7;  // [m]
constexpr double absurd_speed = 100.0;   // [m/s]
constexpr double absurd_turn = 100.0;    // [rad/s]
constexpr double attitude_error = 1e-3;  // of the quaternion's length

bool is_plausible(const Fix& fix) {
  const VehicleState& x = fix.state;
  const Vec3 through_water_b = fix.through_water_b.value_or(Vec3::Zero());
  return std::isfinite(fix.time) && is_finite(through_water_b) && fix.position_sigma >= 0.0 &&
         fix.position_sigma <= absurd_position && through_water_b.cwiseAbs().maxCoeff() <= absurd_speed &&
         is_finite(x) && x.p_n.cwiseAbs().maxCoeff() <= absurd_position &&
         x.v_b.cwiseAbs().maxCoeff() <= absurd_speed && x.omega_b.cwiseAbs().maxCoeff() <= absurd_turn &&
         std::fabs(x.q_nb.norm() - 1.0) <= attitude_error;
}

/// Whether a vehicle that was at `before` can be at `after`.
bool agrees(const Fix& before, const Fix& after, const OnboardPolicy& policy) {
  const double elapsed = after.time - before.time;
  const Vec3 expected = before.state.p_n + elapsed * before.state.v_n();
  return (after.state.p_n - expected).norm() <= policy.jump_m + policy.jump_speed_mps * elapsed;
}

}  // namespace

FixVerdict FixWatch::see(const Fix& fix, double now, const OnboardPolicy& policy) noexcept {
  verdict_ = judge(fix, now, policy);
  ++counts_[static_cast<std::size_t>(verdict_)];
  if (verdict_ == FixVerdict::accepted) {
    accept(fix, policy);
  } else {
    good_since_ = infinity;
    refused_at_ = now;
  }
  return verdict_;
}

FixVerdict FixWatch::judge(const Fix& fix, double now, const OnboardPolicy& policy) noexcept {
  if (!is_plausible(fix)) return FixVerdict::invalid;
  if (fix.time > now + policy.max_ahead_s) return FixVerdict::ahead;
  if (!last_) return FixVerdict::accepted;
  if (fix.time <= last_->time) return FixVerdict::backwards;

  const bool stands = fix.state.p_n == last_->state.p_n;
  const bool claims_to_move = fix.state.v_b.norm() > policy.frozen_speed_mps;
  claims_since_ = stands && claims_to_move ? math::fmin(claims_since_, last_->time) : infinity;
  if (stands && (frozen_ || fix.time - claims_since_ >= policy.frozen_s)) {
    frozen_ = true;
    return FixVerdict::frozen;
  }
  return agrees(*last_, fix, policy) ? FixVerdict::accepted : judge_jump(fix, policy);
}

FixVerdict FixWatch::judge_jump(const Fix& fix, const OnboardPolicy& policy) noexcept {
  if (candidate_ && fix.time <= candidate_->time) return FixVerdict::backwards;
  confirmations_ = candidate_ && agrees(*candidate_, fix, policy) ? confirmations_ + 1 : 1;
  candidate_ = fix;
  return confirmations_ >= policy.jump_confirmations_count ? FixVerdict::accepted : FixVerdict::jumped;
}

void FixWatch::accept(const Fix& fix, const OnboardPolicy& policy) noexcept {
  const bool follows = last_ && fix.time - last_->time <= policy.own_stale_s;
  if (!follows || good_since_ == infinity) good_since_ = fix.time;
  last_ = fix;
  frozen_ = false;
  candidate_.reset();
  confirmations_ = 0;
}

double FixWatch::age(double now) const noexcept { return last_ ? now - last_->time : infinity; }

}  // namespace fairway
