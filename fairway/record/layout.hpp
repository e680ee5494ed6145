// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace fairway::layout {

// What writer and reader agree on; README.md explains it.
inline constexpr int format = 3;  ///< grows when another fairway could not read the file

inline constexpr std::string_view frame_topic = "/fairway/frame";
inline constexpr std::string_view transforms_topic = "/tf";
inline constexpr std::string_view perception_topic = "/fairway/perception";
inline constexpr std::string_view flights_topic = "/fairway/flights";  ///< where sketches are recorded
inline constexpr std::string_view words_topic = "/fairway/words";      ///< where methods speak
inline constexpr std::string_view odometry_topic = "odometry";         ///< behind "/<vehicle>/"
inline constexpr std::string_view status_topic = "status";             ///< likewise
inline constexpr std::string_view tracks_topic = "tracks";       ///< likewise, where perception is recorded
inline constexpr std::string_view echoes_topic = "echoes";       ///< likewise
inline constexpr std::string_view sketch_topic = "sketch";       ///< likewise, where sketches are recorded
inline constexpr std::string_view body_frame = "base_link_fsd";  ///< behind "<vehicle>/"

inline constexpr std::string_view run_metadata = "fairway";      ///< before the frames
inline constexpr std::string_view end_metadata = "fairway.end";  ///< behind them
inline constexpr std::string_view divergence = "diverged";       ///< its entry where the run broke
inline constexpr std::string_view scenario_attachment = "scenario.yaml";

}  // namespace fairway::layout
