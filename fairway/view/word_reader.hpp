// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/core/message_flight.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// What a word says, for people.
struct ReadWord {
  std::string text;                  ///< a line, whose subject is who said it
  std::vector<std::size_t> awaited;  ///< vehicles by index whose words that one waits for
};

/// Reads what the vehicles of a scenario say, each by its own method.
class WordReader {
 public:
  /// Both must outlive it. Without `avoiders`, and of a method that they do not know or that does not say how
  /// its words are read, the text is the bytes.
  WordReader(const Scenario& scenario, const Catalog* avoiders) : scenario_{scenario}, avoiders_{avoiders} {}

  /// `word.from` is one of the vehicles. Makes the sender's method when it is asked first.
  ReadWord read(const SpokenWord& word);

 private:
  const Avoider* method_of(std::size_t vehicle);

  const Scenario& scenario_;
  const Catalog* avoiders_;
  std::map<std::size_t, std::optional<Avoider>> methods_;  // by vehicle
};

/// "says the bytes 0a1f": a word that nobody reads.
std::string unread_text(const Speech& speech);

}  // namespace fairway
