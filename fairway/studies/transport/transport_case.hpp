// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

#include "fairway/scenario/scenario.hpp"
#include "fairway/studies/cell.hpp"

namespace fairway::transport {

/// Which equations stand for the transport system. The publication gives neither its numbers nor its terms.
enum class Plant {
  physical,      ///< linear and quadratic drag, Coriolis terms, corrected yaw inertia
  paper_compat,  ///< linear drag alone and no Coriolis terms, chosen after seeing the published results
};
inline constexpr std::array plants{Plant::paper_compat, Plant::physical};
std::string_view name_of(Plant plant);

/// The two published cases (rehman2021, sections IV-A and IV-B), and the second with an obstacle on the way
/// that no chart shows.
enum class Case { one_obstacle, four_obstacles, unknown_obstacle };
std::string_view name_of(Case which);

/// What a published run was made with.
struct PublishedRun {
  Case which{};
  Method method;
  double duration_s{};  ///< as long as the publication shows
};

/// The four published runs: hard switching and wall following around one obstacle, wall following and the
/// trajectory through the waypoints of Table 7 among four.
std::span<const PublishedRun> published_runs();

/// The published value of a quantity, or nothing.
std::optional<double> published(Case which, std::string_view method, std::string_view quantity);

/// What is solid, and the goal.
std::vector<ObstacleSpec> obstacles_of(Case which);
Vec3 goal_of(Case which);

/// The published run: at rest at the origin with heading north, forces held for 0.02 s, to the end of the
/// published time; nothing ends it earlier. Forces are shared out by the pseudo-inverse.
Scenario scenario_of(const PublishedRun& run, Plant plant);

/// Obstacles of any kind to be passed by any method, on the physical plant: 0.05 s, up to `duration_s`, done
/// 1 m from the goal.
Scenario voyage(std::string_view name, const Method& method, std::vector<ObstacleSpec> obstacles,
                const Vec3& goal, double duration_s, std::uint64_t seed);

inline constexpr double voyage_duration = 900.0;  ///< of what is compared beyond the publication [s]

/// A case passed by any method, for up to `voyage_duration`.
Scenario case_voyage(Case which, const Method& method);

}  // namespace fairway::transport
