// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/instant.hpp"

#include <fmt/format.h>

#include <charconv>
#include <ranges>

#include "fairway/core/text.hpp"

namespace fairway {
namespace {

/// The share of a period by which a typed time may be off: it has fewer digits than `tick * period`.
constexpr double typed_tolerance = 1e-6;

std::optional<std::uint32_t> typed_number(std::string_view text) {
  std::uint32_t value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

std::size_t vehicle_called(const RecordingInfo& info, std::string_view text) {
  const auto& vehicles = info.vehicles;
  const auto index_of = [&](auto found) { return static_cast<std::size_t>(found - vehicles.begin()); };
  if (const auto found = std::ranges::find(vehicles, text, &RecordingInfo::Vehicle::name);
      found != vehicles.end()) {
    return index_of(found);
  }
  if (const std::optional<std::uint32_t> value = typed_number(text)) {
    const auto found = std::ranges::find(vehicles, VehicleId{*value}, &RecordingInfo::Vehicle::id);
    if (found != vehicles.end()) return index_of(found);
    if (*value < vehicles.size()) return *value;
  }
  std::vector<std::string_view> known;
  for (const RecordingInfo::Vehicle& vehicle : vehicles) known.push_back(vehicle.name);
  throw InputError(fmt::format("--vehicle {}: no vehicle of this recording has that name, id or index{}",
                               text, suggestion(text, known)));
}

std::size_t frame_at(const Recording& recording, double time) {
  const double period = recording.info().period;
  const double end = static_cast<double>(recording.run_frame_count()) * period;
  const double slack = typed_tolerance * period;
  if (!(recording.size() > 0 && time >= -slack && time <= end + slack)) {
    throw InputError(
        fmt::format("--time {}: outside the run, which is from 0 to {:.10g} s", number_text(time), end));
  }
  const auto frames = std::views::iota(std::size_t{0}, recording.size());
  const auto after = std::ranges::partition_point(
      frames, [&](std::size_t i) { return recording.frame(i).time <= time + slack; });
  const std::size_t count = *after;
  if (count == 0)
    throw InputError(fmt::format("--time {}: before the first recorded frame", number_text(time)));
  return count - 1;
}

}  // namespace fairway
