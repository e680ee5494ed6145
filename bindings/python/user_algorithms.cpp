// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/user_algorithms.hpp"

#include <pybind11/numpy.h>

#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bindings/python/situations.hpp"
#include "bindings/python/user_constructor.hpp"
#include "bindings/python/values.hpp"

namespace fairway::python {
namespace {

namespace py = pybind11;

/// What ends a run in C++; the exception of Python itself is kept, and raised again by rethrow().
struct AlgorithmRaised : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The first exception of a run, with its traceback.
struct Failure final : FrameSink {
  std::exception_ptr raised;
  std::string summary;

  void keep(const std::string& name, const std::exception_ptr& exception, const std::string& text) {
    if (raised) return;
    raised = exception;
    summary = name + ": " + text;
  }
  void write(const Frame&) override {
    if (raised) throw AlgorithmRaised(summary);
  }
};

/// Lets go of it with the interpreter's lock, whoever holds it last.
using Held = std::shared_ptr<py::object>;

Held held(py::object object) {
  return {new py::object{std::move(object)}, [](py::object* last) {
            const py::gil_scoped_acquire lock;
            delete last;
          }};
}

[[noreturn]] void raise(PyObject* type, const std::string& message) {
  PyErr_SetString(type, message.c_str());
  throw py::error_already_set();
}

std::string type_name(const py::handle& object) {
  return py::str(py::type::handle_of(object).attr("__name__"));
}

/// Three finite numbers. Raises TypeError or ValueError.
Vec3 velocity_of(const std::string& name, const py::object& answer) {
  const std::string expected =
      "the algorithm \"" + name + "\" is to decide on a Command or on three numbers [m/s, NED], not on ";
  if (!py::isinstance<py::sequence>(answer) && !py::isinstance<py::array>(answer))
    raise(PyExc_TypeError, expected + type_name(answer));
  using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
  const auto numbers = Numbers::ensure(answer);
  if (!numbers) {
    PyErr_Clear();
    raise(PyExc_TypeError, expected + std::string(py::repr(answer)));
  }
  if (numbers.ndim() != 1 || numbers.size() != 3)
    raise(PyExc_TypeError, expected + "an array of shape " + std::string(py::str(numbers.attr("shape"))));
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

Command command_by(const std::string& name, const py::object& answer) {
  Command command = py::isinstance<Command>(answer) ? py::cast<Command>(answer)
                                                    : Command{.velocity = velocity_of(name, answer)};
  if (!is_finite(command))
    raise(PyExc_ValueError, "the algorithm \"" + name + "\" decided on " + std::string(py::repr(answer)) +
                                ", which is not finite");
  return command;
}

/// Says in which vehicle's decision an exception came up, where Python can (3.11).
void add_note(const py::error_already_set& error, const std::string& note) {
  if (error.value() && py::hasattr(error.value(), "add_note")) error.value().attr("add_note")(note);
}

/// An object of Python behind the interface of an algorithm. A copy is a deep copy.
class UserAlgorithm {
 public:
  static constexpr AlgorithmInfo info{
      .name = "python", .title = "An algorithm written in Python", .source = "", .allocates = true};
  using Params = NoParams;
  using Memory = NoMemory;

  UserAlgorithm() = default;
  explicit UserAlgorithm(NoParams) {}
  UserAlgorithm(const UserConstructor& constructor, Failure& failure, py::object object)
      : name_{&constructor.name()}, failure_{&failure}, object_{held(std::move(object))} {}
  UserAlgorithm(const UserAlgorithm& other)
      : name_{other.name_}, failure_{other.failure_}, object_{other.copied()} {}
  UserAlgorithm(UserAlgorithm&&) noexcept = default;
  UserAlgorithm& operator=(const UserAlgorithm& other) {
    UserAlgorithm copy{other};
    *this = std::move(copy);
    return *this;
  }
  UserAlgorithm& operator=(UserAlgorithm&&) noexcept = default;
  ~UserAlgorithm() = default;

  NoParams params;

  Command decide(const Situation& situation, NoMemory&, Context&) const noexcept {
    if (failure_ == nullptr || failure_->raised) return {.mode = Mode::infeasible};
    const py::gil_scoped_acquire lock;
    try {
      return command_by(*name_, object_->attr("decide")(OwnedSituation{situation}));
    } catch (py::error_already_set& error) {
      keep(error, " of the vehicle " + std::to_string(number(situation.own.id)) + " at " +
                      std::to_string(situation.time) + " s");
    } catch (const std::exception& error) {
      failure_->keep(*name_, std::current_exception(), error.what());
    }
    return {.mode = Mode::infeasible};
  }

 protected:
  /// What its speech() gives: bytes, or None.
  Speech spoken() const noexcept {
    if (failure_ == nullptr || failure_->raised) return {};
    const py::gil_scoped_acquire lock;
    try {
      const py::object said = object_->attr("speech")();
      return said.is_none() ? Speech{}
                            : Read<Speech>::from(said, "speech() of the algorithm \"" + *name_ + "\"");
    } catch (py::error_already_set& error) {
      keep(error, ", asked for its speech");
    } catch (const std::exception& error) {
      failure_->keep(*name_, std::current_exception(), error.what());
    }
    return {};
  }

  /// What its reading() says of a word.
  std::string read(const Heard& word) const {
    if (failure_ == nullptr || failure_->raised) return {};
    const py::gil_scoped_acquire lock;
    try {
      return py::str(object_->attr("reading")(HeardSpeech{word.from, word.sent, word.speech}));
    } catch (py::error_already_set& error) {
      keep(error, ", asked to read a word");
    }
    return {};
  }

 private:
  void keep(py::error_already_set& error, const std::string& when) const noexcept {
    try {
      add_note(error, "in the algorithm \"" + *name_ + "\"" + when);
    } catch (const std::exception&) {  // the exception stands without a note
    }
    failure_->keep(*name_, std::current_exception(), first_line(error));
  }

  Held copied() const {
    if (!object_) return {};
    const py::gil_scoped_acquire lock;
    try {
      return held(py::module_::import("copy").attr("deepcopy")(*object_));
    } catch (py::error_already_set& error) {
      failure_->keep(*name_, std::current_exception(), first_line(error));
      throw AlgorithmRaised(failure_->summary);
    }
  }

  const std::string* name_{nullptr};
  Failure* failure_{nullptr};
  Held object_;
};

/// One with a method speech().
class SpeakingUserAlgorithm : public UserAlgorithm {
 public:
  using UserAlgorithm::UserAlgorithm;
  Speech speech(const NoMemory&) const noexcept { return spoken(); }
};

/// One with a method reading() besides.
class ReadingUserAlgorithm : public SpeakingUserAlgorithm {
 public:
  using SpeakingUserAlgorithm::SpeakingUserAlgorithm;
  Reading reading(const Heard& word) const { return {.text = read(word)}; }
};

static_assert(AvoidanceAlgorithm<UserAlgorithm> && !Speaks<UserAlgorithm>);
static_assert(AvoidanceAlgorithm<SpeakingUserAlgorithm> && Speaks<SpeakingUserAlgorithm>);
static_assert(Speaks<ReadingUserAlgorithm> && ReadsWords<ReadingUserAlgorithm>);

}  // namespace

struct UserAlgorithms::Self {
  Catalogs catalogs = builtin_catalogs();
  std::vector<std::unique_ptr<UserConstructor>> constructors;
  Failure failure;

  Avoider make(const UserConstructor& constructor, const ParamValues& values, Rng rng) {
    const py::gil_scoped_acquire lock;
    try {
      const py::object made = constructor(values, rng);
      const bool speaks = py::hasattr(made, "speech"), reads = py::hasattr(made, "reading");
      if (speaks && reads) return Avoider{ReadingUserAlgorithm{constructor, failure, made}, rng};
      if (speaks) return Avoider{SpeakingUserAlgorithm{constructor, failure, made}, rng};
      return Avoider{UserAlgorithm{constructor, failure, made}, rng};
    } catch (py::error_already_set& error) {
      failure.keep(constructor.name(), std::current_exception(), first_line(error));
      throw AlgorithmRaised(failure.summary);
    }
  }
};

UserAlgorithms::UserAlgorithms(const py::object& algorithms) : self_{std::make_unique<Self>()} {
  if (algorithms.is_none()) return;
  Catalog& catalog = self_->catalogs.avoiders;
  for (const auto& [key, value] : named_algorithms(algorithms)) {
    if (catalog.has(key))
      throw InputError("the algorithm \"" + key + "\" comes with fairway: choose another name");
    self_->constructors.push_back(std::make_unique<UserConstructor>(key, value));
    const UserConstructor& constructor = *self_->constructors.back();
    AlgorithmInfo info = UserAlgorithm::info;
    info.name = constructor.name();
    catalog.add(
        {.info = info,
         .params = constructor.params(),
         .make = [self = self_.get(), &constructor](const ParamValues& values,
                                                    Rng rng) { return self->make(constructor, values, rng); },
         .make_around = {}});
  }
}

UserAlgorithms::~UserAlgorithms() = default;

const Catalogs& UserAlgorithms::catalogs() const { return self_->catalogs; }

FrameSink& UserAlgorithms::guard() { return self_->failure; }

void UserAlgorithms::rethrow() {
  if (!self_->failure.raised) return;
  const std::exception_ptr raised = std::exchange(self_->failure.raised, nullptr);
  std::rethrow_exception(raised);
}

void with_algorithms(const py::object& algorithms,
                     const std::function<void(const Catalogs&, FrameSink&)>& work) {
  const py::gil_scoped_acquire locked;
  UserAlgorithms users{algorithms};
  std::exception_ptr failed;
  try {
    const py::gil_scoped_release unlocked;
    work(users.catalogs(), users.guard());
  } catch (...) {
    failed = std::current_exception();
  }
  users.rethrow();
  if (failed) std::rethrow_exception(failed);
}

}  // namespace fairway::python
