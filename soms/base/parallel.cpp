#include "soms/base/parallel.h"

#include "soms/base/arithmetic.h"
#include "soms/base/error.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#if SOMS_USE_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#else
#include <exception>
#include <system_error>
#endif

namespace soms {

namespace {

int thread_count(const Limits& limits) {
  if (limits.threads > 0) {
    return limits.threads;
  }
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Counts finished chunks and passes the share on, one caller at a time.
class Progress {
 public:
  Progress(const Limits& limits, std::size_t total) : limits_(limits), total_(total) {}

  void finished_one() {
    if (!limits_.progress) {
      return;
    }
    const std::scoped_lock lock(mutex_);
    ++done_;
    limits_.progress(static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  const Limits& limits_;
  std::size_t total_;
  std::mutex mutex_;
  std::size_t done_ = 0;
};

#if SOMS_USE_TBB

/// The arena of this thread for so many threads. It is kept: one that is made and given back for
/// each call stays in TBB's lists until a worker has looked at it, and where workers get no time
/// (another program keeps the processors busy) thousands pile up.
tbb::task_arena& arena_of(int threads) {
  thread_local std::unique_ptr<tbb::task_arena> arena;
  if (!arena || arena->max_concurrency() != threads) {
    arena = std::make_unique<tbb::task_arena>(threads);
  }
  return *arena;  // NOLINT(clang-analyzer-cplusplus.NewDelete): the analyzer loses the new one
}

void run_threads(int threads, std::size_t chunks, const std::function<void(std::size_t)>& body) {
  const auto run = [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, chunks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t i = range.begin(); i != range.end(); ++i) {
            body(i);
          }
        },
        tbb::simple_partitioner());
  };
  // Asking for more than TBB allows would make it print a warning.
  const auto allowed = static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  // A call within a call has an arena of its own: while it waits, it takes no chunk of the other.
  thread_local int depth = 0;
  if (depth > 0) {
    tbb::task_arena(std::min(threads, allowed)).execute(run);
    return;
  }

  struct Entry {
    Entry() { ++depth; }

    ~Entry() { --depth; }
  } const entry;

  arena_of(std::min(threads, allowed)).execute(run);
}

#else

/// Threads that are waited for.
class Helpers {
 public:
  Helpers() = default;

  ~Helpers() {
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }

  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;

  /// Starts so many, or as many as the system gives: their work is shared, so that fewer do it.
  void start(std::size_t count, const std::function<void()>& work) {
    threads_.reserve(count);
    try {
      while (threads_.size() < count) {
        threads_.emplace_back(work);
      }
    } catch (const std::system_error&) {
      return;
    }
  }

 private:
  std::vector<std::thread> threads_;
};

void run_threads(int threads, std::size_t chunks, const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < chunks; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!failure) {
          failure = std::current_exception();
        }
        next = chunks;
      }
    }
  };
  {
    Helpers helpers;
    helpers.start(std::min<std::size_t>(static_cast<std::size_t>(threads), chunks) - 1, work);
    work();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

#endif

}  // namespace

void check_stop(const Limits& limits) {
  if (limits.stop.stop_requested()) {
    throw Error(ErrorKind::cancelled, "stopped on request", "");
  }
}

void check(const Limits& limits) {
  check_stop(limits);
  if (limits.late()) {
    throw Error(ErrorKind::timed_out, "the deadline passed", "allow more time");
  }
}

void for_each_chunk(std::size_t count, std::size_t chunk, const Limits& limits,
                    const std::function<void(std::size_t begin, std::size_t end)>& body) {
  if (count == 0) {
    return;
  }
  chunk = std::max<std::size_t>(chunk, 1);
  const std::size_t chunks = (count - 1) / chunk + 1;
  Progress progress(limits, chunks);
  const auto run = [&](std::size_t i) {
    const PlainArithmetic plain;  // a thread of the pool may have been made with other settings
    check(limits);
    const std::size_t begin = i * chunk;
    body(begin, std::min(count, begin + chunk));
    progress.finished_one();
  };
  const int threads = thread_count(limits);
  if (threads == 1 || chunks == 1) {
    for (std::size_t i = 0; i < chunks; ++i) {
      run(i);
    }
    return;
  }
  run_threads(threads, chunks, run);
}

}  // namespace soms
