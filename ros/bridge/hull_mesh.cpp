// SPDX-License-Identifier: Apache-2.0
#include "ros/bridge/hull_mesh.hpp"

#include <array>
#include <cmath>
#include <utility>

namespace fairway::bridge {
namespace {

constexpr int sides = 12;
constexpr double full_turn = 6.283185307179586;

class Mesh {
 public:
  /// A body of revolution about the forward axis: (x, radius) from bow to stern. [m]
  void turn(const std::vector<std::pair<double, double>>& profile, const Triple& centre) {
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
      for (int k = 0; k < sides; ++k) {
        const double a = full_turn * k / sides, b = full_turn * (k + 1) / sides;
        quad(rim(profile[i], a, centre), rim(profile[i + 1], a, centre), rim(profile[i + 1], b, centre),
             rim(profile[i], b, centre));
      }
    }
  }

  void box(const Triple& centre, const Triple& size) {
    const auto corner = [&](int x, int y, int z) {
      return Triple{centre[0] + 0.5 * x * size[0], centre[1] + 0.5 * y * size[1],
                    centre[2] + 0.5 * z * size[2]};
    };
    for (const int s : {-1, 1}) {
      quad(corner(s, -s, -1), corner(s, s, -1), corner(s, s, 1), corner(s, -s, 1));
      quad(corner(-1, s, -s), corner(-1, s, s), corner(1, s, s), corner(1, s, -s));
      quad(corner(-s, -1, s), corner(s, -1, s), corner(s, 1, s), corner(-s, 1, s));
    }
  }

  std::vector<Triple> take() { return std::move(triangles_); }

 private:
  static Triple rim(const std::pair<double, double>& at, double angle, const Triple& centre) {
    return {centre[0] + at.first, centre[1] + at.second * std::cos(angle),
            centre[2] + at.second * std::sin(angle)};
  }

  /// Counter-clockwise from outside: so viewers light it.
  void quad(const Triple& a, const Triple& b, const Triple& c, const Triple& d) {
    triangles_.insert(triangles_.end(), {a, b, c, a, c, d});
  }

  std::vector<Triple> triangles_;
};

/// A round nose, a straight body, a pointed stern.
void add_torpedo(Mesh& mesh, double length, double beam, const Triple& centre) {
  const double l = length, r = 0.5 * beam;
  mesh.turn({{0.5 * l, 0.0},
             {0.48 * l, 0.55 * r},
             {0.42 * l, 0.9 * r},
             {0.35 * l, r},
             {-0.2 * l, r},
             {-0.4 * l, 0.6 * r},
             {-0.5 * l, 0.15 * r},
             {-0.5 * l, 0.0}},
            centre);
}

void add_fins(Mesh& mesh, double length, double beam) {
  mesh.box({-0.42 * length, 0.0, 0.0}, {0.1 * length, 1.6 * beam, 0.06 * beam});
  mesh.box({-0.42 * length, 0.0, 0.0}, {0.1 * length, 0.06 * beam, 1.6 * beam});
}

}  // namespace

std::vector<Triple> hull_mesh(const std::string& shape, double length, double beam) {
  Mesh mesh;
  if (shape == "auv") {
    // a hovering vehicle has a thruster on either side and a mast
    add_torpedo(mesh, length, beam, {});
    mesh.box({-0.35 * length, 0.0, 0.0}, {0.12 * length, 2.4 * beam, 0.3 * beam});
    mesh.box({-0.1 * length, 0.0, -0.8 * beam}, {0.06 * length, 0.15 * beam, 0.8 * beam});
  } else if (shape == "torpedo") {
    add_torpedo(mesh, length, beam, {});
    add_fins(mesh, length, beam);
  } else if (shape == "rov") {
    mesh.box({0.0, 0.0, -0.25 * beam}, {length, beam, 0.4 * beam});
    mesh.box({0.0, 0.4 * beam, 0.2 * beam}, {length, 0.1 * beam, 0.5 * beam});
    mesh.box({0.0, -0.4 * beam, 0.2 * beam}, {length, 0.1 * beam, 0.5 * beam});
  } else if (shape == "catamaran") {
    const double hull_beam = 0.25 * beam;
    for (const double side : {-1.0, 1.0})
      add_torpedo(mesh, length, hull_beam, {0.0, side * 0.5 * (beam - hull_beam), 0.0});
    mesh.box({-0.05 * length, 0.0, -0.7 * hull_beam}, {0.6 * length, beam, 0.3 * hull_beam});
  } else if (shape == "transport") {
    mesh.box({}, {length, beam, 0.25 * length});
  } else {
    std::vector<std::pair<double, double>> profile;
    constexpr int rings = 8;
    for (int k = 0; k <= rings; ++k) {
      const double angle = 0.5 * full_turn * k / rings;
      profile.emplace_back(0.5 * length * std::cos(angle), 0.5 * beam * std::sin(angle));
    }
    mesh.turn(profile, {});
  }
  return mesh.take();
}

}  // namespace fairway::bridge
