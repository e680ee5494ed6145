// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace fairway {

/// What made results: the program and the machine that it ran on. What is not known is empty.
struct Maker {
  std::string version;    ///< of fairway
  std::string commit;     ///< that it was built from; "-dirty" behind it where that was changed
  std::string epoch;      ///< of its results
  std::string compiler;   ///< "g++ 12.2.0"
  std::string c_library;  ///< "glibc 2.36", whose sines it may have
  std::string processor;  ///< "x86_64, AMD EPYC 7B13"
  std::string host;       ///< empty where it is withheld, too

  bool operator==(const Maker&) const = default;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Maker, version, commit, epoch, compiler, c_library, processor,
                                                host)

/// This program on this machine.
Maker this_maker(bool with_host);

/// `maker` among `makers`, once.
void add_maker(std::vector<Maker>& makers, const Maker& maker);

/// A line for each kind of program and machine, with the hosts: "fairway 0.2.0 (6932d06, epoch 5),
/// g++ 12.2.0, glibc 2.36, x86_64, AMD EPYC 7B13: n1, n2".
std::vector<std::string> kinds_of(std::span<const Maker> makers);

/// What is to be known of results that several kinds made, in one line without an end; empty if one kind did.
std::string remark_on(std::span<const Maker> makers);

}  // namespace fairway
