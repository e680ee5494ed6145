// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "fairway/core/text.hpp"

namespace fairway {

namespace {

using V = const VehicleFrame&;

template <class E>
std::string word(E value) {
  return EnumNames<E>::names[static_cast<std::size_t>(value)];
}

std::string axis_text(const std::optional<Wrench>& wrench, int axis) {
  return wrench ? number_text((*wrench)[axis]) : std::string{};
}

constexpr std::array list{
    Quantity{"id", [](V v) { return std::to_string(number(v.id)); }},
    Quantity{"phase", [](V v) { return word(v.phase); }},
    Quantity{"x_m", [](V v) { return number_text(v.state.p_n.x()); }},
    Quantity{"y_m", [](V v) { return number_text(v.state.p_n.y()); }},
    Quantity{"z_m", [](V v) { return number_text(v.state.p_n.z()); }},
    Quantity{"qw_ratio", [](V v) { return number_text(v.state.q_nb.w()); }},
    Quantity{"qx_ratio", [](V v) { return number_text(v.state.q_nb.x()); }},
    Quantity{"qy_ratio", [](V v) { return number_text(v.state.q_nb.y()); }},
    Quantity{"qz_ratio", [](V v) { return number_text(v.state.q_nb.z()); }},
    Quantity{"roll_rad", [](V v) { return number_text(euler_of(v.state.q_nb).roll); }},
    Quantity{"pitch_rad", [](V v) { return number_text(euler_of(v.state.q_nb).pitch); }},
    Quantity{"yaw_rad", [](V v) { return number_text(euler_of(v.state.q_nb).yaw); }},
    Quantity{"u_mps", [](V v) { return number_text(v.state.v_b.x()); }},
    Quantity{"v_mps", [](V v) { return number_text(v.state.v_b.y()); }},
    Quantity{"w_mps", [](V v) { return number_text(v.state.v_b.z()); }},
    Quantity{"p_radps", [](V v) { return number_text(v.state.omega_b.x()); }},
    Quantity{"q_radps", [](V v) { return number_text(v.state.omega_b.y()); }},
    Quantity{"r_radps", [](V v) { return number_text(v.state.omega_b.z()); }},
    Quantity{"goal_n_m", [](V v) { return number_text(v.goal.x()); }},
    Quantity{"goal_e_m", [](V v) { return number_text(v.goal.y()); }},
    Quantity{"goal_d_m", [](V v) { return number_text(v.goal.z()); }},
    Quantity{"goal_speed_mps", [](V v) { return number_text(v.goal_speed); }},
    Quantity{"command_n_mps", [](V v) { return number_text(v.command.velocity.x()); }},
    Quantity{"command_e_mps", [](V v) { return number_text(v.command.velocity.y()); }},
    Quantity{"command_d_mps", [](V v) { return number_text(v.command.velocity.z()); }},
    Quantity{"command_heading_rad",
             [](V v) { return v.command.heading ? number_text(*v.command.heading) : std::string{}; }},
    Quantity{"command_turn_rate_radps",
             [](V v) { return v.command.turn_rate ? number_text(*v.command.turn_rate) : std::string{}; }},
    Quantity{"command_force_x_n", [](V v) { return axis_text(v.command.wrench, 0); }},
    Quantity{"command_force_y_n", [](V v) { return axis_text(v.command.wrench, 1); }},
    Quantity{"command_force_z_n", [](V v) { return axis_text(v.command.wrench, 2); }},
    Quantity{"command_moment_k_nm", [](V v) { return axis_text(v.command.wrench, 3); }},
    Quantity{"command_moment_m_nm", [](V v) { return axis_text(v.command.wrench, 4); }},
    Quantity{"command_moment_n_nm", [](V v) { return axis_text(v.command.wrench, 5); }},
    Quantity{"mode", [](V v) { return word(v.command.mode); }},
    Quantity{"astern", [](V v) { return std::string(v.command.astern ? "true" : "false"); }},
    Quantity{"power_w", [](V v) { return number_text(v.power); }},
    Quantity{"force_x_n", [](V v) { return number_text(v.wrench[0]); }},
    Quantity{"force_y_n", [](V v) { return number_text(v.wrench[1]); }},
    Quantity{"force_z_n", [](V v) { return number_text(v.wrench[2]); }},
    Quantity{"moment_k_nm", [](V v) { return number_text(v.wrench[3]); }},
    Quantity{"moment_m_nm", [](V v) { return number_text(v.wrench[4]); }},
    Quantity{"moment_n_nm", [](V v) { return number_text(v.wrench[5]); }},
};

}  // namespace

std::span<const Quantity> quantities() { return list; }

std::string instant_text(Tick tick, double time) {
  return fmt::format("tick {} ({:.10g} s)", count(tick), time);
}

std::optional<QuantityDifference> first_difference(const VehicleFrame& a, const VehicleFrame& b) {
  for (const Quantity& quantity : list) {
    std::string in_a = quantity.text(a);
    std::string in_b = quantity.text(b);
    if (in_a != in_b) return QuantityDifference{std::string(quantity.name), std::move(in_a), std::move(in_b)};
  }
  const std::size_t both = std::min(a.actuators.size(), b.actuators.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (same_bits(a.actuators[i], b.actuators[i])) continue;
    return QuantityDifference{"actuator_" + std::to_string(i), number_text(a.actuators[i]),
                              number_text(b.actuators[i])};
  }
  if (a.actuators.size() != b.actuators.size()) {
    return QuantityDifference{"actuator_count", std::to_string(a.actuators.size()),
                              std::to_string(b.actuators.size())};
  }
  return std::nullopt;
}

}  // namespace fairway
