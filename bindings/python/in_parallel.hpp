// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace fairway::python {

/// Calls work(i) for i = 0 ... count - 1, in order, on `jobs` threads (0: as many as there are cores, and
/// never more), without the interpreter's lock. The calling thread, which must hold it on entry and holds it
/// again on return, meanwhile looks for Ctrl-C and calls tell(done), with the lock, now and then and at the
/// end. Where either raises, or work() throws, `stop` becomes true, no further work is begun, what runs is
/// waited for, and the exception goes on.
void in_parallel(std::size_t count, unsigned jobs, std::atomic<bool>& stop,
                 const std::function<void(std::size_t)>& work,
                 const std::function<void(std::size_t done)>& tell = {});

}  // namespace fairway::python
