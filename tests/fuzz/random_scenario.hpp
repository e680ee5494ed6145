// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/rng.hpp"
#include "fairway/core/text.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway {

/// Writes scenarios at random: any vehicle, method, steering, sea, exchange and perception, with parameters
/// anywhere in their ranges. Most can be simulated. The same number gives the same text on every machine.
class RandomScenario {
 public:
  RandomScenario(std::uint64_t number, const Catalogs& catalogs)
      : catalogs_{catalogs}, rng_{Rng{15}.stream("scenario", number)} {}

  std::string yaml() {
    steps_per_second_ = 1.0 / one_of<double>({0.02, 0.05, 0.05, 0.1, 0.2, 0.5, 1.0});
    const double seconds = rng_.uniform(2.0, 8.0) * std::fmax(1.0, 8.0 / steps_per_second_);
    std::string text = "fairway: 1\nname: random\nstep_s: " + number_text(1.0 / steps_per_second_) +
                       "\nduration_s: " + number_text(seconds) + "\nseed: " + number(0, 1e6, true) + "\n";
    text += "steps_per_decision_count: " + number(1, 1.0 + 0.5 * steps_per_second_, true) + "\n";
    text += "water: {" + water() + "}\n";
    if (chance(0.5)) text += "exchange: " + one_of<std::string>({"perfect", "none", exchange()}) + "\n";
    if (chance(0.4)) text += "perception: " + one_of<std::string>({"sonar", "{range_m: 20}"}) + "\n";
    if (chance(0.3)) text += "navigation: {kind: drifting, position_sigma_m: " + number(0, 5) + "}\n";
    text += obstacles() + "vehicles:\n";
    for (std::uint64_t n = 1 + rng_.index(3); n > 0; --n) text += vehicle();
    return text + "expect: {collision_count: {min: 0}, arrived_ratio: {min: 0}}\n";
  }

 private:
  bool chance(double ratio) { return rng_.uniform(0.0, 1.0) < ratio; }

  template <class T>
  T one_of(const std::vector<T>& choices) {
    return choices[rng_.index(choices.size())];
  }

  std::string number(double lo, double hi, bool whole = false) {
    const double drawn = rng_.uniform(lo, hi);
    return number_text(whole ? std::floor(drawn) : drawn);
  }

  /// Near the default, at an end of the range, or evenly in between on the scale that the range spans.
  std::string param(const ParamInfo& info) {
    if (info.type == "boolean") return chance(0.5) ? "true" : "false";
    if (info.type == "choice") return one_of(info.choices);
    const double usual = std::get<double>(info.value);
    double drawn = usual * std::exp(rng_.uniform(-1.0, 1.0));
    if (chance(0.2)) drawn = chance(0.5) ? info.range.lo : info.range.hi;
    if (chance(0.2) && info.range.hi > 0.0) {
      const double least = std::fmax(info.range.lo, 1e-4 * std::fmin(info.range.hi, 1e4));
      drawn = least * std::pow(info.range.hi / least, rng_.uniform(0.0, 1.0));
    }
    if (info.type == "integer") drawn = std::round(std::fmin(drawn, std::fmax(100.0, usual)));
    return number_text(std::fmin(std::fmax(drawn, info.range.lo), info.range.hi));
  }

  /// Each of few parameters, now and then.
  std::string params(const std::vector<ParamInfo>& infos, double ratio) {
    std::string text;
    for (const ParamInfo& info : infos) {
      const bool takes_long = info.name.find("iterations") != std::string::npos ||
                              info.name.find("samples") != std::string::npos || info.name == "solver";
      if (info.type == "list" || takes_long || !chance(ratio)) continue;
      text += ", " + info.name + ": " + param(info);
    }
    return text;
  }

  std::string place(double depth, double reach = 40.0) {
    return "[" + number(-reach, reach) + ", " + number(-reach, reach) + ", " + number_text(depth) + "]";
  }

  std::string water() {
    std::string text = "density_kgpm3: " + number(990, 1030);
    const double fast = chance(0.1) ? 10.0 : 0.5;
    switch (rng_.index(4)) {
      case 0:
        text += ", current_mps: [" + number(-fast, fast) + ", " + number(-fast, fast) + ", 0]";
        break;
      case 1:
        text += ", current: {sheared: {direction_deg: " + number(0, 360) +
                ", profile: [{depth_m: 0, speed_mps: " + number(-fast, fast) +
                "}, {depth_m: 20, speed_mps: " + number(-fast, fast) + "}]}}";
        break;
      case 2:
        text += ", current: {gauss_markov: {mean_speed_mps: " + number(0, fast) +
                ", deviation_mps: " + number(0, fast) + ", correlation_time_s: " + number(1, 100) +
                ", direction_deviation_deg: 30}}";
        break;
      default:
        break;
    }
    if (chance(0.2)) {
      text += ", waves: [{amplitude_m: " + number(0.01, 0.5) + ", period_s: " + number(4, 12) + "}]";
    } else if (chance(0.2)) {
      text += ", waves: {spectrum: jonswap, significant_height_m: " + number(0.05, 1) +
              ", peak_period_s: " + number(3, 9) + ", components_count: 8}";
    }
    return text;
  }

  std::string exchange() {
    return "{kind: acoustic, update_rate_hz: " + number(0.1, 2) + ", loss_ratio: " + number(0, 1) + "}";
  }

  std::string obstacles() {
    std::string text = "obstacles:\n";
    for (std::uint64_t n = rng_.index(4); n > 0; --n) {
      const std::string hidden = chance(0.2) ? ", charted: false" : "";
      const std::string drifts = chance(0.3) ? ", velocity_mps: [" + number(-1, 1) + ", 0.1, 0]" : "";
      const double n0 = rng_.uniform(-30.0, 30.0), e0 = rng_.uniform(-30.0, 30.0);
      switch (rng_.index(3)) {
        case 0:
          text += "  - sphere: {position_m: " + place(5) + ", radius_m: " + number(0.1, 5) + drifts +
                  (drifts.empty() ? hidden : "") + "}\n";
          break;
        case 1:
          text += "  - segment: {from_m: " + place(0) + ", to_m: " + place(0) + hidden + "}\n";
          break;
        default:
          text += "  - polygon: {vertices_m: [[" + number_text(n0) + ", " + number_text(e0) + "], [" +
                  number_text(n0 + 4) + ", " + number_text(e0) + "], [" + number_text(n0 + 4) + ", " +
                  number_text(e0 + 6) + "]]" + hidden + "}\n";
      }
    }
    return text == "obstacles:\n" ? "" : text;
  }

  std::string leg(double depth) {
    const std::string speed = ", speed_mps: " + number(0.05, chance(0.1) ? 50 : 2);
    switch (rng_.index(8)) {
      case 0:
        return "{keep_position: {duration_s: " + number(0, 5) + "}}";
      case 1:
        return "{go_to: {position_m: " + place(depth) + speed + "}}";
      case 2:
        return "{section: {from_m: " + place(depth) + ", to_m: " + place(depth) + speed + "}}";
      case 3:
        return "{rendezvous: {}}";
      default:
        return "{transit: {position_m: " + place(depth) + speed + ", arrival_m: " + number(0.1, 3) + "}}";
    }
  }

  std::string avoider() {
    const auto entries = catalogs_.avoiders.entries();
    std::string name{entries[rng_.index(entries.size())].info.name};
    for (const auto& entry : entries) {
      if (entry.wraps && chance(0.1)) name += "+" + std::string(entry.info.name);
    }
    return "{algorithm: " + name + params(catalogs_.avoiders.params(name), chance(0.5) ? 0.15 : 0.0) + "}";
  }

  std::string vehicle() {
    const auto entries = catalogs_.vehicles.entries();
    const auto& drawn = entries[rng_.index(entries.size())];
    // no autopilot drives propeller speeds
    const auto& model = drawn.info.name == "otter" ? catalogs_.vehicles.find("otter_by_thrust") : drawn;
    const double depth = model.info.floats ? 0.0 : rng_.uniform(1.0, 20.0);
    std::string text = "  - model: {name: " + std::string(model.info.name) +
                       params(model.params, chance(0.4) ? 0.1 : 0.0) + "}\n";
    text += "    avoider: " + avoider() + "\n";
    if (chance(0.2)) {
      text += "    steering: {kind: " +
              one_of<std::string>({"turn_then_go", "proportional", "holonomic", "speed_and_course", "crab"}) +
              ", turn_gain_hz: " + number(0, 3) + "}\n";
    }
    if (chance(0.1)) text += "    allocation: pseudo_inverse\n";
    text += "    start: {position_m: " + place(depth) + ", yaw_deg: " + number(-180, 180);
    if (chance(0.3)) text += ", speed_mps: " + number(chance(0.1) ? -50 : 0, chance(0.1) ? 50 : 2);
    text += "}\n    radius_m: " + number(0, 3) + "\n";
    if (chance(0.1)) text += "    cooperative: false\n";
    if (chance(0.1)) {
      text += "    failure: {kind: " + one_of<std::string>({"silent", "stops", "leaves"}) +
              ", under_way_s: " + number(0, 30) + "}\n";
    }
    if (chance(0.7)) {
      text += "    limits: {max_speed_mps: " + number(0.1, chance(0.1) ? 50 : 2) +
              ", max_climb_rate_mps: " + number(0, 0.5) +
              ", max_turn_rate_radps: " + number(0.01, chance(0.1) ? 10 : 1) +
              ", max_acceleration_mps2: " + number(0.01, 2) + "}\n";
    }
    text += "    mission: [";
    for (std::uint64_t n = 1 + rng_.index(2), i = 0; i < n; ++i) text += (i > 0 ? ", " : "") + leg(depth);
    return text + "]\n";
  }

  const Catalogs& catalogs_;
  Rng rng_;
  double steps_per_second_{20.0};
};

}  // namespace fairway
