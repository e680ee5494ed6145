// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace fairway {

/// Where in a file something was written; line and column count from 1, 0 = unknown.
struct Location {
  std::string file;
  int line{};
  int column{};

  /// "scenarios/crossing.yaml:14:5: " or empty.
  std::string prefix() const {
    if (file.empty()) return "";
    std::string text = file;
    if (line > 0) text.append(":").append(std::to_string(line)).append(":").append(std::to_string(column));
    return text + ": ";
  }
};

/// Input that cannot be used: a file, a flag, a value. what() is the whole line to show:
/// "scenarios/crossing.yaml:14:5: vehicles[1].avoider.time_horizon: unknown parameter; did you mean …".
/// The command ends with exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& message) : std::runtime_error{message} {}
  InputError(const Location& where, const std::string& path, const std::string& message)
      : std::runtime_error{where.prefix() + (path.empty() ? "" : path + ": ") + message} {}
};

}  // namespace fairway
