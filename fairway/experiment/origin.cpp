// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/origin.hpp"

#include <nlohmann/json.hpp>

namespace fairway {
namespace {

using nlohmann::ordered_json;

// a row of `meta`, beside the versions
constexpr const char* campaign_row = "campaign";

std::string campaign_text(const Origin& origin) {
  ordered_json order = ordered_json::object();
  for (const auto& [name, values] : origin.order) order[name] = values;
  const ordered_json campaign{{"name", origin.campaign},
                              {"summary", origin.summary},
                              {"quantities", origin.quantities},
                              {"order", order}};
  return campaign.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void read_campaign(const std::string& text, Origin& origin, const Database& database) {
  try {
    const ordered_json campaign = ordered_json::parse(text);
    origin.campaign = campaign.at("name").get<std::string>();
    origin.summary = campaign.at("summary").get<std::string>();
    if (campaign.contains("quantities"))
      origin.quantities = campaign["quantities"].get<std::vector<std::string>>();
    for (const auto& [name, values] : campaign.at("order").items())
      origin.order.emplace_back(name, values.get<std::vector<std::string>>());
  } catch (const ordered_json::exception&) {
    database.refuse(
        "is a damaged store (a campaign that is none); restore a copy, or delete it and run again");
  }
}

}  // namespace

Origin read_origin(Database& database) {
  Origin origin;
  Statement select{database, "SELECT name, value FROM meta"};
  while (select.step()) {
    const std::string name = select.text(0);
    if (name == "fairway_version") origin.version = select.text(1);
    if (name == "results_epoch") origin.epoch = select.text(1);
    if (name == campaign_row) read_campaign(select.text(1), origin, database);
  }
  return origin;
}

void note_campaign(Database& database, Origin campaign) {
  Transaction transaction{database, Transaction::Kind::write};
  const Origin before = read_origin(database);
  add_values(campaign.order, before.order);
  if (campaign_text(campaign) == campaign_text(before)) return;
  Statement put{database, "INSERT OR REPLACE INTO meta(name, value) VALUES (?, ?)"};
  put.bind(1, campaign_row).bind(2, campaign_text(campaign)).run();
  transaction.commit();
}

}  // namespace fairway
