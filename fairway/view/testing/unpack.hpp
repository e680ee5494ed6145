// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <zstd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "fairway/record/frame.hpp"
#include "fairway/scenario/load.hpp"
#include "fairway/sim/simulation.hpp"
#include "fairway/view/columns.hpp"
#include "fairway/view/film.hpp"

// What a page does with a part of a film, and runs to make films of.
namespace fairway::testing {

inline std::string from_base64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0, held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    if (digit == std::string::npos) throw std::runtime_error("not base64");
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 255U);
  }
  return bytes;
}

inline std::string unpacked(const nlohmann::json& part, const char* key) {
  const std::string bytes = from_base64(part.at(key).get<std::string>());
  if (bytes.empty() || part.at("compression") == "none") return bytes;
  std::string plain(ZSTD_getFrameContentSize(bytes.data(), bytes.size()), '\0');
  const std::size_t size = ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size());
  if (size != plain.size()) throw std::runtime_error("not a whole zstd frame");
  return plain;
}

/// Values of each column as doubles, frame after frame.
using Columns = std::map<std::string, std::vector<double>>;

template <class T>
std::vector<double> numbers_of(const std::string& bytes) {
  std::vector<double> all;
  for (std::size_t i = 0; i < bytes.size(); i += sizeof(T)) {
    T value{};
    std::memcpy(&value, bytes.data() + i, sizeof(T));
    all.push_back(static_cast<double>(value));
  }
  return all;
}

/// Throws if the bytes are not as many as the columns take.
inline Columns columns_of(const nlohmann::json& part, const nlohmann::json& specs, std::size_t vehicles) {
  const std::string bytes = unpacked(part, "data");
  Columns columns;
  std::size_t at = 0;
  for (const nlohmann::json& spec : specs) {
    const std::string type = spec.at("type");
    const std::size_t one = type == "f64" ? 8 : type == "f32" ? 4 : 1;
    const std::size_t size = one * spec.at("width").get<std::size_t>() * part.at("count").get<std::size_t>() *
                             (spec.at("per") == "vehicle" ? vehicles : 1);
    if (at + size > bytes.size()) throw std::runtime_error("a part is too short");
    const std::string column = bytes.substr(at, size);
    columns[spec.at("name")] = type == "f64"   ? numbers_of<double>(column)
                               : type == "f32" ? numbers_of<float>(column)
                                               : numbers_of<std::uint8_t>(column);
    at += size;
  }
  if (at != bytes.size()) throw std::runtime_error("a part is too long");
  return columns;
}

inline nlohmann::json thoughts_of(const nlohmann::json& part) {
  const std::string text = unpacked(part, "thoughts");
  return text.empty() ? nlohmann::json{{"sketches", nlohmann::json::array()},
                                       {"tracks", nlohmann::json::array()},
                                       {"echoes", nlohmann::json::array()},
                                       {"words", nlohmann::json::array()},
                                       {"flights", nlohmann::json::array()}}
                      : nlohmann::json::parse(text);
}

inline Scenario shipped(const std::string& name, const Overrides& overrides = {}) {
  return load_scenario(std::string{FAIRWAY_SOURCE_DIR} + "/scenarios/" + name + ".yaml", overrides);
}

/// Simulates a scenario into sinks, its thoughts shown or not.
inline void run_scenario_into(const Scenario& scenario, std::initializer_list<FrameSink*> sinks,
                              bool thoughts = false) {
  Simulation simulation{scenario, builtin_catalogs()};
  simulation.show_thoughts(thoughts);
  simulation.run(std::span{sinks.begin(), sinks.size()});
}

}  // namespace fairway::testing
