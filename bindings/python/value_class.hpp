// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "bindings/python/values.hpp"
#include "fairway/core/record.hpp"

namespace fairway::python {

/// Adds a plain struct to the module as a value: made by keywords, never changed afterwards, so that nothing
/// which it lends can dangle. With `replace`, comparison, `repr`, copies and pickling. Mistakes are
/// InputErrors of one line with the nearest name.
template <class T>
class ValueClass {
 public:
  enum class Presence : std::uint8_t { optional, required };

  ValueClass(py::module_& m, const char* name, const char* doc)
      : class_{m, name}, name_{name}, doc_{doc}, attributes_{std::make_shared<Attributes>()} {}

  /// What the constructor takes by this name, and the attribute.
  template <class V>
  ValueClass& field(const std::string& name, V T::*member, std::string_view meaning,
                    Presence presence = Presence::optional) {
    const std::string doc{meaning};
    attributes_->push_back({name, presence == Presence::required,
                            [member](T& target, py::handle given, const std::string& path) {
                              target.*member = Read<V>::from(given, path);
                            },
                            [member](const T& value, py::handle self) { return show(value.*member, self); }});
    class_.def_property_readonly(
        name.c_str(), [member](const py::object& self) { return show(made<T>(self).*member, self); },
        doc.c_str());
    const Hint hint = hint_of<V>();
    constructor_ += ", " + name + ": " + hint.given + " = ...";
    stub_ += "    " + name + ": Final[" + hint.shown + "]\n";
    doc_ += "\n" + name + ": " + doc + (presence == Presence::required ? " (required)" : "");
    return *this;
  }
  /// All members of a record; those named have to be given.
  ValueClass& members(std::initializer_list<std::string_view> required = {})
    requires RecordType<T>
  {
    for_each_member<T>([&](const auto& m) {
      const bool is_required = std::ranges::find(required, m.name) != required.end();
      field(std::string(m.name), m.at, m.meaning, is_required ? Presence::required : Presence::optional);
    });
    return *this;
  }
  template <class V>
  ValueClass& required(const std::string& name, V T::*member, std::string_view doc) {
    return field(name, member, doc, Presence::required);
  }

  /// Called with every new value and the keywords that it is made of; may throw InputError.
  using Settle = std::function<void(T&, const py::dict& given)>;

  /// Completes the class; further methods may be added to it.
  py::class_<T> finish(Settle settle = {}) {
    class_.attr("__doc__") = doc_;
    class_.attr("_stub") = "    def __init__(self" + constructor_ + ") -> None: ...\n" + stub_;
    const auto make = [attributes = attributes_, name = name_, settle](const py::dict& given) {
      T value{};
      for (const auto& [key, item] : given) set(value, *attributes, name, py::cast<std::string>(key), item);
      if (settle) settle(value, given);
      return value;
    };
    class_.def(py::init(
        [attributes = attributes_, name = name_, make](const py::args& args, const py::kwargs& kwargs) {
          return make(keywords(*attributes, name, args, kwargs));
        }));
    class_.def(py::pickle(
        [attributes = attributes_](const py::object& self) { return everything(*attributes, self); }, make));
    add_replace(make);
    add_comparison();
    add_repr();
    for (const char* copy : {"__copy__", "__deepcopy__"})
      class_.def(copy, [](const py::object& self, const py::args&) { return self; });
    return class_;
  }

 private:
  struct Attribute {
    std::string name;
    bool is_required;
    std::function<void(T&, py::handle, const std::string& path)> set;
    std::function<py::object(const T&, py::handle self)> get;
  };
  using Attributes = std::vector<Attribute>;

  static void set(T& value, const Attributes& attributes, const std::string& name, const std::string& key,
                  py::handle item) {
    std::vector<std::string_view> known;
    for (const Attribute& attribute : attributes) {
      if (key == attribute.name) return attribute.set(value, item, name + "." + key);
      known.emplace_back(attribute.name);
    }
    throw InputError({}, name + "." + key, "there is no such field" + suggestion(key, known));
  }

  /// What a constructor was called with, by name.
  static py::dict keywords(const Attributes& attributes, const std::string& name, const py::args& args,
                           const py::kwargs& kwargs) {
    if (args.size() > attributes.size())
      throw InputError(name + ": expected at most " + std::to_string(attributes.size()) + " values");
    py::dict given{**kwargs};
    for (std::size_t i = 0; i < args.size(); ++i) {
      if (given.contains(attributes[i].name.c_str()))
        throw InputError(name + "." + attributes[i].name + ": given twice");
      given[attributes[i].name.c_str()] = args[i];
    }
    for (const Attribute& attribute : attributes) {
      if (attribute.is_required && !given.contains(attribute.name.c_str()))
        throw InputError(name + ": " + attribute.name + " is missing");
    }
    return given;
  }

  static py::dict everything(const Attributes& attributes, const py::object& self) {
    py::dict all;
    for (const Attribute& attribute : attributes)
      all[attribute.name.c_str()] = self.attr(attribute.name.c_str());
    return all;
  }

  /// For comparison and text: arrays as lists.
  static py::object plain(const py::object& value) {
    return py::isinstance<py::array>(value) ? value.attr("tolist")() : value;
  }

  template <class Make>
  void add_replace(const Make& make) {
    class_.def(
        "replace",
        [attributes = attributes_, make](const py::object& self, const py::kwargs& changes) {
          py::dict all = everything(*attributes, self);
          for (const auto& [key, item] : changes) all[key] = item;
          return make(all);
        },
        "The same with these fields changed.");
  }

  void add_comparison() {
    class_.def("__eq__", [attributes = attributes_](const py::object& self, const py::object& other) {
      if (!py::isinstance<T>(other)) return py::object(py::reinterpret_borrow<py::object>(Py_NotImplemented));
      const auto same = [&](const Attribute& attribute) {
        return plain(self.attr(attribute.name.c_str())).equal(plain(other.attr(attribute.name.c_str())));
      };
      return py::object(py::bool_(std::ranges::all_of(*attributes, same)));
    });
    class_.attr("__hash__") = py::none();
  }

  void add_repr() {
    class_.def("__repr__", [attributes = attributes_, name = name_](const py::object& self) {
      const py::object usual = py::cast(T{});
      std::string text;
      for (const Attribute& attribute : *attributes) {
        const py::object value = plain(self.attr(attribute.name.c_str()));
        if (value.equal(plain(usual.attr(attribute.name.c_str()))) && !attribute.is_required) continue;
        text += (text.empty() ? "" : ", ") + attribute.name + "=" + py::repr(value).cast<std::string>();
      }
      return name + "(" + text + ")";
    });
  }

  py::class_<T> class_;
  std::string name_;
  std::string doc_;
  std::string constructor_, stub_;  ///< as in a stub file
  std::shared_ptr<Attributes> attributes_;
};

}  // namespace fairway::python
