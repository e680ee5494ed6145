// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/origin.hpp"

#include <nlohmann/json.hpp>

namespace fairway {
namespace {

using nlohmann::ordered_json;

// rows of `meta`, beside the versions
constexpr const char* campaign_row = "campaign";
constexpr const char* makers_row = "makers";

[[noreturn]] void refuse_row(const Database& database, const std::string& what) {
  database.refuse("is a damaged store (" + what +
                  " that is none); restore a copy, or delete it and run again");
}

void put_row(Database& database, const char* name, const std::string& value) {
  Statement put{database, "INSERT OR REPLACE INTO meta(name, value) VALUES (?, ?)"};
  put.bind(1, name).bind(2, value).run();
}

std::string campaign_text(const Origin& origin) {
  ordered_json order = ordered_json::object();
  for (const auto& [name, values] : origin.order) order[name] = values;
  const ordered_json campaign{{"name", origin.campaign},         {"digest", origin.digest},
                              {"runs", origin.run_count},        {"summary", origin.summary},
                              {"quantities", origin.quantities}, {"order", order}};
  return campaign.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

void read_campaign(const std::string& text, Origin& origin, const Database& database) {
  try {
    const ordered_json campaign = ordered_json::parse(text);
    origin.campaign = campaign.at("name").get<std::string>();
    origin.summary = campaign.at("summary").get<std::string>();
    origin.digest = campaign.value("digest", "");
    origin.run_count = campaign.value("runs", std::size_t{0});
    if (campaign.contains("quantities"))
      origin.quantities = campaign["quantities"].get<std::vector<std::string>>();
    for (const auto& [name, values] : campaign.at("order").items())
      origin.order.emplace_back(name, values.get<std::vector<std::string>>());
  } catch (const ordered_json::exception&) {
    refuse_row(database, "a campaign");
  }
}

std::vector<Maker> read_makers(const std::string& text, const Database& database) {
  try {
    return nlohmann::json::parse(text).get<std::vector<Maker>>();
  } catch (const nlohmann::json::exception&) {
    refuse_row(database, "a list of makers");
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
    if (name == makers_row) origin.makers = read_makers(select.text(1), database);
  }
  return origin;
}

void note_campaign(Database& database, Origin campaign) {
  Transaction transaction{database, Transaction::Kind::write};
  const Origin before = read_origin(database);
  add_values(campaign.order, before.order);
  if (campaign_text(campaign) == campaign_text(before)) return;
  put_row(database, campaign_row, campaign_text(campaign));
  transaction.commit();
}

void note_maker(Database& database, const Maker& maker) {
  Transaction transaction{database, Transaction::Kind::write};
  std::vector<Maker> makers = read_origin(database).makers;
  const std::size_t before = makers.size();
  add_maker(makers, maker);
  if (makers.size() == before) return;
  put_row(database, makers_row,
          nlohmann::json(makers).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  transaction.commit();
}

}  // namespace fairway
