// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace fairway {

/// FNV-1a with 128 bits over a sequence of texts, each ended so that {"ab","c"} and {"a","bc"} differ. The
/// same on every machine. Made to tell honest inputs apart, not to withstand forgery: among a
/// million runs two share a digest with a chance of about 1e-27.
class Digest {
 public:
  Digest& add(std::string_view text);

  /// 32 hexadecimal digits.
  std::string hex() const;

  /// The digest of these bytes alone, as in the published test vectors.
  static std::string of(std::string_view bytes);

 private:
  __extension__ using Word = unsigned __int128;
  void mix(std::string_view bytes);

  Word hash_ = (Word{0x6c62272e07bb0142ULL} << 64U) | 0x62b821756295c58dULL;
};

}  // namespace fairway
