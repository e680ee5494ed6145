// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/digest.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace fairway {

Digest& Digest::add(std::string_view text) {
  mix(std::to_string(text.size()));
  mix(":");
  mix(text);
  return *this;
}

std::string Digest::hex() const {
  return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash_ >> 64U),
                     static_cast<std::uint64_t>(hash_));
}

std::string Digest::of(std::string_view bytes) {
  Digest digest;
  digest.mix(bytes);
  return digest.hex();
}

void Digest::mix(std::string_view bytes) {
  constexpr Word prime = (Word{1} << 88U) + 0x13b;
  for (const char c : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * prime;
}

}  // namespace fairway
