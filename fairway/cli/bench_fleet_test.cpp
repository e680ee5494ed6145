// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/bench_fleet.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fairway/core/testing/sanitizers.hpp"

namespace fairway::cli {
namespace {

/// Of the heap, the scenario included [B].
double bytes_a_vehicle(std::size_t count) {
  const Catalogs catalogs = builtin_catalogs();
  testing::internal::CaptureStdout();
  bench_fleets({count}, 0.01, 1, true, catalogs);
  const auto printed = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  return printed.at("fleet").at(0).at("bytes_per_vehicle");
}

TEST(BenchFleet, AVehicleOfALargeFleetTakesFourKilobytesAtMost) {
  if (FAIRWAY_ADDRESS_SANITIZED || FAIRWAY_THREAD_SANITIZED) GTEST_SKIP() << "they have a heap of their own";
  const double bytes = bytes_a_vehicle(1000);
  EXPECT_LE(bytes, 4000.0);
  EXPECT_GT(bytes, 2000.0);  // else it was not measured
}

}  // namespace
}  // namespace fairway::cli
