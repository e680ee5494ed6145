// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/columns.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "fairway/avoidance/ability.hpp"

namespace fairway {
namespace {

static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

enum class Per : std::uint8_t { frame, vehicle };

struct ColumnShape {
  const char* name;
  const char* type;
  Per per;
  std::size_t width;
};

constexpr std::size_t frame_columns = 2;

/// In the order in which append() writes them.
std::array<ColumnShape, 16> column_shapes(std::size_t current_depths) {
  return {{{"time_s", "f64", Per::frame, 1},
           {"current_mps", "f32", Per::frame, 2 * current_depths},
           {"position_m", "f64", Per::vehicle, 3},
           {"attitude", "f32", Per::vehicle, 4},
           {"velocity_mps", "f32", Per::vehicle, 3},
           {"command_mps", "f32", Per::vehicle, 3},
           {"goal_m", "f32", Per::vehicle, 3},
           {"force_n", "f32", Per::vehicle, 3},
           {"power_w", "f32", Per::vehicle, 1},
           {"mode", "u8", Per::vehicle, 1},
           {"phase", "u8", Per::vehicle, 1},
           {"alert", "u8", Per::vehicle, 1},
           {"shortfall", "u8", Per::vehicle, 1},
           {"progress", "u8", Per::vehicle, 1},
           {"no_progress_s", "f32", Per::vehicle, 1},
           {"progress_with", "f32", Per::vehicle, 1}}};
}

std::size_t bytes_of(const ColumnShape& shape) {
  const std::string_view type = shape.type;
  return shape.width * (type == "f64" ? 8 : type == "f32" ? 4 : 1);
}

template <class T>
void put_raw(std::string& out, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  out.append(raw.data(), raw.size());
}

void put_float(std::string& out, double value) { put_raw(out, static_cast<float>(value)); }

void put_floats(std::string& out, const Vec3& v) {
  for (const double x : v) put_float(out, x);
}

void put_quaternion(std::string& out, const Eigen::Quaterniond& q) {
  for (const double x : {q.w(), q.x(), q.y(), q.z()}) put_float(out, x);
}

/// The shortfall of a command that a vehicle is under way by.
Shortfall shortfall_of(const VehicleFrame& vehicle, const Limits& limits) {
  if (!is_avoiding(vehicle.phase)) return Shortfall::none;
  return shortfall(limits, vehicle.command, yaw_of(vehicle.state.q_nb));
}

}  // namespace

FilmColumns::FilmColumns(std::size_t vehicles, std::size_t current_depths) {
  for (const ColumnShape& shape : column_shapes(current_depths))
    columns_.push_back({bytes_of(shape) * (shape.per == Per::vehicle ? vehicles : 1), {}});
}

nlohmann::json FilmColumns::specs(std::size_t current_depths) {
  nlohmann::json all = nlohmann::json::array();
  for (const ColumnShape& shape : column_shapes(current_depths)) {
    all.push_back({{"name", shape.name},
                   {"type", shape.type},
                   {"per", shape.per == Per::frame ? "frame" : "vehicle"},
                   {"width", shape.width}});
  }
  return all;
}

void FilmColumns::append(const Frame& frame, const FrameExtras& extras) {
  put_raw(columns_[0].bytes, frame.time);
  for (const Vec3& current : extras.currents) {
    put_float(columns_[1].bytes, current.x());
    put_float(columns_[1].bytes, current.y());
  }
  for (std::size_t i = 0; i < frame.vehicles.size(); ++i) {
    const VehicleFrame& vehicle = frame.vehicles[i];
    auto column = columns_.begin() + frame_columns;
    const auto next = [&column]() -> std::string& { return (column++)->bytes; };
    std::string& position = next();
    for (const double x : vehicle.state.p_n) put_raw(position, x);
    put_quaternion(next(), vehicle.state.q_nb);
    put_floats(next(), vehicle.state.v_n());
    put_floats(next(), vehicle.command.velocity);
    put_floats(next(), vehicle.goal);
    put_floats(next(), vehicle.wrench.head<3>());
    put_float(next(), vehicle.power);
    put_raw(next(), static_cast<std::uint8_t>(vehicle.command.mode));
    put_raw(next(), static_cast<std::uint8_t>(vehicle.phase));
    put_raw(next(), extras.alerts[i]);
    put_raw(next(), static_cast<std::uint8_t>(shortfall_of(vehicle, extras.limits[i])));
    const ProgressReport& progress = extras.progress.state(i);
    put_raw(next(), static_cast<std::uint8_t>(progress.state));
    put_float(next(), frame.time - progress.last_progress);
    put_float(next(), progress.with ? static_cast<double>(number(*progress.with)) : -1.0);
  }
  ++size_;
}

double FilmColumns::time(std::size_t frame) const {
  double time{};
  std::memcpy(&time, columns_.front().bytes.data() + frame * sizeof(double), sizeof(double));
  return time;
}

void FilmColumns::halve() {
  const std::size_t kept = (size_ + 1) / 2;
  for (Column& column : columns_) {
    for (std::size_t i = 1; i < kept; ++i)
      std::memmove(column.bytes.data() + i * column.row, column.bytes.data() + 2 * i * column.row,
                   column.row);
    column.bytes.resize(kept * column.row);
  }
  size_ = kept;
}

std::string FilmColumns::bytes(std::size_t first, std::size_t count) const {
  std::string all;
  for (const Column& column : columns_) all.append(column.bytes, first * column.row, count * column.row);
  return all;
}

}  // namespace fairway
