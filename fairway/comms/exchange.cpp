// SPDX-License-Identifier: Apache-2.0
#include "fairway/comms/exchange.hpp"

#include <vector>

namespace fairway {

Exchange::Exchange(std::string_view kind, const ParamValues& params, std::size_t, double, Rng) {
  const std::vector<std::string_view> kinds{"perfect", "none"};
  if (kind != "perfect" && kind != "none")
    throw InputError({}, "kind", "unknown exchange" + suggestion(kind, kinds));
  if (!params.empty())
    throw InputError({}, params.front().first, std::string(kind) + " exchange takes no parameters");
  kind_ = kind == "none" ? Kind::none : Kind::perfect;
}

void Exchange::pass_on(Tick, const Mailbox& said, std::span<const Vec3>) {
  if (kind_ == Kind::perfect) heard_ = said;
}

std::span<const Message> Exchange::heard_by(std::size_t) const { return heard_; }

}  // namespace fairway
