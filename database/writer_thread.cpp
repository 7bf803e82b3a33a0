// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/writer_thread.h"

#include "database/audit/audit_trail.h"

#include <algorithm>
#include <chrono>

namespace chiron::database {

core::Result<std::unique_ptr<WriterThread>> WriterThread::start(const std::string& file, const SiteKey& site,
                                                                const IBootClock& clock) {
    std::unique_ptr<WriterThread> writer(new WriterThread);
    std::promise<core::Result<void>> opened;
    auto outcome = opened.get_future();
    writer->m_thread = std::thread(&WriterThread::main, writer.get(), file, &site, &clock, std::move(opened));
    auto result = outcome.get();
    CHIRON_TRY(result);
    return writer;
}

WriterThread::~WriterThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_all();
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

void WriterThread::main(std::string file, const SiteKey* site, const IBootClock* clock,
                        std::promise<core::Result<void>> opened) {
    auto connection = Connection::open(file, Connection::Mode::readWrite);
    if (!connection) {
        opened.set_value(tl::unexpected(connection.error()));
        return;
    }
    (*connection)->setSite(site, clock);
    opened.set_value({});
    loop(**connection);
}

void WriterThread::loop(Connection& connection) {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kPeriod{kDrainPeriod_ms};
    auto nextDrain = Clock::now() + kPeriod;
    while (true) {
        std::unique_ptr<IWriterJob> job;
        bool stopping = false;
        {
            std::unique_lock lock(m_mutex);
            const auto ready = [this] { return m_stop || !m_jobs.empty(); };
            if (m_sourceCount == 0) {
                m_wake.wait(lock, ready); // no live source: sleep until there is a job
            } else {
                m_wake.wait_until(lock, nextDrain, ready);
            }
            if (!m_jobs.empty()) {
                job = std::move(m_jobs.front());
                m_jobs.pop_front();
            }
            stopping = m_stop && !job;
        }
        if (stopping || Clock::now() >= nextDrain) {
            drainAll();
            nextDrain = Clock::now() + kPeriod;
        }
        if (job) {
            runJob(connection, *job);
        }
        if (stopping) {
            return;
        }
    }
}

void WriterThread::push(std::unique_ptr<IWriterJob> job) {
    {
        const std::lock_guard lock(m_mutex);
        m_jobs.push_back(std::move(job));
    }
    m_wake.notify_all();
}

void WriterThread::runJob(Connection& connection, IWriterJob& job) {
    WriteContext context(connection);
    if (!job.wantsTransaction()) {
        job.execute(context);
        job.finish(std::nullopt);
        return;
    }
    const auto before = auditHead(connection);
    if (auto begun = connection.begin(); !begun) {
        job.finish(begun.error());
        return;
    }
    if (!job.execute(context)) {
        connection.rollback();
        job.finish(std::nullopt);
        return;
    }
    if (auto committed = connection.commit(); !committed) {
        job.finish(committed.error());
        return;
    }
    // Written after the commit: a crash in between leaves the file one step behind, which verify allows
    // (never ahead).
    const auto after = auditHead(connection);
    if (connection.siteKey() != nullptr && before && after && *before != *after) {
        if (auto written = writeHeadFile(*connection.siteKey(), *after); !written) {
            qWarning("%s", written.error().message.c_str());
        }
    }
    job.finish(std::nullopt);
}

void WriterThread::drainAll() {
    for (Source& source : m_sources) {
        // A source that failed keeps its samples (crash ring) and is called again. A disk that was briefly
        // full therefore loses nothing, and only an error that persists is reported at the end.
        auto drained = source.drainable->drain();
        source.error = drained ? std::nullopt : std::optional<core::Error>(drained.error());
    }
}

void WriterThread::addSource(IDrainable& source) {
    IDrainable* added = &source;
    enqueue(
        [this, added](WriteContext&) -> core::Result<void> {
            m_sources.push_back({added, std::nullopt});
            const std::lock_guard lock(m_mutex);
            m_sourceCount = m_sources.size();
            return {};
        },
        false)
        .get();
}

core::Result<void> WriterThread::removeSource(IDrainable& source) {
    IDrainable* removed = &source;
    return enqueue(
               [this, removed](WriteContext&) -> core::Result<void> {
                   drainAll();
                   const auto found = std::find_if(m_sources.begin(), m_sources.end(),
                                                   [&](const Source& s) { return s.drainable == removed; });
                   if (found == m_sources.end()) {
                       return core::fail(core::ErrorCode::wrongUse, "this source was never added");
                   }
                   const auto error = found->error;
                   m_sources.erase(found);
                   const std::lock_guard lock(m_mutex);
                   m_sourceCount = m_sources.size();
                   return error ? core::Result<void>(tl::unexpected(*error)) : core::Result<void>();
               },
               false)
        .get();
}

core::Result<void> WriterThread::flush() {
    return enqueue(
               [this](WriteContext&) -> core::Result<void> {
                   drainAll();
                   for (const Source& source : m_sources) {
                       if (source.error) {
                           return tl::unexpected(*source.error);
                       }
                   }
                   return {};
               },
               false)
        .get();
}

bool WriterThread::hasSources() const {
    const std::lock_guard lock(m_mutex);
    return m_sourceCount > 0;
}

} // namespace chiron::database
