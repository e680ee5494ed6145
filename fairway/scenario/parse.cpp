// SPDX-License-Identifier: Apache-2.0
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <sstream>
#include <string_view>
#include <unordered_map>

#include "fairway/core/text.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway::yaml {
namespace {

/// Whether a byte is a further one of a character in UTF-8.
bool goes_on(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// The columns of a text in characters, which the parser counts in bytes.
class Columns {
 public:
  /// Of a text that outlives this. O(n).
  explicit Columns(std::string_view yaml) : yaml_{yaml} {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // the parser does not count it
    if (yaml_.starts_with(byte_order_mark)) yaml_.remove_prefix(byte_order_mark.size());
    for (std::size_t begin = block; begin <= yaml_.size(); begin += block)
      further_before_.push_back(further_before(begin));
  }

  /// Of a mark, from 1. O(1).
  int of(const YAML::Mark& mark) const {
    const auto end = static_cast<std::size_t>(std::max(0, mark.pos));
    const auto begin = static_cast<std::size_t>(std::max(0, mark.pos - mark.column));
    return mark.column + 1 - static_cast<int>(further_before(end) - further_before(begin));
  }

 private:
  static constexpr std::size_t block = 64;

  /// How many bytes before this one are further ones of their characters.
  std::uint32_t further_before(std::size_t byte) const {
    const std::size_t end = std::min(byte, yaml_.size());
    const std::size_t known = std::min(end / block, further_before_.size() - 1);
    const std::string_view rest = yaml_.substr(known * block, end - known * block);
    return further_before_[known] + static_cast<std::uint32_t>(std::ranges::count_if(rest, goes_on));
  }

  std::string_view yaml_;
  std::vector<std::uint32_t> further_before_{0};  // each block
};

/// Builds a tree from the parser's events. It keeps the way down to the open node on a stack of its
/// own and refuses, while reading, whatever would grow beyond the bounds.
class Builder : public YAML::EventHandler {
 public:
  Builder(std::shared_ptr<const std::string> source, const Columns& columns, bool located,
          std::size_t most_nodes)
      : source_{std::move(source)}, columns_{columns}, located_{located}, most_nodes_{most_nodes} {}

  Tree& root() { return root_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { add({.where = at(mark)}, anchor); }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const bool text = tag == "!" || tag == "tag:yaml.org,2002:str";
    if (!text) refuse_tag(mark, tag);
    add({.kind = Tree::Kind::scalar, .plain = !text, .text = value, .where = at(mark)}, anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      throw InputError(at(mark).location(), "", "an alias inside its own anchor has no end");
    count(mark, found->second.size());
    Tree copy = found->second;
    add(std::move(copy), 0);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Tree::Kind::list);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, Tree::Kind::map);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override {
    refuse_duplicates(open_.back().tree);
    close();
  }

  Where at(const YAML::Mark& mark) const {
    if (!located_ || mark.is_null()) return {.source = source_};
    return {.source = source_, .line = mark.line + 1, .column = columns_.of(mark)};
  }

 private:
  struct Open {
    Tree tree;
    YAML::anchor_t anchor{};
  };

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Tree::Kind kind) {
    if (tag != "!") refuse_tag(mark, tag);
    if (expects_key())
      throw InputError(at(mark).location(), "", "a key must be a word, not a list or mapping");
    if (open_.size() >= max_tree_depth) {
      throw InputError(at(mark).location(), "",
                       "nested deeper than " + std::to_string(max_tree_depth) + " levels");
    }
    count(mark, 1);
    open_.push_back({.tree = {.kind = kind, .where = at(mark)}, .anchor = anchor});
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    add(std::move(done.tree), done.anchor);
  }

  bool expects_key() const {
    return !open_.empty() && open_.back().tree.is_map() &&
           open_.back().tree.keys.size() == open_.back().tree.items.size();
  }

  void add(Tree tree, YAML::anchor_t anchor) {
    if (expects_key()) {
      if (!tree.is_scalar()) throw InputError(tree.where.location(), "", "a key must be a word");
      if (tree.text.size() > max_key_bytes) {
        throw InputError(
            tree.where.location(), "",
            shown(tree.text) + ": a key of more than " + std::to_string(max_key_bytes) + " bytes");
      }
      Tree& map = open_.back().tree;
      map.keys.push_back(std::move(tree.text));
      map.key_where.push_back(tree.where);
      return;
    }
    if (anchor != 0) {
      nodes_ += tree.size();
      anchors_[anchor] = tree;
    }
    if (++nodes_ > most_nodes_) throw too_large(tree.where);
    // where nothing is written, the key is what can be pointed at
    if (tree.is_null() && !open_.empty() && open_.back().tree.is_map())
      tree.where = open_.back().tree.key_where.back();
    (open_.empty() ? root_ : open_.back().tree.items.emplace_back()) = std::move(tree);
  }

  void count(const YAML::Mark& mark, std::size_t nodes) {
    nodes_ += nodes;
    if (nodes_ > most_nodes_) throw too_large(at(mark));
  }

  InputError too_large(const Where& where) const {
    return {where.location(), "",
            "more than " + std::to_string(most_nodes_) + " values, aliases written out"};
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    throw InputError(at(mark).location(), "", "the tag " + shown(tag) + " means nothing here; leave it out");
  }

  static void refuse_duplicates(const Tree& map) {
    std::vector<std::size_t> order(map.keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
      return map.keys[a] != map.keys[b] ? map.keys[a] < map.keys[b] : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i) {
      const std::string& key = map.keys[order[i]];
      if (key != map.keys[order[i - 1]]) continue;
      const int before = map.where_of(order[i - 1]).line;
      throw InputError(
          map.where_of(order[i]).location(), "",
          shown(key) + ": given twice" + (before > 0 ? ", before in line " + std::to_string(before) : ""));
    }
  }

  std::shared_ptr<const std::string> source_;
  const Columns& columns_;
  bool located_;
  std::size_t most_nodes_;
  Tree root_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, Tree> anchors_;
  std::size_t nodes_{};
};

/// The line and column of a byte of the text, from 1; columns are characters.
Location place_in(std::string_view yaml, std::size_t byte, const std::string& source) {
  const std::string_view before = yaml.substr(0, byte);
  const auto lines = std::ranges::count(before, '\n');
  const std::size_t begin = before.rfind('\n') + 1;  // npos + 1 is 0
  const auto further = std::ranges::count_if(before.substr(begin), goes_on);
  return {source, static_cast<int>(lines) + 1,
          static_cast<int>(byte - begin) + 1 - static_cast<int>(further)};
}

/// The scanner holds every token of an unclosed bracket in memory and the parser recurses, so brackets
/// are counted before either sees them. Those in quotes and comments count too: nobody writes so many.
void refuse_brackets(std::string_view yaml, const std::string& source, bool located) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < yaml.size(); ++i) {
    const char c = yaml[i];
    if (c == '[' || c == '{') {
      if (++depth > 16 * max_tree_depth)
        throw InputError(
            located ? place_in(yaml, i, source) : Location{source}, "",
            "brackets nested deeper than " + std::to_string(max_tree_depth) + " levels, or not closed");
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
}

}  // namespace

std::optional<std::string> document_in(const std::string& file) {
  std::ifstream stream{file, std::ios::binary};
  std::string text;
  std::array<char, 1 << 16> part;
  while (text.size() <= max_document_bytes && stream.read(part.data(), part.size()).gcount() > 0)
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  // a folder opens and does not read
  if (!stream.eof() && !stream.good()) return {};
  text.resize(std::min(text.size(), max_document_bytes + 1));
  return text;
}

Tree parse_tree(std::string_view yaml, const std::string& source, bool located) {
  if (yaml.size() > max_document_bytes) {
    throw InputError({source}, "",
                     "longer than " + std::to_string(max_document_bytes) + " bytes; not a scenario");
  }
  if (yaml.find('\0') != std::string_view::npos)
    throw InputError({source}, "", "holds a zero byte; not a text file");
  if (not_utf8(source)) throw InputError({source}, "", "has a name that is not UTF-8; expected another name");
  if (const std::optional<std::size_t> byte = not_utf8(yaml))
    throw InputError(located ? place_in(yaml, *byte, source) : Location{source}, "",
                     "holds a byte that is not UTF-8; save the text in that encoding");
  refuse_brackets(yaml, source, located);

  const Columns columns{yaml};
  Builder builder{std::make_shared<const std::string>(source), columns, located,
                  std::max(max_tree_nodes, yaml.size())};
  try {
    std::istringstream stream{std::string(yaml)};
    YAML::Parser parser{stream};
    if (!parser.HandleNextDocument(builder)) return {.where = builder.at({})};

    Tree root = std::move(builder.root());
    Builder second{std::make_shared<const std::string>(source), columns, located, max_tree_nodes};
    if (parser.HandleNextDocument(second))
      throw InputError({source}, "", "more than one document; keep one per file");
    return root;
  } catch (const InputError&) {
    throw;
  } catch (const YAML::Exception& error) {
    throw InputError(builder.at(error.mark).location(), "", error.msg);
  } catch (const std::exception& error) {
    throw InputError({source}, "", std::string("cannot be read as YAML: ") + error.what());
  }
}

}  // namespace fairway::yaml
