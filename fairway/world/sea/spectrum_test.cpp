// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fairway/core/angles.hpp"

namespace fairway {
namespace {

double height_of(const std::vector<WaveComponent>& waves) {
  double m_0 = 0.0;
  for (const WaveComponent& wave : waves) m_0 += wave.amplitude * wave.amplitude / 2.0;
  return 4.0 * std::sqrt(m_0);
}

TEST(Spectrum, JonswapHasTheValuesOfAnIndependentCode) {
  // Octave, MSS toolbox' spectrum 7 with Hs 0.14 m, omega_0 1 rad/s, gamma 3.3, to the digits it printed
  EXPECT_NEAR(jonswap(0.8, 0.14, 1.0, 3.3), 5.9270679e-4, 5e-12);
  EXPECT_NEAR(jonswap(1.0, 0.14, 1.0, 3.3), 3.8066662e-3, 5e-11);
  EXPECT_NEAR(jonswap(1.2, 0.14, 1.0, 3.3), 9.7969132e-4, 5e-12);
  EXPECT_NEAR(jonswap(2.0, 0.14, 1.0, 3.3), 1.1636429e-4, 5e-12);
}

TEST(Spectrum, JonswapWithoutAPeakIsPiersonAndMoskowitz) {
  for (int i = 1; i < 30; ++i)
    EXPECT_EQ(jonswap(0.1 * i, 2.0, 0.8, 1.0), pierson_moskowitz(0.1 * i, 2.0, 0.8));
}

TEST(Spectrum, PiersonAndMoskowitzHaveTheHeightThatIsAskedFor) {
  // m_0 = Hs^2 / 16 in closed form: dm_0 = Hs^2/16 d exp(-5/4 (omega_0 / omega)^4)
  double m_0 = 0.0;
  constexpr double step = 1e-3;
  for (int i = 0; i < 40000; ++i) m_0 += step * pierson_moskowitz((i + 0.5) * step, 3.0, 0.7);
  EXPECT_NEAR(4.0 * std::sqrt(m_0), 3.0, 1e-4);
}

TEST(Spectrum, JonswapHasTheHeightThatIsAskedForWithinTheErrorOfItsNormalisation) {
  // measured: 1 - 0.287 ln gamma is off by 0.12 % in height up to gamma = 5, by -0.88 % at 7
  for (const double gamma : {1.0, 2.0, 3.3, 5.0, 7.0}) {
    double m_0 = 0.0;
    constexpr double step = 1e-3;
    for (int i = 0; i < 40000; ++i) m_0 += step * jonswap((i + 0.5) * step, 3.0, 0.7, gamma);
    EXPECT_NEAR(4.0 * std::sqrt(m_0), 3.0, 0.01 * 3.0) << gamma;
  }
}

TEST(Spectrum, PeakednessByTheRuleOfDnvFallsWithTheSteepness) {
  // T_p / sqrt(Hs) = 3, 4 and 6 at Hs = 4 m: 5, exp(5.75 - 4.6) and 1
  EXPECT_EQ(dnv_peakedness(4.0, 2 * pi / 6.0), 5.0);
  EXPECT_NEAR(dnv_peakedness(4.0, 2 * pi / 8.0), std::exp(1.15), 1e-12);
  EXPECT_EQ(dnv_peakedness(4.0, 2 * pi / 12.0), 1.0);
  EXPECT_EQ(jonswap(0.9, 4.0, 2 * pi / 12.0, 0.0), jonswap(0.9, 4.0, 2 * pi / 12.0, 1.0));
}

TEST(SampledSea, HasTheSignificantHeightThatIsAskedFor) {
  for (const SpectrumKind kind : {SpectrumKind::jonswap, SpectrumKind::pierson_moskowitz}) {
    for (const std::int32_t count : {1, 5, 50, 1000}) {
      const SpectrumSpec spec{
          .spectrum = kind, .significant_height_m = 0.5, .peak_period_s = 4.0, .components_count = count};
      const auto waves = sampled_sea(spec, Rng{7});
      ASSERT_EQ(waves.size(), static_cast<std::size_t>(count));
      EXPECT_NEAR(height_of(waves), 0.5, 1e-12);
    }
  }
}

TEST(SampledSea, ALongRecordHasTheSignificantHeightToo) {
  const SpectrumSpec spec{.significant_height_m = 0.5, .peak_period_s = 4.0};
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto waves = sampled_sea(spec, Rng{seed});
    double sum = 0.0, squares = 0.0;
    constexpr int samples = 100'000;  // of half a second: 3.5 hours of peaks
    for (int i = 0; i < samples; ++i) {
      double elevation = 0.0;
      for (const WaveComponent& w : waves)
        elevation += w.amplitude * std::cos(w.phase - w.frequency * 0.5 * i);
      sum += elevation;
      squares += elevation * elevation;
    }
    const double mean = sum / samples;
    EXPECT_NEAR(4.0 * std::sqrt(squares / samples - mean * mean), 0.5, 0.02 * 0.5) << seed;
  }
}

TEST(SampledSea, EachBinHasItsEnergy) {
  // waves of a band against the integral of S over it
  const SpectrumSpec spec{.significant_height_m = 2.0, .peak_period_s = 2 * pi, .components_count = 250};
  const auto waves = sampled_sea(spec, Rng{3});
  for (const double from : {0.7, 0.9, 1.1, 1.5, 2.0}) {  // edges of bins: they are 0.01 wide
    double drawn = 0.0, expected = 0.0;
    for (const WaveComponent& w : waves) {
      if (w.frequency >= from && w.frequency < from + 0.2) drawn += w.amplitude * w.amplitude / 2.0;
    }
    for (int i = 0; i < 200; ++i) expected += 1e-3 * jonswap(from + (i + 0.5) * 1e-3, 2.0, 1.0, 3.3);
    EXPECT_NEAR(drawn, expected, 0.02 * expected) << from;
  }
}

TEST(SampledSea, DoesNotRepeatItself) {
  // without jitter it would, after 2 pi / width = 1/2.5 * 50 peak periods
  const SpectrumSpec spec{.significant_height_m = 1.0, .peak_period_s = 5.0};
  const auto waves = sampled_sea(spec, Rng{1});
  const double period = 5.0 * 50 / 2.5;
  double now = 0.0, later = 0.0;
  for (const WaveComponent& w : waves) {
    now += w.amplitude * std::cos(w.phase);
    later += w.amplitude * std::cos(w.phase - w.frequency * period);
  }
  EXPECT_GT(std::abs(now - later), 0.05);
}

TEST(SampledSea, TheSameSeedIsTheSameSeaAndAnotherIsNot) {
  const SpectrumSpec spec{.significant_height_m = 1.0, .spreading_count = 2};
  const auto a = sampled_sea(spec, Rng{5}), b = sampled_sea(spec, Rng{5}), c = sampled_sea(spec, Rng{6});
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].frequency, b[i].frequency);
    EXPECT_EQ(a[i].phase, b[i].phase);
    EXPECT_EQ(a[i].direction, b[i].direction);
    EXPECT_NE(a[i].phase, c[i].phase);
  }
}

TEST(SampledSea, SpreadsAboutItsDirectionAsAsked) {
  // the mean of cos^2 of the angle under cos^2s is (2s + 1) / (2s + 2)
  SpectrumSpec spec{.significant_height_m = 1.0, .direction_rad = 2.0, .components_count = 1000};
  for (const std::int32_t s : {1, 4, 20}) {
    spec.spreading_count = s;
    double cosine2 = 0.0;
    for (const WaveComponent& w : sampled_sea(spec, Rng{9})) {
      const double along = w.direction.x() * std::cos(2.0) + w.direction.y() * std::sin(2.0);
      EXPECT_GT(along, 0.0);
      cosine2 += along * along / 1000.0;
    }
    EXPECT_NEAR(cosine2, (2.0 * s + 1) / (2.0 * s + 2), 0.02) << s;
  }
  spec.spreading_count = 0;
  for (const WaveComponent& w : sampled_sea(spec, Rng{9}))
    EXPECT_NEAR(std::atan2(w.direction.y(), w.direction.x()), 2.0, 1e-15);
}

}  // namespace
}  // namespace fairway
