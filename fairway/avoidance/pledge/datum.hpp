// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "fairway/avoidance/pledge/agreement.hpp"
#include "fairway/core/speech.hpp"

namespace fairway::pledge {

/// Holds the distances that modems measure there and back against the places that members promise. Where the
/// two differ by more than both tubes, one of the two is not where it says: it is off its tube (A2), or tells
/// its place from another datum or with a greater error than its tube holds (A4). What one word alone
/// measures is left out, since a thousandth of a second between two clocks is more than a metre in it.
class DatumWatch {
 public:
  /// To be called at every decision. `rests`: own ship, if it is held, is where it says. `unsure`: by how
  /// much own sphere is larger for an error that own navigation states [m]; the others are taken to be as
  /// unsure. O(members · knots).
  void look(const Agreement& agreement, std::span<const AcousticRange> ranges, bool rests,
            double unsure) noexcept;

  /// Whose last two distances did not fit.
  Members doubted() const noexcept;

 private:
  struct Known {
    double back{};  ///< when the last one was measured [s]
    int misfits{};  ///< in a row
  };

  std::array<Known, most_members> known_{};
};

}  // namespace fairway::pledge
