// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <memory>

#include "fairway/record/frame.hpp"
#include "fairway/sim/catalogs.hpp"

namespace fairway::python {

/// Algorithms written in Python, for one run: so that an exception in one of them ends that run alone.
/// Made and destroyed with the interpreter's lock held; in between a run may go on without it: whatever calls
/// Python takes the lock for the call.
class UserAlgorithms {
 public:
  /// `algorithms`: name -> class or factory; called with the parameters of a vehicle as keywords, it gives an
  /// object with decide(situation) -> Command. None: there are none. Throws InputError for a name that is
  /// taken.
  explicit UserAlgorithms(const pybind11::object& algorithms);
  ~UserAlgorithms();

  /// All that comes with fairway, and these. Lives no longer than this.
  const Catalogs& catalogs() const;

  /// A sink that ends the run with an exception of C++ once an algorithm has raised.
  FrameSink& guard();

  /// Raises again what an algorithm raised, with its traceback; nothing if none did. With the lock held.
  void rethrow();

 private:
  struct Self;
  std::unique_ptr<Self> self_;
};

/// Calls `work` with catalogs that have these algorithms, without the interpreter's lock, and with a sink
/// that ends a run once one of them has raised. Raises that exception, whatever else came of it; or what
/// `work` throws. May be called with or without the lock.
void with_algorithms(const pybind11::object& algorithms,
                     const std::function<void(const Catalogs& catalogs, FrameSink& guard)>& work);

}  // namespace fairway::python
