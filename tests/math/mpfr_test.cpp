// SPDX-License-Identifier: Apache-2.0
// How far the functions of core/math.hpp are from the true values, which MPFR gives to 200 bits.
#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <vector>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/rng.hpp"

namespace fairway {
namespace {

constexpr double allowed = 1.0;  // the most that was found is 0.91, of expm1

class Big {
 public:
  explicit Big(double value = 0.0) {
    mpfr_init2(digits, 200);
    mpfr_set_d(digits, value, MPFR_RNDN);
  }
  Big(const Big&) = delete;
  Big& operator=(const Big&) = delete;
  ~Big() { mpfr_clear(digits); }

  mpfr_t digits;
};

/// |got - truth| in units of the last place that a double next to the truth has.
double error_of(double got, const Big& truth) {
  const double nearest = mpfr_get_d(truth.digits, MPFR_RNDN);
  if (!std::isfinite(nearest) || !std::isfinite(got)) {
    const bool same = std::isnan(nearest) ? std::isnan(got) : got == nearest;
    return same ? 0.0 : INFINITY;
  }
  if (nearest == 0.0) return got == 0.0 ? 0.0 : INFINITY;
  const long last = std::max(mpfr_get_exp(truth.digits) - 53L, -1074L);
  Big off;
  mpfr_sub_d(off.digits, truth.digits, got, MPFR_RNDN);
  mpfr_mul_2si(off.digits, off.digits, -last, MPFR_RNDN);
  return std::fabs(mpfr_get_d(off.digits, MPFR_RNDN));
}

using Draw = std::function<double(Rng&)>;

Draw between(double low, double high) {
  return [=](Rng& rng) { return rng.uniform(low, high); };
}

/// Every exponent as often, with whatever is no number.
double any_bits(Rng& rng) { return std::bit_cast<double>(rng.next()); }

double signed_scale(Rng& rng) {
  return (rng.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0) * math::exp(rng.uniform(-30.0, 30.0));
}

constexpr int draws = 20'000;

void expect_close(const char* name, double ours(double), int theirs(mpfr_t, const mpfr_t, mpfr_rnd_t),
                  const std::vector<Draw>& kinds) {
  Rng rng = Rng{20}.stream(name);
  double worst = 0.0, at = 0.0;
  for (const Draw& kind : kinds) {
    for (int i = 0; i < draws; ++i) {
      const double x = kind(rng);
      const Big argument{x};
      Big truth;
      theirs(truth.digits, argument.digits, MPFR_RNDN);
      if (const double error = error_of(ours(x), truth); error > worst) worst = error, at = x;
    }
  }
  EXPECT_LT(worst, allowed) << name << " of " << at;
}

// next to a multiple of pi/2, where nearly all digits cancel
double near_quarter_turns(Rng& rng) {
  const double beside = static_cast<double>(rng.index(600'000)) * (0.5 * pi);
  return std::nextafter(beside, rng.uniform(-1.0, 1.0) < 0.0 ? -1e9 : 1e9);
}

double near_one(Rng& rng) {
  const double off = math::exp(-rng.uniform(0.0, 36.0));
  return rng.uniform(-1.0, 1.0) < 0.0 ? off - 1.0 : 1.0 - off;
}

TEST(MathAgainstMpfr, SinesAreWithinAUnitOfTheLastPlaceAtAnyAngle) {
  const std::vector<Draw> angles{between(-pi, pi), between(-1e3, 1e3), between(-0x1p22, 0x1p22),
                                 near_quarter_turns, any_bits};
  expect_close("sin", math::sin, mpfr_sin, angles);
  expect_close("cos", math::cos, mpfr_cos, angles);
}

TEST(MathAgainstMpfr, TheHardestAngleIsReduced) {
  // 6381956970095103 2^797 is nearer to a multiple of pi/2 than any other double (Muller 2016, section 11.2)
  for (const double angle : {0x1.6ac5b262ca1ffp849, -0x1.6ac5b262ca1ffp849, 0x1p20, 0x1.fffffffffffffp1023}) {
    const Big argument{angle};
    Big sine, cosine;
    mpfr_sin_cos(sine.digits, cosine.digits, argument.digits, MPFR_RNDN);
    EXPECT_LT(error_of(math::sin(angle), sine), allowed) << angle;
    EXPECT_LT(error_of(math::cos(angle), cosine), allowed) << angle;
  }
}

TEST(MathAgainstMpfr, ArcsAreWithinAUnitOfTheLastPlace) {
  expect_close("asin", math::asin, mpfr_asin, {between(-1.0, 1.0), near_one, any_bits});
  expect_close("acos", math::acos, mpfr_acos, {between(-1.0, 1.0), near_one, any_bits});
  expect_close("atan", math::atan, mpfr_atan, {between(-3.0, 3.0), signed_scale, any_bits});
}

TEST(MathAgainstMpfr, DirectionsAreWithinAUnitOfTheLastPlace) {
  Rng rng{21};
  for (const Draw& kind : {between(-1.0, 1.0), Draw{signed_scale}, Draw{any_bits}}) {
    double worst = 0.0;
    for (int i = 0; i < 2 * draws; ++i) {
      const double y = kind(rng), x = kind(rng);
      const Big of_y{y}, of_x{x};
      Big truth;
      mpfr_atan2(truth.digits, of_y.digits, of_x.digits, MPFR_RNDN);
      worst = std::max(worst, error_of(math::atan2(y, x), truth));
    }
    EXPECT_LT(worst, allowed);
  }
}

TEST(MathAgainstMpfr, ExponentialsAndLogarithmsAreWithinAUnitOfTheLastPlace) {
  const std::vector<Draw> exponents{between(-1.0, 1.0), between(-50.0, 50.0), between(-760.0, 760.0),
                                    any_bits};
  expect_close("exp", math::exp, mpfr_exp, exponents);
  expect_close("expm1", math::expm1, mpfr_expm1, exponents);
  expect_close("log", math::log, mpfr_log,
               {between(0.5, 2.0), between(0.9, 1.1), between(0.0, 1e3), any_bits});
}

}  // namespace
}  // namespace fairway
