// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

#include "fairway/core/params.hpp"
#include "fairway/core/testing/refusal.hpp"

namespace fairway::testing {

/// Expects that `make` takes the defaults, and refuses each number of `P` by its name when it is none, or
/// lies beyond its range.
template <Reflected P, class Make>
void expect_ranges_kept(Make&& make) {
  const auto refusal = [&](const P& params) { return refusal_by([&] { make(params); }); };
  EXPECT_EQ(refusal(P{}), "accepted");
  for_each_field<P>([&](const auto& f) {
    P params;
    using Member = std::remove_cvref_t<decltype(params.*(f.member))>;
    const std::string refused = std::string(f.name) + ": is ";
    if constexpr (std::is_same_v<Member, double>) {
      params.*(f.member) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_TRUE(refusal(params).starts_with(refused + "nan; expected a number in [")) << refusal(params);
      params.*(f.member) = std::nextafter(f.range.lo, -std::numeric_limits<double>::infinity());
      EXPECT_TRUE(refusal(params).starts_with(refused)) << f.name << ": " << refusal(params);
    } else if constexpr (std::is_same_v<Member, int>) {
      params.*(f.member) = static_cast<int>(f.range.lo) - 1;
      EXPECT_TRUE(refusal(params).starts_with(refused)) << f.name << ": " << refusal(params);
    }
  });
}

}  // namespace fairway::testing
