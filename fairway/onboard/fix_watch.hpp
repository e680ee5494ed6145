// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "fairway/onboard/fix.hpp"
#include "fairway/onboard/policy.hpp"

namespace fairway {

/// Judges the fixes of one vehicle as they come and keeps the last good one. A value; does not allocate.
class FixWatch {
 public:
  /// The verdict on `fix`, which came when the clock showed `now` [s]. O(1).
  FixVerdict see(const Fix& fix, double now, const OnboardPolicy& policy) noexcept;

  /// The last one accepted, as it came; none before the first.
  const std::optional<Fix>& last() const { return last_; }

  /// Since the last one accepted [s]; infinite before the first.
  double age(double now) const noexcept;

  /// Since when all have been accepted without a gap of more than `own_stale_s` [s]; infinite while not.
  double good_since() const { return good_since_; }

  /// When the last one was refused, by the clock of the helm [s]; minus infinity if none was.
  double refused_at() const { return refused_at_; }

  /// How many had each verdict.
  std::int64_t count(FixVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }

  /// The verdict on the latest fix; `accepted` before the first.
  FixVerdict verdict() const { return verdict_; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  FixVerdict judge(const Fix& fix, double now, const OnboardPolicy& policy) noexcept;
  FixVerdict judge_jump(const Fix& fix, const OnboardPolicy& policy) noexcept;
  void accept(const Fix& fix, const OnboardPolicy& policy) noexcept;

  std::optional<Fix> last_;
  std::optional<Fix> candidate_;  ///< the latest that jumped
  int confirmations_{0};
  double claims_since_{infinity};  ///< since when it claims to move, and the position stands [s]
  bool frozen_{false};             ///< the position was found frozen, and no other has been accepted since
  double good_since_{infinity};
  double refused_at_{-infinity};
  FixVerdict verdict_{FixVerdict::accepted};
  std::array<std::int64_t, EnumNames<FixVerdict>::names.size()> counts_{};
};

}  // namespace fairway
