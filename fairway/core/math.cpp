// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/math.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

// The coefficients are of Sollya's fpminimax, which looks for the best ones among doubles. For sin on [0,
// pi/4]:
//     fpminimax(sin(x), [|3,5,7,9,11,13|], [|D...|], [2^-30;pi/4+2^-10], relative, x);
// and so for the others, with the interval and the first terms that stand beside them. "Error" is that of the
// polynomial alone. What is branched on is rare, or costs more than it decides; the rest is selected, so that
// lanes could do the same.

namespace fairway::math {
namespace {

// ---- sums, products and polynomials

/// A number and what its rounding left out.
struct Pair {
  double high;
  double low;
};

/// a + b, exactly; |a| >= |b|, or a = 0 (Dekker 1971).
inline Pair sum_of_ordered(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// a + b, exactly (Knuth).
inline Pair sum(double a, double b) {
  const double sum = a + b, b_of_sum = sum - a;
  return {sum, (a - (sum - b_of_sum)) + (b - b_of_sum)};
}

/// The upper half of the digits, 26 bits: products of two such are exact, and so is what is left.
inline double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xFFFFFFFFF8000000U);
}

/// rest - a b, to twice the digits where `rest` is about a b.
inline double less_product(double rest, double a, double b) {
  const double a_high = upper_half(a), a_low = a - a_high;
  const double b_high = upper_half(b), b_low = b - b_high;
  return (((rest - a_high * b_high) - a_high * b_low) - a_low * b_high) - a_low * b_low;
}

template <std::size_t N>
using Coefficients = std::array<double, N>;

template <std::size_t exponent>
inline double power_of(double x) {
  if constexpr (exponent == 1) {
    return x;
  } else {
    const double root = power_of<exponent / 2>(x);
    return root * root;
  }
}

/// c[first] + c[first + 1] x + ..., `count` terms, halves side by side (Estrin): half as long to wait for as
/// Horner's scheme.
template <std::size_t first, std::size_t count, std::size_t N>
inline double terms(double x, const Coefficients<N>& c) {
  if constexpr (count == 1) {
    return c[first];
  } else {
    constexpr std::size_t half = std::bit_ceil(count) / 2;
    return terms<first, half>(x, c) + power_of<half>(x) * terms<first + half, count - half>(x, c);
  }
}

template <std::size_t N>
inline double polynomial(double x, const Coefficients<N>& c) {
  return terms<0, N>(x, c);
}

/// Added to a small number and taken away again it rounds to the nearest integer, which then stands in the
/// last bits of the sum.
constexpr double rounder = 0x1.8p52;

inline std::int64_t integer_in(double rounded_sum) {
  return std::bit_cast<std::int64_t>(rounded_sum) - std::bit_cast<std::int64_t>(rounder);
}

inline double two_to(std::int64_t exponent) {  // -1022 .. 1023
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

// ---- sine and cosine

constexpr Coefficients<6> sin_terms{
    -0x1.5555555555548p-3, 0x1.111111110f748p-7,   -0x1.a01a019bede9ep-13,  // x; error 2^-57
    0x1.71de355a62745p-19, -0x1.ae5e503ade499p-26, 0x1.5d8cd8ffb5473p-33};
constexpr Coefficients<6> cos_terms{
    0x1.555555555554bp-5,   -0x1.6c16c16c15005p-10, 0x1.a01a019c8c678p-16,  // 1 - x^2/2; 2^-63
    -0x1.27e4f7eee8b47p-22, 0x1.1ee9d99eb730ap-29,  -0x1.8fa5375b3d0d9p-37};

/// An angle without its quarter turns: angle = quarters pi/2 + r, |r| <= pi/4.
struct Reduced {
  std::uint64_t quarters;  ///< the last two bits count
  Pair r;
};

/// For |angle| <= 2^20. pi/2 in three parts of 33 bits, whose products with a count of 20 bits are exact, and
/// a rest (Cody and Waite).
inline Reduced reduced(double angle) {
  const double rounded = angle * 0x1.45f306dc9c883p-1 + rounder;  // 2/pi
  const double n = rounded - rounder;
  const Pair a = sum(angle - n * 0x1.921fb544p0, -n * 0x1.0b4611a6p-34);
  const Pair b = sum(a.high, -n * 0x1.3198a2ep-69);
  return {std::bit_cast<std::uint64_t>(rounded), {b.high, (a.low + b.low) - n * 0x1.b839a252049c1p-104}};
}

/// 2/pi from its 64 zeros before the point on, 32 bits a word.
constexpr std::array<std::uint32_t, 39> two_over_pi{
    0x00000000U, 0x00000000U, 0xA2F9836EU, 0x4E441529U, 0xFC2757D1U, 0xF534DDC0U, 0xDB629599U, 0x3C439041U,
    0xFE5163ABU, 0xDEBBC561U, 0xB7246E3AU, 0x424DD2E0U, 0x06492EEAU, 0x09D1921CU, 0xFE1DEB1CU, 0xB129A73EU,
    0xE88235F5U, 0x2EBB4484U, 0xE99C7026U, 0xB45F7E41U, 0x3991D639U, 0x835339F4U, 0x9C845F8BU, 0xBDF9283BU,
    0x1FF897FFU, 0xDE05980FU, 0xEF2F118BU, 0x5A0A6D1FU, 0x6D367ECFU, 0x27CB09B7U, 0x4F463F66U, 0x9E5FEA2DU,
    0x7527BAC7U, 0xEBE5F17BU, 0x3D0739F7U, 0x8A5292EAU, 0x6BFB5FB1U, 0x1F8D5D08U, 0x56033046U};

/// For any finite |angle| >= 2^20: of the product with 2/pi only those bits are worked out that are neither
/// whole turns nor too small (Payne and Hanek 1983).
Reduced reduced_from_afar(double angle) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(angle);
  const std::uint64_t digits = (bits & 0xFFFFFFFFFFFFFU) | 0x10000000000000U;
  const auto exponent = static_cast<unsigned>((bits >> 52U) & 0x7FFU) - 1075U +
                        62U;  // of the window's first bit, 2 in quarters

  std::array<std::uint64_t, 6> window{};  // 192 bits of 2/pi, the last word first
  for (unsigned i = 0; i < 6; ++i) {
    const unsigned word = exponent / 32U + i, shift = exponent % 32U;
    const std::uint64_t two = std::uint64_t{two_over_pi[word]} << 32U | two_over_pi[word + 1];
    window[5 - i] = two << shift >> 32U;
  }

  std::array<std::uint64_t, 6> product{};  // modulo four quarters
  for (unsigned half = 0; half < 2; ++half) {
    const std::uint64_t factor = digits >> (32U * half) & 0xFFFFFFFFU;
    std::uint64_t carry = 0;
    for (unsigned i = half; i < 6; ++i) {
      carry += product[i] + window[i - half] * factor;
      product[i] = carry & 0xFFFFFFFFU;
      carry >>= 32U;
    }
  }

  std::uint64_t quarters = product[5] >> 30U;
  const bool above_half = (product[5] >> 29U & 1U) != 0;  // then it is the next quarter, less what is missing
  quarters += above_half ? 1U : 0U;
  product[5] &= 0x3FFFFFFFU;
  Pair fraction{0.0, 0.0};
  double weight = 0x1p-30;
  for (unsigned i = 6; i-- > 0; weight *= 0x1p-32) {
    const std::uint64_t missing = (i == 5 ? 0x3FFFFFFFU : 0xFFFFFFFFU) - product[i] + (i == 0 ? 1U : 0U);
    const Pair more =
        sum_of_ordered(fraction.high, static_cast<double>(above_half ? missing : product[i]) * weight);
    fraction = {more.high, fraction.low + more.low};
  }
  const double high = fraction.high * 0x1.921fb54442d18p0;
  const double low = -less_product(high, fraction.high, 0x1.921fb54442d18p0) +
                     (fraction.high * 0x1.1a62633145c07p-54 + fraction.low * 0x1.921fb54442d18p0);
  const Pair r = sum_of_ordered(high, low);
  const bool negative = (bits >> 63U) != 0;
  if (negative) quarters = 0U - quarters;
  if (negative != above_half) return {quarters, {-r.high, -r.low}};
  return {quarters, r};
}

inline double sin_near_zero(const Pair& r) {
  const double z = r.high * r.high;
  return r.high + ((r.low - 0.5 * z * r.low) + z * r.high * polynomial(z, sin_terms));
}

inline double cos_near_zero(const Pair& r) {
  const double z = r.high * r.high;
  const Pair first = sum_of_ordered(1.0, -0.5 * z);
  return first.high + (first.low + (z * z * polynomial(z, cos_terms) - r.high * r.low));
}

}  // namespace

SinCos sin_cos(double angle) noexcept {
  if (!(std::fabs(angle) < INFINITY)) return {angle - angle, angle - angle};
  const Reduced of = std::fabs(angle) <= 0x1p20 ? reduced(angle) : reduced_from_afar(angle);
  const double s = sin_near_zero(of.r), c = cos_near_zero(of.r);
  const bool swapped = (of.quarters & 1U) != 0;
  const double sine = swapped ? c : s, cosine = swapped ? s : c;
  return {angle == 0.0              ? angle
          : (of.quarters & 2U) != 0 ? -sine
                                    : sine,
          ((of.quarters + 1U) & 2U) != 0 ? -cosine : cosine};
}

double sin(double angle) noexcept { return sin_cos(angle).sin; }
double cos(double angle) noexcept { return sin_cos(angle).cos; }

// ---- their inverses

namespace {

constexpr Coefficients<12> atan_terms{// x, to sqrt(2) - 1; error 2^-63
                                      -0x1.5555555555554p-2, 0x1.99999999995bep-3,  -0x1.24924924720fep-3,
                                      0x1.c71c71b5f20a3p-4,  -0x1.745d14907df9cp-4, 0x1.3b136b01eda9cp-4,
                                      -0x1.110c494893a95p-4, 0x1.e16f24c97dfb2p-5,  -0x1.ab6cc80548763p-5,
                                      0x1.70aee496bb643p-5,  -0x1.11b1741da82c3p-5, 0x1.efed154df4a17p-7};
constexpr Coefficients<13> asin_terms{// x, to 1/2; error 2^-59
                                      0x1.5555555555577p-3, 0x1.333333332e133p-4, 0x1.6db6db721247bp-5,
                                      0x1.f1c71a95002fbp-6, 0x1.6e8bdedebf9dfp-6, 0x1.1c49f077d5bc7p-6,
                                      0x1.ca1f8af1f0a39p-7, 0x1.75859dad05d9ap-7, 0x1.613c1e6ed7236p-7,
                                      0x1.e5fbe88dfeb2cp-9, 0x1.639a894e21126p-6, -0x1.57fad0dea93ccp-6,
                                      0x1.0b45e9f72d94bp-5};
constexpr Pair eighth_turn{0x1.921fb54442dp-1,
                           0x1.8469898cc517p-49};  // pi/4; four times the first part is exact
constexpr Pair quarter_turn{0x1.921fb54442d18p0, 0x1.1a62633145c07p-54};

/// Where neither of them overflows or vanishes. Of the angle to the nearest axis, and above pi/8 of that to
/// the diagonal, the tangent is worked out to twice the digits.
inline double direction(double y, double x) {
  const double along = std::fabs(x), across = std::fabs(y);
  const bool steep = across > along, astern = std::signbit(x);
  const double longer = steep ? across : along, shorter = steep ? along : across;
  const bool diagonal = shorter > longer * 0x1.a827999fcef32p-2;  // tan pi/8

  const Pair difference = sum_of_ordered(-longer, shorter), total = sum_of_ordered(longer, shorter);
  const Pair numerator = diagonal ? difference : Pair{shorter, 0.0};
  const Pair denominator = diagonal ? total : Pair{longer, 0.0};
  const double inverse = 1.0 / denominator.high;
  const double tangent = numerator.high * inverse;
  const double rest =
      less_product(numerator.high, tangent, denominator.high) + (numerator.low - tangent * denominator.low);
  const double z = tangent * tangent;
  const double tail = rest * inverse + tangent * z * polynomial(z, atan_terms);

  const int eighths_before = diagonal ? 1 : 0;
  const int eighths_on_side = steep ? 2 - eighths_before : eighths_before;
  const double eighths = astern ? 4 - eighths_on_side : eighths_on_side;
  const double sign = steep != astern ? -1.0 : 1.0;
  const Pair first = sum_of_ordered(eighths * eighth_turn.high, sign * tangent);
  return std::copysign(first.high + (first.low + (eighths * eighth_turn.low + sign * tail)), y);
}

/// Where one of them does, or is no number.
double direction_at_the_edge(double y, double x, double longer) {
  if (x != x || y != y) return x + y;
  if (longer == 0.0) return direction(y, std::copysign(1.0, x));
  if (longer < 0x1p700) return direction(y * 0x1p200, x * 0x1p200);
  if (longer < INFINITY) return direction(y * 0x1p-8, x * 0x1p-8);
  const auto reach = [](double v) { return std::copysign(std::fabs(v) < INFINITY ? 0.0 : 1.0, v); };
  return direction(reach(y), reach(x));
}

/// The arc sine of `small`, high + low: of |x| up to 1/2, and beyond of sqrt((1 - |x|) / 2), which is half of
/// what is missing to pi/2.
struct Arc {
  bool beyond;
  Pair of;  ///< its tail is in `low`
};

inline Arc arc_of(double x) {
  const double size = std::fabs(x), half_rest = 0.5 * (1.0 - size);
  const bool beyond = size > 0.5;
  const double z = beyond ? half_rest : size * size;
  const double small = beyond ? std::sqrt(half_rest) : size;
  const double high = beyond ? upper_half(small) : small;
  const double low = beyond && small > 0.0 ? (z - high * high) / (small + high) : 0.0;
  return {beyond, {high, low + small * (z * polynomial(z, asin_terms))}};
}

}  // namespace

double atan2(double y, double x) noexcept {
  const double along = std::fabs(x), across = std::fabs(y);
  const double longer = along > across ? along : across, shorter = along > across ? across : along;
  const bool usual = longer < 0x1p1000 && longer > 0x1p-900 && (shorter > 0x1p-900 || shorter == 0.0);
  return usual ? direction(y, x) : direction_at_the_edge(y, x, longer);
}

double atan(double x) noexcept { return atan2(x, 1.0); }

double asin(double x) noexcept {
  const auto [beyond, arc] = arc_of(x);
  if (!beyond) return std::copysign(arc.high + arc.low, x);
  const Pair first = sum_of_ordered(quarter_turn.high, -2.0 * arc.high);
  return std::copysign(first.high + (first.low - (2.0 * arc.low - quarter_turn.low)), x);
}

double acos(double x) noexcept {
  const auto [beyond, arc] = arc_of(x);
  if (beyond && x > 0.0) return 2.0 * (arc.high + arc.low);
  const double turns = beyond ? 2.0 : 1.0;  // quarters
  const double sign = beyond ? -2.0 : x < 0.0 ? 1.0 : -1.0;
  const Pair first = sum_of_ordered(turns * quarter_turn.high, sign * arc.high);
  return first.high + (first.low + (sign * arc.low + turns * quarter_turn.low));
}

// ---- exponential and logarithm

namespace {

constexpr Coefficients<10> exp_terms{// e^x - 1: x + x^2/2, to ln(2) / 2; error 2^-60
                                     0x1.555555555555cp-3,  0x1.555555555555ap-5,  0x1.111111110e9cp-7,
                                     0x1.6c16c16c141e6p-10, 0x1.a01a01b46919dp-13, 0x1.a01a01b1d6e72p-16,
                                     0x1.71ddee00fda7dp-19, 0x1.27e4c3082955bp-22, 0x1.af6f63764c88dp-26,
                                     0x1.1f9960f1950bap-29};
constexpr Coefficients<7> log_terms{// 2 atanh(x): 2 x, to (sqrt(2) - 1) / (sqrt(2) + 1); error 2^-59
                                    0x1.5555555555593p-1, 0x1.999999997f957p-2, 0x1.2492494239a4p-2,
                                    0x1.c71c51c70a87cp-3, 0x1.74664de266ef9p-3, 0x1.39a017b63dfcap-3,
                                    0x1.2f1714590b5ap-3};
constexpr Pair ln2{0x1.62e42fefa4p-1,
                   -0x1.8432a1b0e2634p-43};  // a product of the first with 11 bits is exact

/// x = twos ln 2 + r, |r| <= ln(2) / 2, and e^r - 1 = r + half_square + tail.
struct Exponent {
  std::int64_t twos;
  double r;
  double half_square;
  double tail;
};

inline Exponent exponent_of(double x) {  // |x| < 1000
  const double rounded = x * 0x1.71547652b82fep0 + rounder;
  const double n = rounded - rounder;
  const Pair r = sum_of_ordered(x - n * ln2.high, -n * ln2.low);
  const double square = r.high * r.high;
  return {integer_in(rounded), r.high, 0.5 * square, square * r.high * polynomial(r.high, exp_terms) + r.low};
}

}  // namespace

double exp(double x) noexcept {
  const double held = x > 750.0 ? 750.0 : x < -750.0 ? -750.0 : x;  // beyond, all is infinite, or nothing
  if (held != held) return held;
  const auto [twos, r, half_square, tail] = exponent_of(held);
  const Pair first = sum_of_ordered(1.0, r);
  const std::int64_t half = twos / 2;  // neither half overflows, and only the last product is rounded
  return (first.high + (first.low + (half_square + tail))) * two_to(half) * two_to(twos - half);
}

double expm1(double x) noexcept {
  if (x == 0.0) return x;
  if (!(std::fabs(x) < 40.0)) return exp(x) - 1.0;
  const auto [twos, r, half_square, tail] = exponent_of(x);
  const double scale = two_to(twos);
  const Pair first = sum(scale, -1.0), second = sum(first.high, scale * r),
             third = sum(second.high, scale * half_square);
  return third.high + (third.low + (second.low + (first.low + scale * tail)));
}

double log(double x) noexcept {
  if (!(x > 0.0)) return x == 0.0 ? -INFINITY : NAN;
  if (!(x < INFINITY)) return x;
  const bool tiny = x < 0x1p-1022;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(tiny ? x * 0x1p54 : x);
  constexpr std::uint64_t root_half = 0x3FE6A09E667F3BCDU;             // sqrt(1/2)
  const std::uint64_t above = bits - root_half + 0x3FF0000000000000U;  // its exponent counts from sqrt(1/2)
  const double twos = static_cast<double>(static_cast<std::int64_t>(above >> 52U) - (tiny ? 1077 : 1023));
  const double f = std::bit_cast<double>((above & 0xFFFFFFFFFFFFFU) + root_half) - 1.0;

  // ln(1 + f) = 2 atanh(s), s = f / (2 + f), of which 2 s = f - f^2/2 + s f^2/2
  const double s = f / (2.0 + f), z = s * s, half_square = 0.5 * f * f;
  const double tail = s * (half_square + z * polynomial(z, log_terms)) + twos * ln2.low;
  return twos * ln2.high + (f - (half_square - tail));
}

}  // namespace fairway::math
