// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <unordered_map>

#include "fairway/experiment/origin.hpp"
#include "fairway/experiment/run.hpp"

namespace fairway {

/// What results are put together for, and so what they must have in common.
enum class Together {
  merged,         ///< into one store: one campaign, one study, and the results epoch of this program
  compared,       ///< results of one epoch, and of one version of each campaign
  compared_mixed  ///< whatever they are of, as somebody asked for who knows it
};

/// Holds every store to those before, and every run to what was met of it before.
class Agreement {
 public:
  explicit Agreement(Together purpose) : purpose_{purpose} {}

  /// Throws InputError, which names the two, where results of that origin do not belong to those before.
  /// Their runs are checked next.
  void check(const std::string& name, const Origin& origin);

  /// Throws InputError likewise: where the same run has come to other measures and, of what is merged, where
  /// it is of another version or of another study.
  void check(const std::string& name, const RunRecord& record);

 private:
  /// A digest, and the file in which it was met.
  struct Known {
    std::string digest;
    std::string file;
  };
  void check_merged(const std::string& name, const Origin& origin);
  void check_compared(const std::string& name, const Origin& origin);
  void check_version(const std::string& name, const RunSpec& spec);
  [[noreturn]] void refuse(const std::string& name, const std::string& why) const;

  Together purpose_;
  std::string first_file_;
  Origin first_;
  Known epoch_;                             ///< the first that was told
  std::map<std::string, Known> campaigns_;  ///< by name, those whose digest was told
  std::string study_;
  std::unordered_map<std::string, Known> keys_;      ///< by labels and seed
  std::unordered_map<std::string, Known> measures_;  ///< by key
};

}  // namespace fairway
