// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/sea/sea.hpp"

#include <cmath>

#include "fairway/core/math.hpp"
#include "fairway/world/sea/spectrum.hpp"

namespace fairway {
namespace {

std::vector<WaveComponent> waves_of(const WavesSpec& spec, const Rng& rng) {
  if (spec.spectrum) return sampled_sea(*spec.spectrum, rng);
  std::vector<WaveComponent> waves;
  for (const WaveSpec& wave : spec.components) waves.push_back(wave_component(wave));
  return waves;
}

}  // namespace

Sea::Sea(const WaterSpec& spec, const Rng& rng)
    : uniform_{.current_n = spec.current_n, .density = spec.density_kgpm3},
      waves_{waves_of(spec.waves, rng.stream("waves"))} {
  if (spec.current.sheared) sheared_.emplace(*spec.current.sheared);
  if (spec.current.gauss_markov) wandering_.emplace(*spec.current.gauss_markov, rng.stream("current"));
}

void Sea::advance(double h) noexcept {
  if (wandering_) wandering_->advance(h);
}

Vec3 Sea::current_at(double depth) const noexcept {
  Vec3 current_n = uniform_.current_n;
  if (wandering_) current_n += wandering_->velocity();
  if (sheared_) current_n.head<2>() += sheared_->at(depth).speed * sheared_->direction();
  return current_n;
}

Water Sea::water_there(const Vec3& p_n, double time) const noexcept {
  Water water = uniform_;
  water.current_n = current_at(p_n.z());
  if (!waves_.empty()) add_waves(p_n, time, water);
  return water;
}

void Sea::add_waves(const Vec3& p_n, double time, Water& water) const noexcept {
  const double n = p_n.x(), e = p_n.y(), depth = math::fmax(p_n.z(), 0.0);
  const bool submerged = depth > 0.0;

  // orbital velocity, its rate at a fixed place, and its gradients: of a potential flow, so that those across
  // are equal
  double v_n = 0.0, v_e = 0.0, v_d = 0.0;
  double a_n = 0.0, a_e = 0.0, a_d = 0.0;
  double g_nn = 0.0, g_ne = 0.0, g_ee = 0.0, g_nd = 0.0, g_ed = 0.0;
  double elevation = 0.0, slope_n = 0.0, slope_e = 0.0;
  for (const WaveComponent& wave : waves_) {
    const double k = wave.number, omega = wave.frequency;
    const double d_n = wave.direction.x(), d_e = wave.direction.y();
    const double phase = k * (d_n * n + d_e * e) - omega * time + wave.phase;
    const auto [s, c] = math::sin_cos(phase);
    elevation += wave.amplitude * c;
    slope_n -= k * wave.amplitude * d_n * s;
    slope_e -= k * wave.amplitude * d_e * s;

    // omega A e^(-k depth) (d cos, -sin) towards [n, e] and down
    const double speed = omega * wave.amplitude * (submerged ? math::exp(-k * depth) : 1.0);
    const double ahead = speed * c, up = speed * s;
    v_n += d_n * ahead;
    v_e += d_e * ahead;
    v_d -= up;
    a_n += omega * d_n * up;
    a_e += omega * d_e * up;
    a_d += omega * ahead;
    g_nn -= k * d_n * d_n * up;
    g_ne -= k * d_n * d_e * up;
    g_ee -= k * d_e * d_e * up;
    g_nd -= k * d_n * ahead;
    g_ed -= k * d_e * ahead;
  }
  water.elevation = elevation;
  water.slope_n = {slope_n, slope_e};
  water.current_n += Vec3{v_n, v_e, v_d};

  // Dv/Dt: at a fixed place, and as the water is carried along the gradients
  const Vec3& v = water.current_n;
  const double g_dd = submerged ? -g_nn - g_ee : 0.0;
  const double down = submerged ? v.z() : 0.0;
  water.current_rate_n = {a_n + g_nn * v.x() + g_ne * v.y() + g_nd * down,
                          a_e + g_ne * v.x() + g_ee * v.y() + g_ed * down,
                          a_d + g_nd * v.x() + g_ed * v.y() + g_dd * v.z()};
  if (sheared_)
    water.current_rate_n.head<2>() += v.z() * sheared_->at(p_n.z()).gradient * sheared_->direction();
}

}  // namespace fairway
