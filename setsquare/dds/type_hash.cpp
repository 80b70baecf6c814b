// SPDX-FileCopyrightText: 2026 The Setsquare authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string_view>
#include <utility>

#include "setsquare/dds/participant.hpp"

namespace setsquare::dds {
namespace {

/// REP 2011 (type description): SHA-256 of the type's description as JSON, names and types of its
/// fields. Those of messages are the same from Iron to Jazzy.
constexpr std::array<std::pair<std::string_view, std::string_view>, 17> kHashes = {{
    {"sensor_msgs/msg/LaserScan",
     "RIHS01_64c191398013af96509d518dac71d5164f9382553fce5c1f8cca5be7924bd828"},
    {"sensor_msgs/msg/Imu",
     "RIHS01_7d9a00ff131080897a5ec7e26e315954b8eae3353c3f995c55faf71574000b5b"},
    {"nav_msgs/msg/Odometry",
     "RIHS01_3cc97dc7fb7502f8714462c526d369e35b603cfc34d946e3f2eda2766dfec6e0"},
    {"nav_msgs/msg/OccupancyGrid",
     "RIHS01_8d348150c12913a31ee0ec170fbf25089e4745d17035792a1ba94d6f0bc0cfc7"},
    {"nav_msgs/msg/MapMetaData",
     "RIHS01_2772d4b2000ef2b35dbaeb80fd3946c1369f817fb4f75677d916d27c17d763c8"},
    {"nav_msgs/msg/Path",
     "RIHS01_1957a5bb3cee5da65c4e52e52b65a93df227efce4c20f8458b36e73066ca334b"},
    {"tf2_msgs/msg/TFMessage",
     "RIHS01_e369d0f05a23ae52508854b66f6aa0437f3449d652e8cbf22d5abe85d020f087"},
    {"geometry_msgs/msg/PoseStamped",
     "RIHS01_10f3786d7d40fd2b54367835614bff85d4ad3b5dab62bf8bca0cc232d73b4cd8"},
    {"geometry_msgs/msg/PoseWithCovarianceStamped",
     "RIHS01_26432f9803e43727d3c8f668d1fdb3c630f548af631e2f4e31382371bfea3b6e"},
    {"diagnostic_msgs/msg/DiagnosticArray",
     "RIHS01_5a8a36efb05fb25070fa0fb3810290c0e6cd4862b54a8fb975a1ee8dc55a333e"},
    {"rmw_dds_common/msg/ParticipantEntitiesInfo",
     "RIHS01_91a0593bacdcc50ea9bdcf849a938b128412cc1ea821245c663bcd26f83c295e"},
    {"std_srvs/srv/Trigger",
     "RIHS01_50f80190089cf21a4a98e6b54c84bfbf061e79df123170fd040e11352d263fed"},
    {"std_srvs/srv/SetBool",
     "RIHS01_c394f3b32fe2b0545e485745d5243554a5bd92849b82a985c2991bfb75927694"},
    {"nav_msgs/srv/GetMap",
     "RIHS01_b568bc7928f4fe64856365220590f4847b04d9619a48a667c6964f2aeb295efd"},
    {"slam_toolbox/srv/Pause",
     "RIHS01_dba65e8de85ce7bc1b85c1b34e341d0b460afce211fdc057780b89934dfdae5a"},
    {"slam_toolbox/srv/Reset",
     "RIHS01_34414bb08e1a14b61aa0adb53a11dcaa9615e43365cfba02fb20f1aa10838a88"},
    {"slam_toolbox/srv/SaveMap",
     "RIHS01_01722f508d0fbd079f05eed1c15bcbf71301747c9dc1d925d2f4809cc363bfb5"},
}};

}  // namespace

std::string_view type_hash(std::string_view ros_type) {
  for (const auto& [type, hash] : kHashes) {
    if (type == ros_type) return hash;
  }
  return {};
}

}  // namespace setsquare::dds
