// SPDX-License-Identifier: Apache-2.0
#include "fairway/sim/trial.hpp"

#include <algorithm>
#include <cmath>
#include <istream>
#include <optional>
#include <ostream>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/text.hpp"
#include "fairway/world/sea/sea.hpp"

namespace fairway {
namespace {

// ---- settings

struct InitialState {
  double x_m{}, y_m{}, z_m{}, roll_rad{}, pitch_rad{}, yaw_rad{};
  double u_mps{}, v_mps{}, w_mps{}, p_radps{}, q_radps{}, r_radps{};

  static consteval auto fields() {
    using S = InitialState;
    constexpr Range place{-1e6, 1e6}, angle{-100, 100}, speed{-100, 100};
    return std::tuple{field<&S::x_m>(place, "north"),
                      field<&S::y_m>(place, "east"),
                      field<&S::z_m>(place, "down"),
                      field<&S::roll_rad>(angle, "roll"),
                      field<&S::pitch_rad>(angle, "pitch, positive nose up"),
                      field<&S::yaw_rad>(angle, "yaw from north, positive to east"),
                      field<&S::u_mps>(speed, "over ground, forward"),
                      field<&S::v_mps>(speed, "over ground, to starboard"),
                      field<&S::w_mps>(speed, "over ground, down in body axes"),
                      field<&S::p_radps>(speed, "roll rate"),
                      field<&S::q_radps>(speed, "pitch rate"),
                      field<&S::r_radps>(speed, "yaw rate")};
  }
};

struct Current {
  double north_mps{}, east_mps{}, down_mps{};

  static consteval auto fields() {
    constexpr Range speed{-20, 20};
    return std::tuple{field<&Current::north_mps>(speed, "water flows north"),
                      field<&Current::east_mps>(speed, "water flows east"),
                      field<&Current::down_mps>(speed, "water flows down")};
  }
};

/// A regular wave.
struct Wave {
  double amplitude_m{}, period_s{5.0}, direction_deg{}, phase_deg{};

  static consteval auto fields() {
    constexpr Range angle{-360, 360};
    return std::tuple{field<&Wave::amplitude_m>({0, 100}, "half the height of a regular wave; 0 = none"),
                      field<&Wave::period_s>({0.1, 1000}, "of the wave, on deep water"),
                      field<&Wave::direction_deg>(angle, "where the wave runs, 0 north, 90 east"),
                      field<&Wave::phase_deg>(angle, "of its elevation's cosine at the origin at the start")};
  }
};

struct WaterProperties {
  double density_kgpm3{1000.0};

  static consteval auto fields() {
    return std::tuple{field<&WaterProperties::density_kgpm3>({900, 1100}, "density of the water")};
  }
};

struct Execution {
  bool actuator_dynamics{false};
  double step_s{0.02};

  static consteval auto fields() {
    return std::tuple{
        field<&Execution::actuator_dynamics>("inputs are commands that the actuators follow with lag"),
        field<&Execution::step_s>({1e-5, 1}, "longest integration step")};
  }
};

struct Settings {
  InitialState state;
  Current current;
  Wave wave;
  WaterProperties water;
  Execution execution;
  ParamValues vehicle;
};

/// Every setting's full name, those of the vehicle last.
std::vector<std::string> setting_names(const VehicleCatalog::Entry& entry) {
  std::vector<std::string> names;
  const auto add = [&]<class P>(const P&, std::string_view prefix) {
    for (const std::string_view name : param_names<P>()) names.push_back(std::string(prefix).append(name));
  };
  add(InitialState{}, "state.");
  add(Current{}, "current.");
  add(Wave{}, "wave.");
  add(WaterProperties{}, "water.");
  add(Execution{}, "");
  for (const ParamInfo& param : entry.params) names.push_back(param.name);
  return names;
}

/// Sets `prefix` + one of P's names; false if `name` does not begin with `prefix`.
template <class P>
bool take(P& target, std::string_view prefix, std::string_view name, const ParamValue& value) {
  if (!name.starts_with(prefix)) return false;
  try {
    return set_param(target, name.substr(prefix.size()), value, true);
  } catch (const InputError& error) {
    throw InputError(std::string(prefix).append(error.what()));
  }
}

Settings read_settings(const VehicleCatalog::Entry& entry, const ParamValues& values) {
  Settings settings;
  const std::vector<std::string> names = setting_names(entry);
  for (const auto& [name, value] : values) {
    if (std::ranges::find(names, list_of_param(name)) == names.end()) {
      throw InputError({}, name, "unknown setting" + suggestion(name, {names.begin(), names.end()}));
    }
    const bool taken =
        take(settings.state, "state.", name, value) || take(settings.current, "current.", name, value) ||
        take(settings.wave, "wave.", name, value) || take(settings.water, "water.", name, value) ||
        take(settings.execution, "", name, value);
    if (!taken) settings.vehicle.emplace_back(name, value);
  }
  return settings;
}

// ---- inputs

constexpr double farthest_s = 1e7;  // as for a scenario's duration: the steps until then can be counted

struct InputRow {
  double time{};
  int line{};
  ActuatorValues values;
};

struct Cell {
  std::string_view text;
  int column{};  // of its first character, from 1
};

std::vector<Cell> split(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t from = 0;;) {
    const std::size_t to = std::min(line.find(',', from), line.size());
    const std::size_t first = std::min(line.find_first_not_of(" \t", from), to);
    std::string_view text = line.substr(first, to - first);
    while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
    cells.push_back({text, static_cast<int>(first) + 1});
    if (to == line.size()) return cells;
    from = to + 1;
  }
}

class InputReader {
 public:
  InputReader(std::istream& stream, const std::string& name, std::span<const ActuatorInfo> actuators)
      : stream_{stream}, where_{name}, actuators_{actuators} {}

  std::vector<InputRow> read() {
    read_header();
    std::vector<InputRow> rows;
    while (next_line())
      rows.push_back(read_row(rows.empty() ? std::nullopt : std::optional{rows.back().time}));
    if (rows.empty()) refuse(1, "", "no rows under the header");
    return rows;
  }

 private:
  [[noreturn]] void refuse(int column, std::string_view path, const std::string& message) {
    where_.column = column;
    throw InputError(where_, std::string(path), message);
  }

  /// The next line that is not empty, without its end; false at the end of the file.
  bool next_line() {
    while (std::getline(stream_, line_)) {
      ++where_.line;
      if (where_.line == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
      if (line_.ends_with('\r')) line_.pop_back();
      if (line_.find_first_not_of(" \t") != std::string::npos) return true;
    }
    return false;
  }

  void read_header() {
    if (!next_line()) {
      where_.line = 1;
      refuse(1, "", "empty; expected a header with time_s and actuators");
    }
    std::vector<std::string_view> known{"time_s"};
    for (const ActuatorInfo& actuator : actuators_) known.emplace_back(actuator.name);

    for (const Cell& cell : split(line_)) {
      const auto found = std::ranges::find(known, cell.text);
      if (found == known.end()) {
        refuse(cell.column, cell.text.empty() ? "\"\"" : cell.text,
               "unknown column" + suggestion(cell.text, known));
      }
      const auto target = static_cast<int>(found - known.begin()) - 1;
      if (std::ranges::find(targets_, target) != targets_.end())
        refuse(cell.column, cell.text, "column given twice");
      names_.emplace_back(cell.text);
      targets_.push_back(target);
    }
    if (std::ranges::find(targets_, -1) == targets_.end()) refuse(1, "time_s", "column missing");
  }

  InputRow read_row(std::optional<double> previous) {
    const std::vector<Cell> cells = split(line_);
    if (cells.size() != targets_.size()) {
      refuse(cells.back().column, "",
             std::to_string(cells.size()) + " cells under a header of " + std::to_string(targets_.size()));
    }
    InputRow row;
    row.line = where_.line;
    row.values = ActuatorValues::Zero(static_cast<Eigen::Index>(actuators_.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const ParamValue value = parse_value(cells[i].text);
      const double* number = std::get_if<double>(&value);
      if (number == nullptr || !std::isfinite(*number)) {
        refuse(cells[i].column, names_[i],
               "is \"" + std::string(cells[i].text) + "\"; expected a finite number");
      }
      if (targets_[i] >= 0) {
        row.values[targets_[i]] = *number;
        continue;
      }
      row.time = *number;
      if (std::fabs(row.time) > farthest_s) {
        refuse(cells[i].column, "time_s",
               "is " + number_text(row.time) + "; expected a number in [-1e+07, 1e+07]");
      }
      if (previous && !(row.time > *previous)) {
        refuse(cells[i].column, "time_s",
               "is " + number_text(row.time) + ", not after " + number_text(*previous));
      }
    }
    return row;
  }

  std::istream& stream_;
  Location where_;
  std::span<const ActuatorInfo> actuators_;
  std::string line_;
  std::vector<std::string> names_;  // of the columns
  std::vector<int> targets_;        // of the columns: an actuator, or -1 for time_s
};

// ---- outputs

void append_row(std::string& text, double time, const VehicleState& x) {
  const Euler e = euler_of(x.q_nb);
  text += number_text(time);
  for (const double value : {x.p_n.x(), x.p_n.y(), x.p_n.z(), e.roll, e.pitch, e.yaw, x.v_b.x(), x.v_b.y(),
                             x.v_b.z(), x.omega_b.x(), x.omega_b.y(), x.omega_b.z()}) {
    text += ',';
    text += number_text(value);
  }
  text += '\n';
}

Sea sea_of(const Settings& settings) {
  const Current& c = settings.current;
  const Wave& w = settings.wave;
  WaterSpec spec{.density_kgpm3 = settings.water.density_kgpm3,
                 .current_n = {c.north_mps, c.east_mps, c.down_mps}};
  if (w.amplitude_m > 0.0) {
    spec.waves.components = {{w.amplitude_m, w.period_s, radians(w.direction_deg), radians(w.phase_deg)}};
  }
  return Sea{spec, Rng{0}};
}

/// Moves `vehicle` from `time` by `duration` [s] in equal steps no longer than step_s.
void hold(Vehicle& vehicle, const ActuatorValues& input, const Sea& sea, double time, double duration,
          const Execution& execution) {
  const auto steps =
      static_cast<std::int64_t>(math::fmax(1.0, std::ceil(duration / execution.step_s * (1.0 - 1e-12))));
  const double h = duration / static_cast<double>(steps);
  if (!execution.actuator_dynamics) vehicle.set_actuator_state(input);
  for (std::int64_t i = 0; i < steps; ++i) {
    const VehicleState& x = vehicle.state();
    const Water water = sea.water_halfway(x, time + static_cast<double>(i) * h, h);
    if (execution.actuator_dynamics) {
      vehicle.step(input, water, h);
    } else {
      vehicle.drift(water, h);
    }
  }
}

}  // namespace

void run_trial(const VehicleCatalog& catalog, std::string_view vehicle_name, std::istream& inputs,
               const std::string& input_name, std::ostream& outputs, const ParamValues& values) {
  // everything is read before anything moves
  const Settings settings = read_settings(catalog.find(vehicle_name), values);
  Vehicle vehicle = catalog.make(vehicle_name, settings.vehicle);
  const std::vector<InputRow> rows = InputReader{inputs, input_name, vehicle.actuators()}.read();

  const InitialState& s = settings.state;
  VehicleState start;
  start.p_n = {s.x_m, s.y_m, s.z_m};
  start.q_nb = quaternion_of({.roll = s.roll_rad, .pitch = s.pitch_rad, .yaw = s.yaw_rad});
  start.v_b = {s.u_mps, s.v_mps, s.w_mps};
  start.omega_b = {s.p_radps, s.q_radps, s.r_radps};
  vehicle.set_state(start);

  const Sea sea = sea_of(settings);

  // one output row per input row, written once all of them are known
  std::string text{trial_columns};
  append_row(text, rows.front().time, vehicle.state());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    hold(vehicle, rows[i - 1].values, sea, rows[i - 1].time - rows.front().time,
         rows[i].time - rows[i - 1].time, settings.execution);
    if (!is_finite(vehicle.state())) {
      throw InputError({input_name, rows[i].line, 1}, "time_s",
                       "the motion has grown without bound before " + number_text(rows[i].time) +
                           " s; try a smaller step_s than " + number_text(settings.execution.step_s));
    }
    append_row(text, rows[i].time, vehicle.state());
  }
  outputs << text;
}

}  // namespace fairway
