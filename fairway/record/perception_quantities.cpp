// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/perception_quantities.hpp"

#include <algorithm>
#include <array>

#include "fairway/core/text.hpp"

namespace fairway {

namespace {

using T = const Track&;

template <Mat3 Track::*covariance, int row, int column>
std::string covariance_text(T track) {
  return number_text((track.*covariance)(row, column));
}

template <int axis>
std::string destination_text(T track) {
  return track.destination ? number_text((*track.destination)[axis]) : std::string{};
}

constexpr auto position_covariance = &Track::position_covariance;
constexpr auto velocity_covariance = &Track::velocity_covariance;

constexpr std::array track_list{
    TrackQuantity{"id", [](T t) { return std::to_string(number(t.id)); }},
    TrackQuantity{"x_m", [](T t) { return number_text(t.position.x()); }},
    TrackQuantity{"y_m", [](T t) { return number_text(t.position.y()); }},
    TrackQuantity{"z_m", [](T t) { return number_text(t.position.z()); }},
    TrackQuantity{"velocity_n_mps", [](T t) { return number_text(t.velocity.x()); }},
    TrackQuantity{"velocity_e_mps", [](T t) { return number_text(t.velocity.y()); }},
    TrackQuantity{"velocity_d_mps", [](T t) { return number_text(t.velocity.z()); }},
    TrackQuantity{"yaw_rad", [](T t) { return number_text(t.yaw); }},
    TrackQuantity{"radius_m", [](T t) { return number_text(t.radius); }},
    TrackQuantity{"age_s", [](T t) { return number_text(t.age); }},
    TrackQuantity{"priority", [](T t) { return std::to_string(t.priority); }},
    TrackQuantity{"reacts", [](T t) { return std::string(t.reacts ? "true" : "false"); }},
    TrackQuantity{"destination_n_m", destination_text<0>},
    TrackQuantity{"destination_e_m", destination_text<1>},
    TrackQuantity{"destination_d_m", destination_text<2>},
    TrackQuantity{"position_covariance_nn_m2", covariance_text<position_covariance, 0, 0>},
    TrackQuantity{"position_covariance_ne_m2", covariance_text<position_covariance, 0, 1>},
    TrackQuantity{"position_covariance_nd_m2", covariance_text<position_covariance, 0, 2>},
    TrackQuantity{"position_covariance_en_m2", covariance_text<position_covariance, 1, 0>},
    TrackQuantity{"position_covariance_ee_m2", covariance_text<position_covariance, 1, 1>},
    TrackQuantity{"position_covariance_ed_m2", covariance_text<position_covariance, 1, 2>},
    TrackQuantity{"position_covariance_dn_m2", covariance_text<position_covariance, 2, 0>},
    TrackQuantity{"position_covariance_de_m2", covariance_text<position_covariance, 2, 1>},
    TrackQuantity{"position_covariance_dd_m2", covariance_text<position_covariance, 2, 2>},
    TrackQuantity{"velocity_covariance_nn_m2ps2", covariance_text<velocity_covariance, 0, 0>},
    TrackQuantity{"velocity_covariance_ne_m2ps2", covariance_text<velocity_covariance, 0, 1>},
    TrackQuantity{"velocity_covariance_nd_m2ps2", covariance_text<velocity_covariance, 0, 2>},
    TrackQuantity{"velocity_covariance_en_m2ps2", covariance_text<velocity_covariance, 1, 0>},
    TrackQuantity{"velocity_covariance_ee_m2ps2", covariance_text<velocity_covariance, 1, 1>},
    TrackQuantity{"velocity_covariance_ed_m2ps2", covariance_text<velocity_covariance, 1, 2>},
    TrackQuantity{"velocity_covariance_dn_m2ps2", covariance_text<velocity_covariance, 2, 0>},
    TrackQuantity{"velocity_covariance_de_m2ps2", covariance_text<velocity_covariance, 2, 1>},
    TrackQuantity{"velocity_covariance_dd_m2ps2", covariance_text<velocity_covariance, 2, 2>},
};

std::string element(const char* list, std::size_t i, std::string_view quantity) {
  return std::string(list) + "[" + std::to_string(i) + "]." + std::string(quantity);
}

std::optional<QuantityDifference> differing_texts(std::string what, std::string in_a, std::string in_b) {
  if (in_a == in_b) return std::nullopt;
  return QuantityDifference{std::move(what), std::move(in_a), std::move(in_b)};
}

std::optional<QuantityDifference> first_track_difference(std::span<const Track> a, std::span<const Track> b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (const auto& [name, text] : track_list) {
      if (auto found = differing_texts(element("tracks", i, name), text(a[i]), text(b[i]))) return found;
    }
  }
  return differing_texts("track_count", std::to_string(a.size()), std::to_string(b.size()));
}

std::optional<QuantityDifference> first_echo_difference(std::span<const Echo> a, std::span<const Echo> b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (const auto& [name, value] :
         {std::pair{"range_m", &Echo::range}, std::pair{"bearing_rad", &Echo::bearing}}) {
      if (auto found = differing_texts(element("echoes", i, name), number_text(a[i].*value),
                                       number_text(b[i].*value))) {
        return found;
      }
    }
  }
  return differing_texts("echo_count", std::to_string(a.size()), std::to_string(b.size()));
}

}  // namespace

std::span<const TrackQuantity> track_quantities() { return track_list; }

std::optional<QuantityDifference> first_perception_difference(const VehicleFrame& a, const VehicleFrame& b) {
  if (auto tracks = first_track_difference(a.tracks, b.tracks)) return tracks;
  return first_echo_difference(a.echoes, b.echoes);
}

}  // namespace fairway
