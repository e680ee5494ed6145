// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/cdr.hpp"

#include <gtest/gtest.h>

#include <array>

#include "fairway/record/messages.hpp"

namespace fairway {
namespace {

std::vector<int> plain(const Bytes& bytes) {
  std::vector<int> values;
  for (const std::byte b : bytes) values.push_back(static_cast<int>(b));
  return values;
}

TEST(Cdr, AlignsEveryNumberToItsSizeBehindTheEncapsulation) {
  Bytes out;
  CdrWriter cdr{out};
  cdr.boolean(true);
  cdr.number(std::uint32_t{0x04030201});
  cdr.text("ab");
  cdr.number(1.0);
  cdr.sequence({});
  cdr.number(std::uint8_t{9});
  const std::vector<int> expected{
      0, 1, 0, 0,                        // CDR_LE, no options
      1, 0, 0, 0,                        // 0: true, three to align
      1, 2, 3, 4,                        // 4
      3, 0, 0, 0, 'a', 'b', 0,           // 8: length with the zero
      0,                                 // 15: one to align
      0, 0, 0, 0, 0,   0,   0xF0, 0x3F,  // 16: 1.0
      0, 0, 0, 0,                        // 24: empty sequence, nothing to align
      9,                                 // 28
  };
  EXPECT_EQ(plain(out), expected);
}

TEST(Cdr, AlignsTheElementsOfASequenceBehindItsCount) {
  Bytes out;
  CdrWriter cdr{out};
  const std::array values{-2.0};
  cdr.sequence(values);
  const std::vector<int> expected{0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xC0};
  EXPECT_EQ(plain(out), expected);

  CdrReader reader{out};
  std::vector<double> back{5.0};
  EXPECT_EQ(reader.sequence(back), 1U);
  reader.finish();
  EXPECT_EQ(back, (std::vector{5.0, -2.0}));
}

TEST(Cdr, RefusesAnotherEncapsulationAnEndTooEarlyAndALateOne) {
  const Bytes big_endian(8, std::byte{0});
  EXPECT_THROW(CdrReader{big_endian}, Malformed);
  EXPECT_THROW(CdrReader{ByteView{}}, Malformed);
  Bytes out;
  CdrWriter cdr{out};
  cdr.number(std::uint32_t{0xFFFFFFFF});  // a sequence of four thousand million numbers
  CdrReader reader{out};
  std::vector<double> values;
  EXPECT_THROW(reader.sequence(values), Malformed);
  EXPECT_EQ(values.capacity(), 0U);
  CdrReader late{out};
  EXPECT_THROW(late.finish(), Malformed);
}

TEST(Cdr, RefusesTextThatIsNotUtf8) {
  Bytes out;
  CdrWriter cdr{out};
  cdr.text("caf\xE9");
  EXPECT_THROW(CdrReader{out}.text(), Malformed);
}

TEST(Messages, OdometryLiesAsTheSchemaSays) {
  VehicleState state;
  state.p_n = {1.0, 2.0, 3.0};
  state.q_nb = Eigen::Quaterniond{0.5, 0.1, 0.2, 0.3};  // w, x, y, z
  state.v_b = {4.0, 5.0, 6.0};
  state.omega_b = {7.0, 8.0, 9.0};
  Bytes out;
  encode_odometry(out, Stamp{3'000'000'007}, "a/b", state);

  const auto word = [&](std::size_t offset) {
    std::uint32_t value{};
    std::memcpy(&value, out.data() + 4 + offset, sizeof(value));
    return value;
  };
  const auto real = [&](std::size_t offset) {
    double value{};
    std::memcpy(&value, out.data() + 4 + offset, sizeof(value));
    return value;
  };
  EXPECT_EQ(word(0), 3U);   // sec
  EXPECT_EQ(word(4), 7U);   // nanosec
  EXPECT_EQ(word(8), 10U);  // "world_ned" and its zero, to 22
  EXPECT_EQ(word(24), 4U);  // "a/b" and its zero, to 32
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(real(32 + 8 * i), 1.0 + static_cast<double>(i));
    EXPECT_EQ(real(56 + 8 * i), state.q_nb.coeffs()[static_cast<Eigen::Index>(i)]);
    EXPECT_EQ(real(88 + 288 + 8 * i), 4.0 + static_cast<double>(i));
    EXPECT_EQ(real(112 + 288 + 8 * i), 7.0 + static_cast<double>(i));
  }
  EXPECT_EQ(real(80), 0.5);  // w comes last
  EXPECT_EQ(out.size(), 4U + 32 + 56 + 288 + 48 + 288);
}

TEST(Messages, StampIsTheNearestNanosecond) {
  EXPECT_EQ(stamp_of(0.0).nanoseconds, 0U);
  EXPECT_EQ(stamp_of(3 * 0.1).nanoseconds, 300'000'000U);
  EXPECT_EQ(stamp_of(599.95).nanoseconds, 599'950'000'000U);
  EXPECT_THROW(stamp_of(-0.1), std::runtime_error);
  EXPECT_THROW(stamp_of(0x1p31), std::runtime_error);
  EXPECT_THROW(stamp_of(std::nan("")), std::runtime_error);
}

}  // namespace
}  // namespace fairway
