// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "fairway/core/rng.hpp"

namespace fairway {

/// Makes bad input out of good: the same case number gives the same text on every machine.
class Mutator {
 public:
  Mutator(std::vector<std::string> samples, std::vector<std::string> words)
      : samples_{std::move(samples)}, words_{std::move(words)} {}

  std::string operator()(std::uint64_t number) const {
    Rng rng = Rng{20}.stream("mutation", number);
    std::string text = any(samples_, rng);
    for (std::uint64_t left = 1 + rng.index(1 + rng.index(4)); left > 0; --left) change(text, rng);
    return text;
  }

 private:
  static constexpr std::size_t longest = 6000;

  static const std::string& any(const std::vector<std::string>& texts, Rng& rng) {
    return texts[rng.index(texts.size())];
  }

  /// A number or word of the text, as a slip of the pen would hit it.
  static std::pair<std::size_t, std::size_t> token(const std::string& text, Rng& rng) {
    const auto is_word = [](char c) {
      return c == '_' || c == '.' || c == '-' || (c >= '0' && c <= '9') || (c | 0x20) >= 'a';
    };
    std::size_t from = rng.index(text.size() + 1);
    while (from < text.size() && !is_word(text[from])) ++from;
    std::size_t to = from;
    while (to < text.size() && is_word(text[to])) ++to;
    return {from, to - from};
  }

  void change(std::string& text, Rng& rng) const {
    const std::size_t at = rng.index(text.size() + 1);
    const std::size_t some = std::min<std::size_t>(1 + rng.index(1 + rng.index(40)), text.size() - at);
    const auto [from, length] = token(text, rng);
    switch (rng.index(9)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ static_cast<char>(1U << rng.index(8)));
        break;
      case 1:
        text.erase(at, some);
        break;
      case 2:
        text.insert(at, any(words_, rng));
        break;
      case 3:
      case 4:
        text.replace(from, length, any(words_, rng));
        break;
      case 5:
        text.insert(rng.index(text.size() + 1), text.substr(at, some));
        break;
      case 6: {
        // the beginning of one document and the end of another
        const std::string& other = any(samples_, rng);
        text = text.substr(0, at) + other.substr(rng.index(other.size() + 1));
        break;
      }
      case 7:
        text.resize(at);
        break;
      default: {
        std::string deep;
        const std::string& word = any(words_, rng);
        for (std::uint64_t n = rng.index(200); n > 0 && deep.size() < longest; --n) deep += word;
        text.insert(at, deep);
      }
    }
    if (text.size() > longest) text.resize(longest);
  }

  std::vector<std::string> samples_;
  std::vector<std::string> words_;
};

/// Expects that `read` accepts every sample, and what is made of them by `count` mutations neither hardly
/// ever, less often than `least`, nor mostly, and that nothing but what it catches comes of any.
template <class Read>
void expect_refusals_alone(const std::vector<std::string>& samples, const std::vector<std::string>& words,
                           const Read& read, std::uint64_t count, std::uint64_t least) {
  for (const std::string& sample : samples) EXPECT_TRUE(read(sample)) << sample;
  const Mutator mutated{samples, words};
  std::uint64_t accepted = 0;
  for (std::uint64_t number = 0; number < count; ++number) {
    ASSERT_NO_THROW(accepted += read(mutated(number)) ? 1 : 0) << "case " << number << ":\n"
                                                               << mutated(number);
  }
  EXPECT_GT(accepted, least);
  EXPECT_LT(accepted, count / 2);
}

}  // namespace fairway
