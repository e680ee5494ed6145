// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <map>
#include <string>
#include <vector>

#include "ros/ros1/conversions.hpp"

namespace fairway::ros1 {

using Colour = std::array<float, 4>;  ///< red, green, blue, alpha

/// What is shown at one instant on one topic. Each time all is added anew; what was there the last time and
/// is not any more is deleted, so that a viewer shows the present and nothing flickers.
class MarkerSet {
 public:
  MarkerSet(Frame frame, std::string world) : frame_{frame}, world_{std::move(world)} {}

  void begin(double time);

  /// A marker of the type, to be completed; valid until the next is added. Ids count within a name space.
  visualization_msgs::Marker& add(const std::string& name_space, std::int32_t type, const Colour& colour);

  /// Something at a place [m, NED] with an attitude, body to NED. Sizes in the order of the body's axes [m].
  visualization_msgs::Marker& add_solid(const std::string& name_space, std::int32_t type,
                                        const Colour& colour, const Motion& where, const Triple& size);
  void add_sphere(const std::string& name_space, const Colour& colour, const Triple& centre_n,
                  double diameter);
  /// Words that face the viewer, above a place [m, NED].
  void add_words(const std::string& name_space, const Colour& colour, const Triple& place_n, double height,
                 const std::string& words);
  /// Points in order [m, NED].
  void add_line(const std::string& name_space, const Colour& colour, const std::vector<Triple>& points_n,
                double width);
  /// What an algorithm drew or a scenario holds, by its meaning.
  void add_mark(const bridge::Mark& mark);

  /// All of it, and the deletions. Valid until begin().
  const visualization_msgs::MarkerArray& finish();

 private:
  struct Count {
    int before{};
    int now{};
  };

  Frame frame_;
  std::string world_;
  ros::Time stamp_;
  visualization_msgs::MarkerArray markers_;
  std::map<std::string, Count> counts_;  // by name space
};

}  // namespace fairway::ros1
