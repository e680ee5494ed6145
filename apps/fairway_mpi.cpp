// SPDX-License-Identifier: Apache-2.0
// A campaign in one MPI job: rank 0 hands runs to the other ranks, one at a time as they become free, and
// writes the store.
//   mpirun -n 65 fairway_mpi campaign.yaml --out all.db
// When a rank dies, MPI ends the job; what was stored is kept, and the same command goes on from there.
#include <mpi.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <iostream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/local_store.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

constexpr int order_tag = 1;
constexpr int result_tag = 2;

std::atomic<bool> stop_requested{false};

/// A run, by its place in the campaign. One beyond all cells ends the worker.
struct Order {
  std::uint64_t cell;
  std::uint64_t seed;
};
constexpr std::uint64_t no_cell = ~std::uint64_t{0};

void send(const Order& order, int rank) {
  MPI_Send(&order, sizeof order, MPI_BYTE, rank, order_tag, MPI_COMM_WORLD);
}

/// Asks again and again, with naps: MPI itself would keep the core busy that another rank may need.
template <class Arrived>
void await(const Arrived& arrived) {
  constexpr std::chrono::microseconds longest_nap{2000};
  for (std::chrono::microseconds nap{50}; !arrived(); nap = std::min(2 * nap, longest_nap))
    std::this_thread::sleep_for(nap);
}

std::vector<std::uint8_t> received(MPI_Status& status) {
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
  MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return bytes;
}

/// The other ranks, as threads of rank 0 see them. MPI is called by one thread at a time.
class Workers {
 public:
  explicit Workers(int ranks) {
    for (int rank = 1; rank < ranks; ++rank) free_.push_back(rank);
  }

  std::size_t count() const { return free_.size(); }

  /// Has a free worker make a run. As many threads may ask at a time as there are workers. Throws with the
  /// worker's words if the run failed.
  std::vector<Measure> make(const Order& order) {
    const int rank = take();
    const nlohmann::json result = nlohmann::json::from_cbor(result_of(order, rank));
    {
      const std::lock_guard guard{mutex_};
      free_.push_back(rank);
    }
    if (result.contains("failure")) throw std::runtime_error(result["failure"].get<std::string>());
    std::vector<Measure> measures;
    for (const auto& [quantity, vehicle, bits] :
         result["measures"].get<std::vector<std::tuple<std::string, int, std::uint64_t>>>())
      measures.push_back({quantity, vehicle, std::bit_cast<double>(bits)});
    return measures;
  }

  void dismiss() {
    for (const int rank : free_) send({no_cell, 0}, rank);
  }

 private:
  int take() {
    const std::lock_guard guard{mutex_};
    const int rank = free_.back();
    free_.pop_back();
    return rank;
  }

  std::vector<std::uint8_t> result_of(const Order& order, int rank) {
    {
      const std::lock_guard guard{mutex_};
      send(order, rank);
    }
    std::vector<std::uint8_t> result;
    await([&] {
      const std::lock_guard guard{mutex_};
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(rank, result_tag, MPI_COMM_WORLD, &is_there, &status);
      if (is_there != 0) result = received(status);
      return is_there != 0;
    });
    return result;
  }

  std::mutex mutex_;
  std::vector<int> free_;
};

/// Makes the runs that rank 0 orders, until it is dismissed. `sample` has all cells of the campaign.
void work(const Campaign& sample, const Catalogs& catalogs) {
  while (true) {
    Order order{};
    await([] {
      int is_there = 0;
      MPI_Iprobe(0, order_tag, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
      return is_there != 0;
    });
    MPI_Recv(&order, sizeof order, MPI_BYTE, 0, order_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (order.cell == no_cell) return;
    nlohmann::json result;
    try {
      std::vector<std::tuple<std::string, int, std::uint64_t>> measures;
      for (const Measure& m : measure_run(scenario_of(sample, order.cell, order.seed), catalogs))
        measures.emplace_back(m.quantity, m.vehicle, std::bit_cast<std::uint64_t>(m.value));
      result["measures"] = measures;
    } catch (const std::exception& error) {
      result["failure"] = error.what();
    }
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(result);
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, result_tag, MPI_COMM_WORLD);
  }
}

struct Flags {
  std::string campaign;
  std::string out;
  bool retry{false};
  bool no_host{false};
};

/// Of rank 0: the whole campaign into the store.
int lead(const Campaign& campaign, const Flags& flags, int ranks) {
  LocalStore local{flags.out};
  const Origin before = local.store().origin();
  if (!before.digest.empty() && before.digest != campaign.digest)
    throw InputError(flags.out + ": is of another campaign or version of it; write to another file");
  local.store().note(this_maker(!flags.no_host));
  local.store().note(origin_of(campaign));
  local.store().claim(campaign.specs);
  Workers workers{ranks};
  Progress progress{campaign.name};
  std::chrono::steady_clock::time_point published;  // long ago, so that the first batch is there at once
  const auto publish_now_and_then = [&] {
    if (std::chrono::steady_clock::now() - published < std::chrono::seconds{10}) return;
    local.publish();
    published = std::chrono::steady_clock::now();
  };
  const ExecutorReport report =
      run_missing(campaign.specs,
                  [&](std::size_t i) {
                    return workers.make({campaign.cells_of[i], campaign.specs[i].seed});
                  },
                  local.store(),
                  {.jobs = static_cast<unsigned>(workers.count()),
                   .progress = &progress,
                   .stop = &stop_requested,
                   .retry_failures = flags.retry,
                   .stored = publish_now_and_then});
  workers.dismiss();
  local.publish();
  std::cout << campaign.name << ": " << report.made << " runs made by " << workers.count() << " workers, "
            << report.failed << " of them failed, " << report.present << " were there"
            << (report.failed_before > 0 ? ", " + std::to_string(report.failed_before) + " of them failed"
                                         : "")
            << (report.stopped ? "; stopped, the same command goes on from here" : "") << "\n";
  return report.failed + report.failed_before == 0 ? 0 : 1;
}

/// Rank 0 leads and the others work, once all have read the same campaign.
int run(const Flags& flags, int rank, int ranks) {
  const Catalogs catalogs = builtin_catalogs();
  const auto check = [&](const Scenario& scenario) { Simulation{scenario, catalogs}; };
  // rank 0 needs every run's key, the others all cells alone
  const Campaign campaign =
      rank == 0 ? load_campaign(flags.campaign, check) : load_cells(flags.campaign, check);
  std::string digest = campaign.digest;
  MPI_Request told = MPI_REQUEST_NULL;
  MPI_Ibcast(digest.data(), static_cast<int>(digest.size()), MPI_CHAR, 0, MPI_COMM_WORLD, &told);
  await([&] {
    int is_there = 0;
    MPI_Test(&told, &is_there, MPI_STATUS_IGNORE);
    return is_there != 0;
  });
  if (digest != campaign.digest) throw InputError(flags.campaign + ": is another campaign on another rank");
  if (rank == 0) return lead(campaign, flags, ranks);
  work(campaign, catalogs);
  return 0;
}

}  // namespace
}  // namespace fairway

int main(int argc, char** argv) {
  CLI::App app{"A campaign in one MPI job: rank 0 hands out runs and stores them."};
  fairway::Flags flags;
  app.add_option("campaign", flags.campaign, "campaign file")->required();
  app.add_option("--out", flags.out, "results store to write; continued if it is there")->required();
  app.add_flag("--retry-failures", flags.retry, "make failed runs again");
  app.add_flag("--no-host", flags.no_host, "keep the machine's name out of the store");
  CLI11_PARSE(app, argc, argv);

  int threads = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &threads);
  int rank = 0;
  int ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const auto stop = [](int) { fairway::stop_requested = true; };
  std::signal(SIGTERM, stop);
  std::signal(SIGINT, stop);
  if (std::signal(SIGHUP, stop) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead, and says so
  int code = 2;
  try {
    if (ranks < 2 || threads < MPI_THREAD_SERIALIZED)
      throw fairway::InputError(
          "fairway_mpi needs two ranks or more, one of which hands out runs: mpirun -n 5 ...");
    code = fairway::run(flags, rank, ranks);
  } catch (const std::exception& error) {
    if (rank == 0) std::cerr << "fairway: " << error.what() << "\n" << std::flush;
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  MPI_Finalize();
  return code;
}
