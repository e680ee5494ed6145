// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/word_messages.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fairway/record/message_parts.hpp"

namespace fairway {

void encode_word(Bytes& out, const SpokenWord& word) {
  CdrWriter cdr{out};
  put_header(cdr, stamp_of(word.sent));
  cdr.number(word.from);
  cdr.number(word.sent);
  cdr.number(std::uint32_t{word.speech.size});
  put(out, std::as_bytes(word.speech.view()));
}

SpokenWord decode_word(ByteView message) {
  CdrReader cdr{message};
  skip_header(cdr);
  SpokenWord word;
  word.from = cdr.number<std::uint32_t>();
  word.sent = cdr.number<double>();
  const ByteView bytes = cdr.bytes();
  if (bytes.empty() || bytes.size() > Speech::most_bytes)
    damaged("a word has " + std::to_string(bytes.size()) + " bytes; expected 1 to " +
            std::to_string(Speech::most_bytes));
  std::ranges::transform(bytes, word.speech.bytes.begin(), std::to_integer<std::uint8_t>);
  word.speech.size = static_cast<std::uint8_t>(bytes.size());
  cdr.finish();
  return word;
}

std::string hexadecimal(const Speech& speech) { return fmt::format("{:02x}", fmt::join(speech.view(), "")); }

}  // namespace fairway
