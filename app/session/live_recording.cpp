// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/live_recording.h"

#include "core/clock.h"
#include "database/repositories/session_repository.h"
#include "session/channels.h"

#include <QUuid>
#include <algorithm>
#include <limits>

namespace chiron::session {

namespace {
// For runs faster than real time, which have no clock.
constexpr std::int64_t kNeverOld = std::numeric_limits<std::int64_t>::min() / 2;
} // namespace

core::Result<recording::DatabaseId> ringIdOf(const database::Database& database) {
    const QUuid uuid = QUuid::fromString(QString::fromStdString(database.uuid()));
    if (uuid.isNull())
        return core::fail(core::ErrorCode::storage,
                          database.file() + ": uuid \"" + database.uuid() + "\": expected a UUID");
    const QByteArray bytes = uuid.toRfc4122();
    recording::DatabaseId id{};
    std::copy_n(reinterpret_cast<const std::uint8_t*>(bytes.constData()), id.size(), id.begin());
    return id;
}

core::Result<std::unique_ptr<LiveRecording>>
LiveRecording::start(database::Database& database, const database::Actor& actor, database::SessionId session,
                     const SessionSetup& setup, const std::filesystem::path& ringFolder, bool realtime) {
    auto positions = ToolPositions::create(setup);
    CHIRON_TRY(positions);
    auto table = channelTableFor(setup);
    CHIRON_TRY(table);
    auto id = ringIdOf(database);
    CHIRON_TRY(id);
    std::unique_ptr<LiveRecording> live(new LiveRecording(database, std::move(*positions)));
    auto ring = recording::CrashRing::create({.folder = ringFolder,
                                              .database = *id,
                                              .session = session,
                                              .tools = static_cast<int>(setup.devices.size())});
    CHIRON_TRY(ring);
    live->m_realtime = realtime;
    live->m_ring = std::move(*ring);
    auto sink = database.write([&](database::WriteContext& context) {
        return database::SessionRepository(context.connection(), actor).openSink(session);
    });
    if (!sink) {
        (void)live->m_ring->remove(); // nothing was recorded yet, so leave nothing to recover
        return tl::unexpected(sink.error());
    }
    live->m_sink = std::move(*sink);
    live->m_recorder = std::make_unique<recording::Recorder>(
        std::move(*table), *live->m_positions, *live->m_sink,
        recording::RecorderSettings{.forceLimit_N = setup.safety.exerciseForce_N});
    live->m_drain = std::make_unique<recording::FrameDrain>(*live->m_ring, *live->m_recorder);
    live->m_draining = true;
    database.writer().addSource(*live);
    return live;
}

LiveRecording::~LiveRecording() {
    stopDraining();
}

void LiveRecording::stopDraining() {
    if (!m_draining)
        return;
    m_draining = false;
    m_drainOutcome = m_database.writer().removeSource(*this);
}

core::Result<void> LiveRecording::drain() {
    return m_finishing ? m_drain->finish() : m_drain->drain(m_realtime ? core::monotonicNow_ns() : kNeverOld);
}

core::Result<RecordingReport> LiveRecording::finish() {
    stopDraining();
    // A drain that failed once (for instance because the disk was full) kept its frames; this is the second
    // and last try. It runs as a source, not as a job: a job's transaction commits after the job, and the
    // ring must not learn before the commit that its frames are stored.
    m_finishing = true;
    m_database.writer().addSource(*this);
    auto stored = m_database.writer().removeSource(*this);
    CHIRON_TRY(stored);
    const RecordingReport report{m_recorder->framesCommitted(), m_drain->lost(), m_recorder->bytesWritten()};
    CHIRON_TRY(m_ring->remove());
    return report;
}

} // namespace chiron::session
