// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/digest.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

TEST(DigestTest, IsTheOneOfThePublishedVectors) {
  // draft-eastlake-fnv, appendix C
  EXPECT_EQ(Digest::of(""), "6c62272e07bb014262b821756295c58d");
  EXPECT_EQ(Digest::of("a"), "d228cb696f1a8caf78912b704e4a8964");
  EXPECT_EQ(Digest::of("foobar"), "343e1662793c64bf6f0d3597ba446f18");
}

TEST(DigestTest, TellsWhereOneTextEndsAndTheNextBegins) {
  EXPECT_NE(Digest{}.add("ab").add("c").hex(), Digest{}.add("a").add("bc").hex());
  EXPECT_NE(Digest{}.add("").hex(), Digest{}.hex());
}

}  // namespace
}  // namespace fairway
