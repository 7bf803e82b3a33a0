// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/drainable.h"
#include "database/writer_job.h"

#include <condition_variable>
#include <deque>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>
#include <vector>

namespace chiron::database {

/// Owns the only read-write connection. Every 20 ms it drains the registered live sources. Between drains it
/// runs queued jobs one at a time, each in one transaction: all or nothing. A job should take less than 50
/// ms; longer work (Argon2id, scoring, replay) belongs on a worker that submits a short job.
/// Thread: any, except that only the jobs' own code may call these functions from the writer thread itself;
/// all but submit block.
class WriterThread {
public:
    WriterThread(const WriterThread&) = delete;
    WriterThread& operator=(const WriterThread&) = delete;
    ~WriterThread(); ///< drains, runs the queued jobs, closes the connection

    /// Opens the connection on the new thread. site and clock must outlive the thread.
    /// Errors: storage.
    static core::Result<std::unique_ptr<WriterThread>> start(const std::string& file, const SiteKey& site,
                                                             const IBootClock& clock);

    /// Queues a job (a function WriteContext& -> Result<T>) and returns at once.
    template <class F> auto submit(F job) -> std::future<std::invoke_result_t<F, WriteContext&>> {
        return enqueue(std::move(job), true);
    }
    /// Queues a job and waits for its outcome.
    /// Errors: wrongUse if called from the writer thread itself.
    template <class F> auto run(F job) -> std::invoke_result_t<F, WriteContext&> {
        if (onWriterThread()) {
            return core::fail(core::ErrorCode::wrongUse, "a writer job cannot wait for another one");
        }
        return enqueue(std::move(job), true).get();
    }
    /// The same outside any transaction (VACUUM, checkpoint). It may take long.
    /// Errors: wrongUse while a source is live.
    template <class F> auto runMaintenance(F job) -> std::invoke_result_t<F, WriteContext&> {
        if (onWriterThread() || hasSources()) {
            return core::fail(core::ErrorCode::wrongUse, "storage upkeep waits until no session is running");
        }
        return enqueue(std::move(job), false).get();
    }

    void addSource(IDrainable& source);
    /// Drains once more, removes the source and returns the error of that last drain. Afterwards the source
    /// may be destroyed.
    core::Result<void> removeSource(IDrainable& source);
    /// Drains every source now and waits. Sessions that run faster than real time call it before their ring
    /// is full.
    core::Result<void> flush();
    bool onWriterThread() const noexcept { return std::this_thread::get_id() == m_thread.get_id(); }
    bool hasSources() const;

    static constexpr int kDrainPeriod_ms = 20;

private:
    struct Source {
        IDrainable* drainable;
        std::optional<core::Error> error;
    };
    WriterThread() = default;
    template <class F>
    auto enqueue(F job, bool transaction) -> std::future<std::invoke_result_t<F, WriteContext&>> {
        auto typed = std::make_unique<WriterJob<F>>(std::move(job), transaction);
        auto future = typed->future();
        push(std::move(typed));
        return future;
    }
    void push(std::unique_ptr<IWriterJob> job);
    void main(std::string file, const SiteKey* site, const IBootClock* clock,
              std::promise<core::Result<void>> opened);
    void loop(Connection& connection);
    void drainAll();
    void runJob(Connection& connection, IWriterJob& job);

    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::deque<std::unique_ptr<IWriterJob>> m_jobs;
    std::vector<Source> m_sources; ///< used only by the writer thread; counted under the mutex
    std::size_t m_sourceCount = 0;
    bool m_stop = false;
    std::thread m_thread;
};

} // namespace chiron::database
