// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"
#include "fairway/studies/uuv/hull.hpp"

namespace fairway::uuv {

/// The two encounters of cao2022, and the second as it would be with the goals that its text leaves open
/// chosen the other way. The paper's x is east and its y north, so that right stays right.
enum class Encounter {
  head_on,         ///< section 4.1: two UUVs change places
  multi_obstacle,  ///< section 4.2: two UUVs whose ways cross, three ships across both
  parallel_goals,  ///< the same with ways that do not cross; not adopted
};
inline constexpr std::array encounters{Encounter::head_on, Encounter::multi_obstacle,
                                       Encounter::parallel_goals};
std::string_view name_of(Encounter encounter);

/// What the paper does not say and its times hardly determine.
struct Setting {
  std::string_view name;
  double speed_mps;          ///< wanted
  double acceleration_mps2;  ///< of the point that is the UUV
  double start_speed_mps;    ///< towards the goal
  double uuv_radius_m;
  double ship_radius_m;
  double time_horizon_s;
};

/// Those under which an RVO comes near the published times: `fit_head_on` and `fit_ships` the nearest for
/// each encounter, `common` one for both, on which the other methods are compared.
std::span<const Setting> settings();

/// Throws std::out_of_range.
const Setting& find_setting(std::string_view name);

/// Where everyone is and wants to be [m, NED].
struct Meeting {
  std::array<Vec3, 2> starts, goals;
  std::vector<Vec3> ships;
  std::array<double, 2> start_delays_s{};
  Vec3 ship_velocity = Vec3::Zero();
};

/// As published.
Meeting meeting_of(Encounter encounter);

/// Starts and ships by up to 2 m, along north and east, each UUV up to 1 s late, the ships' speed by 10 % and
/// their course by 0.1 rad. The variations of one seed are the same for every method.
Meeting varied(Encounter encounter, std::uint64_t seed);

/// The scenario: ships drift and give way to nobody, UUVs may go up to the published 10 m/s, and decide ten
/// times a second.
Scenario encounter_scenario(Encounter encounter, const Meeting& meeting, const Setting& setting, Hull hull,
                            const Method& method, std::uint64_t seed);

/// Methods that work in the plane, the paper's first. Those of velocity obstacles and ORCA take the setting's
/// horizon; AVOA's lengths and speeds are scaled from 1.5 m/s to 10.
std::span<const Method> planar_methods();

/// The unicycle for methods that steer by heading, else the point.
Hull hull_of(const Method& method);

}  // namespace fairway::uuv
