// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/uuv/silence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fairway/studies/cubes/cube_case.hpp"

namespace fairway::uuv {
namespace {

constexpr std::array<std::string_view, 3> cubes_crossed{"cube20_4", "cube20_8", "cube60_8"};

Choice exchange_of(const Channel& channel) {
  Choice exchange{.name = "perfect", .path = "exchange"};
  if (channel.kind == Channel::Kind::perfect) return exchange;
  exchange.name = "acoustic";
  if (channel.kind == Channel::Kind::modem) {
    exchange.params = {{"slots", true}, {"rate_law", std::string("measured")}};
    return exchange;
  }
  exchange.params = {{"update_rate_hz", channel.update_rate_hz},
                     {"loss_ratio", channel.loss_ratio},
                     {"slots", false},
                     {"range_m", 1000.0},
                     {"bit_rate_bps", 1e9}};
  return exchange;
}

}  // namespace

std::string Channel::name() const {
  if (kind == Kind::perfect) return "perfect";
  if (kind == Kind::modem) return "modem";
  return fmt::format("{} Hz, loss {}", update_rate_hz, loss_ratio);
}

std::span<const std::string_view> silent_cubes() { return cubes_crossed; }

std::span<const Method> silence_methods() {
  static const std::vector<Method> methods{
      {"apf", "apf", {}},
      {"orca3d", "orca3d", {}},
      {"apf+stop_and_wait", "apf+stop_and_wait", {}},
      {"orca3d+stop_and_wait", "orca3d+stop_and_wait", {}},
      {"apf+inflate", "apf+inflate", {}},
      {"orca3d+inflate", "orca3d+inflate", {}},
      {"apf_w2_2.5", "apf", {{"w2_ratio", 2.5}}},
      {"apf_w2_2.5+inflate", "apf+inflate", {{"w2_ratio", 2.5}}},
  };
  return methods;
}

Scenario silence_scenario(std::string_view cube, const Method& method, const Channel& channel,
                          std::uint64_t seed) {
  const auto published_case = std::ranges::find(cubes::comparison_cases(), cube, &cubes::CubeCase::name);
  Scenario scenario = cubes::cube_scenario(*published_case, method, cubes::Code::corrected,
                                           cubes::comparison_tuning(*published_case, method), seed);
  scenario.name = fmt::format("{} {} {}", cube, method.name, channel.name());
  scenario.exchange = exchange_of(channel);
  return scenario;
}

}  // namespace fairway::uuv
