// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/apf/apf.hpp"
#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/direct/direct.hpp"
#include "fairway/avoidance/orca3d/orca3d.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"

namespace fairway {

Catalog builtin_avoiders() {
  return Catalog{}.add<Direct>().add<Apf>().add<Orca3d>().add_wrapper<StopAndWait, Direct>().alias(
      "saw", "stop_and_wait");
}

}  // namespace fairway
