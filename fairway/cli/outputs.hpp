// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "fairway/record/output_check.hpp"

namespace fairway::cli {

/// The files that a verb writes: each is declared here, with its kind, and all of them are judged before the
/// verb begins, so that no verb writes over what it reads, nor over a file of another kind without --force.
class Outputs {
 public:
  /// Declares --force.
  explicit Outputs(CLI::App& verb);
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// Declares a flag that takes the file's path into `path`, which has to live as long as this.
  CLI::Option* add(const std::string& flag, std::string& path, const FileKind& kind, const std::string& help);

  /// check_outputs() of all that were declared, and of `more`, whose paths follow from other flags.
  void judge(const std::vector<std::string>& inputs, const std::vector<Output>& more = {}) const;

  bool force() const { return force_; }

 private:
  struct Declared {
    std::string flag;
    const std::string* path;
    FileKind kind;
  };
  CLI::App* verb_;
  bool force_{false};
  std::vector<Declared> declared_;
};

}  // namespace fairway::cli
