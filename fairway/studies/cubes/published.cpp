// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/cubes/published.hpp"

#include <algorithm>
#include <array>

#include "fairway/studies/cubes/cube_case.hpp"

namespace fairway::cubes {
namespace {

using namespace parameter_phase;

constexpr PublishedCell published_cells[]{
    {"cube20_4", "apf", {79.6, 1.77}, {13.5, 0.93}, {2.9, 0.22}, {38.2, 0.56}, 0, 0, 0},
    {"cube20_4", "orca3d", {77.6, 1.63}, {72.3, 2.28}, {3.0, 0.00}, {30.4, 0.40}, 0, 0, 0},
    {"cube20_4", "apf+saw", {116.5, 10.82}, {46.7, 9.04}, {7.5, 1.25}, {45.8, 2.59}, 0, 0, 0},
    {"cube20_4", "orca3d+saw", {144.8, 0.44}, {141.3, 0.25}, {3.1, 0.22}, {28.7, 0.26}, 0, 0, 0},
    {"cube20_8", "apf", {151.7, 15.45}, {65.6, 10.34}, {15.9, 2.50}, {69.7, 5.91}, 6, 2, 0},
    {"cube20_8", "orca3d", {116.5, 9.74}, {116.6, 9.74}, {7.0, 0.19}, {40.0, 1.98}, 4, 2, 0},
    {"cube20_8", "apf+saw", {217.9, 26.56}, {129.5, 22.76}, {26.2, 3.35}, {70.0, 4.60}, 0, 0, 0},
    {"cube20_8", "orca3d+saw", {371.0, 66.84}, {371.0, 66.83}, {8.2, 1.50}, {33.8, 4.30}, 0, 0, 4},
    {"cube20_8_retuned", "apf", {176.6, 37.56}, {82.7, 24.54}, {20.9, 7.72}, {80.0, 17.11}, 0, 0, 0},
    {"cube20_8_retuned", "orca3d", {131.9, 14.07}, {132.0, 14.06}, {7.1, 0.15}, {42.7, 3.21}, 0, 0, 0},
    {"cube20_8_retuned", "apf+saw", {397.4, 104.75}, {275.8, 86.28}, {51.5, 15.81}, {112.1, 23.41}, 0, 0, 0},
    {"cube20_8_retuned", "orca3d+saw", {322.5, 4.05}, {322.5, 4.05}, {8.9, 0.22}, {34.9, 0.16}, 0, 0, 0},
    {"cube60_4", "apf", {218.9, 3.75}, {23.3, 0.69}, {5.5, 1.01}, {114.6, 1.68}, 0, 0, 0},
    {"cube60_4", "orca3d", {227.4, 4.71}, {80.3, 5.46}, {3.0, 0.00}, {103.1, 1.41}, 0, 0, 0},
    {"cube60_4", "apf+saw", {213.1, 0.22}, {19.5, 0.13}, {3.5, 0.00}, {107.8, 0.10}, 0, 0, 0},
    {"cube60_4", "orca3d+saw", {303.9, 0.72}, {141.0, 0.64}, {3.6, 0.11}, {101.5, 0.06}, 0, 0, 0},
    {"cube60_8", "apf", {311.0, 30.01}, {86.4, 19.69}, {22.8, 5.86}, {153.7, 12.38}, 8, 2, 0},
    {"cube60_8", "orca3d", {255.3, 4.51}, {124.5, 3.90}, {6.9, 0.14}, {107.3, 1.23}, 4, 2, 0},
    {"cube60_8", "apf+saw", {359.6, 52.46}, {131.0, 41.98}, {29.1, 10.00}, {150.2, 15.56}, 0, 0, 0},
    {"cube60_8", "orca3d+saw", {470.6, 6.12}, {340.5, 6.26}, {10.3, 0.54}, {105.3, 0.19}, 0, 0, 0},
    {"cube60_8_retuned", "apf", {319.6, 14.40}, {92.9, 11.10}, {23.2, 2.14}, {158.2, 7.03}, 0, 0, 0},
    {"cube60_8_retuned", "orca3d", {260.4, 10.96}, {130.7, 10.74}, {7.1, 0.11}, {108.2, 1.97}, 0, 0, 0},
    {"cube60_8_retuned", "apf+saw", {400.1, 21.59}, {163.2, 17.99}, {35.6, 5.59}, {160.2, 6.47}, 0, 0, 0},
    {"cube60_8_retuned", "orca3d+saw", {478.0, 9.32}, {348.0, 9.40}, {10.3, 0.44}, {105.4, 0.30}, 0, 0, 0},
};

/// By CRIT_DIST, then ORI_ERROR; columns W2 [s].
constexpr double apf_times[12][3]{
    {104.4, 176.3, 257.1}, {92.3, 109.6, 130.3},  {78.7, 91.1, 104.3},   {113.4, 163.9, 320.3},
    {102.2, 119.4, 185.2}, {92.3, 104.4, 129.3},  {285.3, 520.8, 555.9}, {229.3, 365.1, 369.5},
    {143.2, 248.3, 338.0}, {564.6, 592.0, 592.1}, {587.3, 592.7, 591.3}, {558.9, 593.0, 592.1},
};
constexpr int apf_stuck[12][3]{{0, 0, 0},   {0, 0, 0}, {0, 0, 0}, {0, 0, 0},    {0, 0, 0},    {0, 0, 0},
                               {0, 11, 14}, {0, 2, 2}, {0, 0, 0}, {14, 20, 20}, {18, 20, 20}, {15, 20, 20}};

/// Likewise; columns time_step, then time_horizon [s].
constexpr double orca_times[12][9]{
    {155.4, 139.1, 164.6, 110.2, 110.4, 108.8, 101.9, 102.8, 106.9},
    {135.6, 135.2, 135.5, 95.3, 94.0, 90.9, 93.0, 89.6, 94.6},
    {99.7, 97.5, 100.0, 83.4, 84.5, 82.5, 83.3, 81.5, 79.8},
    {99.8, 100.4, 97.2, 101.8, 95.9, 95.5, 99.4, 99.0, 100.6},
    {90.3, 90.8, 89.0, 93.8, 87.5, 91.5, 92.1, 87.5, 89.7},
    {86.7, 85.2, 84.6, 82.2, 84.6, 83.4, 79.5, 79.8, 82.6},
    {100.7, 92.4, 90.6, 96.2, 93.8, 93.4, 97.2, 92.4, 93.1},
    {92.2, 92.9, 94.2, 93.1, 91.9, 91.3, 95.2, 92.2, 92.1},
    {81.8, 82.4, 88.2, 85.2, 84.9, 89.7, 86.1, 86.5, 89.9},
    {88.5, 82.1, 91.1, 83.7, 79.4, 82.8, 77.9, 79.1, 92.1},
    {85.6, 81.9, 85.7, 78.2, 76.3, 80.9, 76.4, 77.4, 80.2},
    {85.6, 77.4, 88.1, 78.4, 77.5, 82.1, 76.7, 78.6, 79.1},
};

/// By robot, in the small cube and in the large one.
constexpr PublishedMean starts[2][8]{
    {{30.33, 0.065},
     {30.24, 0.057},
     {29.46, 0.083},
     {28.38, 0.153},
     {28.42, 0.141},
     {29.24, 0.094},
     {30.28, 0.076},
     {30.50, 0.072}},
    {{98.46, 0.089},
     {99.27, 0.069},
     {101.24, 0.014},
     {101.21, 0.014},
     {101.20, 0.011},
     {101.23, 0.012},
     {98.48, 0.092},
     {99.25, 0.069}},
};

/// The place of a parameter's value on the grid, or nothing.
template <std::size_t N>
std::optional<std::size_t> place_of(const ParamValues& params, std::string_view name,
                                    const std::array<double, N>& grid) {
  const auto param = std::ranges::find(params, name, &ParamValues::value_type::first);
  if (param == params.end()) return std::nullopt;
  const auto found = std::ranges::find(grid, std::get<double>(param->second));
  if (found == grid.end()) return std::nullopt;
  return static_cast<std::size_t>(found - grid.begin());
}

/// CRIT_DIST and ORI_ERROR together.
std::optional<std::size_t> row_of(const ParamValues& params) {
  const auto crit = place_of(params, "crit_dist_m", crit_dists);
  const auto error = place_of(params, "ori_error_rad", ori_errors);
  if (!crit || !error) return std::nullopt;
  return ori_errors.size() * *crit + *error;
}

}  // namespace

const PublishedCell* published_cell(std::string_view cube, std::string_view method) {
  const auto found = std::ranges::find_if(
      published_cells, [&](const PublishedCell& c) { return c.cube == cube && c.method == method; });
  return found == std::end(published_cells) ? nullptr : found;
}

std::optional<double> published(std::string_view cube, std::string_view method, std::string_view quantity) {
  const PublishedCell* cell = published_cell(cube, method);
  if (cell == nullptr) return std::nullopt;
  if (quantity == "navigation_time_s") return cell->navigation_time_s.mean;
  if (quantity == "avoidance_time_s") return cell->avoidance_time_s.mean;
  if (quantity == "avoided_count") return cell->avoided_count.mean;
  if (quantity == "distance_m") return cell->distance_m.mean;
  if (quantity == "collision_count") return cell->collision_count;
  if (quantity == "stuck_count") return cell->stuck_count;
  return std::nullopt;
}

std::optional<double> published_tuning_time(const ParamValues& params) {
  const auto row = row_of(params);
  const auto w2 = place_of(params, "w2_ratio", w2s);
  const auto step = place_of(params, "time_step_s", time_steps);
  const auto horizon = place_of(params, "time_horizon_s", time_horizons);
  if (row && step && horizon) return orca_times[*row][time_horizons.size() * *step + *horizon];
  if (row && w2) return apf_times[*row][*w2];
  return std::nullopt;
}

std::optional<double> published_tuning_stuck(const ParamValues& params) {
  const auto row = row_of(params);
  const auto w2 = place_of(params, "w2_ratio", w2s);
  if (row && w2) return apf_stuck[*row][*w2];
  return std::nullopt;
}

PublishedMean recorded_start(const CubeCase& cube, std::size_t robot) {
  return starts[cube.half_edge_m < 20 ? 0 : 1][robot];
}

}  // namespace fairway::cubes
