// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <iosfwd>
#include <string>

#include "fairway/avoidance/catalog.hpp"

namespace fairway {

struct DecideOptions {
  std::string algorithm;    ///< of the catalog: "orca3d", "apf+stop_and_wait"
  ParamValues params;       ///< of every line, unless the line has its own
  bool keep_memory{false};  ///< each own id has one avoider that lives on from line to line
};

/// Answers each line of `in` that is not blank, a situation as parse_situation() reads it, with a line
/// `{"velocity":[n,e,d],"mode":"avoid"}`: metres per second in the fewest digits that read back to the
/// same numbers; d = 0 if the algorithm is planar. A turn rate, a wrench and a note follow where the method
/// gives them; a situation that cannot be decided on has a note that says why. Without `keep_memory` every
/// line meets a fresh avoider with the same seed. A line's `params` override those of the options for that
/// line; with `keep_memory`, a change of them starts that vehicle's avoider afresh. Answers are written when
/// no more input is waiting, so a program may talk to it line by line.
///
/// Throws InputError: at once for an algorithm or parameter that the catalog does not have; naming the
/// line for one that cannot be used, after all answers to the lines before it.
void decide_lines(std::istream& in, std::ostream& out, const Catalog& catalog, const DecideOptions& options);

}  // namespace fairway
