// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/apf/apf.hpp"
#include "fairway/avoidance/avoa/avoa.hpp"
#include "fairway/avoidance/avoa_improved/avoa_improved.hpp"
#include "fairway/avoidance/bvc/bvc.hpp"
#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/delay_check/delay_check.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/hard_switching/hard_switching.hpp"
#include "fairway/avoidance/hrvo/hrvo.hpp"
#include "fairway/avoidance/inflate/inflate.hpp"
#include "fairway/avoidance/orca2d/orca2d.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/pledge/pledge.hpp"
#include "fairway/avoidance/rvo/rvo.hpp"
#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"
#include "fairway/avoidance/trackable/trackable.hpp"
#include "fairway/avoidance/vo/vo.hpp"
#include "fairway/avoidance/wall_following/wall_following.hpp"
#include "fairway/avoidance/way_round/shortest_way.hpp"

namespace fairway {

Catalog builtin_avoiders() {
  return Catalog{}
      .add<Direct>()
      .add<Apf>()
      .add<Orca3d>()
      .add<Orca2d>()
      .add<Bvc>()
      .add<Pledge>()
      .add<DelayCheck>()
      .add<Vo>()
      .add<Rvo>()
      .add<Hrvo>()
      .add<HardSwitching>()
      .add<WallFollowing>()
      .add<Avoa>()
      .add<AvoaImproved>()
      .add_wrapper<StopAndWait, Direct>()
      .add_wrapper<SafetyFilter, Direct>()
      .add_wrapper<Inflate, Direct>()
      .add_wrapper<Trackable, Direct>()
      .add_wrapper<ShortestWay, Direct>()
      .alias("saw", "stop_and_wait")
      .alias("cbf", "safety_filter");
}

}  // namespace fairway
