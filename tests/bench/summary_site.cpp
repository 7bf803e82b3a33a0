// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/summary_site.h"

#include "catalogue/catalogue.h"
#include "database/query.h"
#include "session/exercise_kind.h"
#include "session/session_view.h"
#include "session/training_run.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace chiron::bench {

namespace {
constexpr std::uint64_t kTenMinutes_ticks = 600'000;

/// Ends the session after ten minutes, from within.
struct Stopper final : core::IFrameSink {
    std::atomic<bool> stop{false};
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        stop.store(frame.header.index + 2 >= kTenMinutes_ticks, std::memory_order_relaxed);
        return true;
    }
};

/// Haptics alone, without an end in ten minutes.
core::Result<catalogue::ExerciseLevel> longLevel() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    CHIRON_TRY(catalogue);
    const auto stored = QByteArray::fromStdString(catalogue->find("sphere_apex", 2)->resolvedJson);
    QJsonObject json = QJsonDocument::fromJson(stored).object();
    QJsonObject inner = json["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    if (!parameters.contains("trials"))
        return core::fail(core::ErrorCode::badInput,
                          "the resolved level does not say how many trials it has");
    parameters["trials"] =
        400; // more than content may ask for: ten minutes of them, for the quickest operator too
    inner["parameters"] = parameters;
    json["level"] = inner;
    return catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString());
}

constexpr const char* kCopySession = "INSERT INTO session SELECT ?, person_id, exercise, level, content_id, "
                                     "seed, operator_name, felt, device_json,"
                                     " mapping_json, supervisor_json, versions_json, build_id, cpu_class, "
                                     "force_limit_n, planned_trials, familiarisation,"
                                     " realtime, demonstration, ring_file, channel_table, started_utc, "
                                     "utc_offset_min, state, ended_utc, ticks, frames,"
                                     " dropped, chunks, recording_bytes, loop_json, seal, archived, "
                                     "recording_erased, void_reason, void_reason_hash,"
                                     " voided_by, state_before_void, digest FROM session WHERE id = ?";
constexpr const char* kCopySummaries =
    "INSERT INTO second_summary SELECT ?, second, tool, frames, path_length_m, maximum_force_n, mean_force_n,"
    " impulse_ns, time_over_limit_s, events, digest FROM second_summary WHERE session_id = ? ORDER BY "
    "second, tool";
} // namespace

SummarySite::SummarySite(const std::filesystem::path& file) : m_file(file.string()) {
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    auto created = database::Database::create(m_file, options);
    if (!created) {
        std::fprintf(stderr, "%s\n", created.error().message.c_str());
        std::exit(1);
    }
    m_database = std::move(*created);
}

SummarySite::~SummarySite() = default;

core::Result<bool> SummarySite::record(std::uint64_t seed) {
    auto level = longLevel();
    CHIRON_TRY(level);
    const auto kind = session::exerciseKind(level->exercise);
    const std::vector<std::string> operators = (*kind)->operatorNames();
    auto station = session::scriptedStation(**kind, *level, operators[seed % operators.size()], seed);
    CHIRON_TRY(station);
    Stopper stopper;
    session::TrainingRequest request;
    request.level = std::move(*level);
    request.seed = seed;
    request.station = std::move(*station);
    request.witness = &stopper;
    request.cancel = &stopper.stop;
    auto result = session::runTraining(*m_database, database::Actor::simulated(), std::move(request));
    CHIRON_TRY(result);
    if (result->loop.ticks < kTenMinutes_ticks)
        return core::fail(core::ErrorCode::doesNotHold, "the session ended before its ten minutes were over");
    m_recorded.push_back(result->session);
    m_sampleBytes += result->recording.bytes;
    return true;
}

core::Result<bool> SummarySite::replicate(int sessions) {
    m_database.reset(); // the lock and the writer's connection go: what follows is no product's work
    auto writer = database::Connection::open(m_file, database::Connection::Mode::readWrite);
    CHIRON_TRY(writer);
    (void)(*writer)->begin();
    const auto first = static_cast<std::int64_t>(m_recorded.back()) + 1;
    for (int n = static_cast<int>(m_recorded.size()); n < sessions; ++n) {
        const std::int64_t id = first + n;
        const auto from =
            static_cast<std::int64_t>(m_recorded[static_cast<std::size_t>(n) % m_recorded.size()]);
        for (const char* sql : {kCopySession, kCopySummaries})
            CHIRON_TRY(database::Query::run(**writer, sql, {id, from}));
    }
    CHIRON_TRY((*writer)->commit());
    (void)(*writer)->execute("PRAGMA wal_checkpoint(TRUNCATE)"); // leftovers in the log would only be slower
    auto reader = database::Connection::open(m_file, database::Connection::Mode::readOnly);
    CHIRON_TRY(reader);
    m_reader = std::move(*reader);
    m_summaryRows = (*database::selectInteger(*m_reader, "SELECT count(*) FROM second_summary")).value_or(0);
    return true;
}

core::Result<Totals> SummarySite::ask(int recorded) {
    auto query =
        database::Query::run(*m_reader,
                             "SELECT max(maximum_force_n), total(path_length_m) FROM second_summary "
                             "WHERE session_id = ?",
                             {static_cast<std::int64_t>(m_recorded[static_cast<std::size_t>(recorded)])});
    CHIRON_TRY(query);
    CHIRON_TRY(query->next());
    return Totals{query->real(0), query->real(1)};
}

core::Result<std::vector<Totals>> SummarySite::askAll() {
    auto query = database::Query::run(*m_reader,
                                      "SELECT max(maximum_force_n), total(path_length_m) FROM second_summary "
                                      "GROUP BY session_id");
    CHIRON_TRY(query);
    std::vector<Totals> all;
    auto row = query->next();
    for (; row && *row; row = query->next())
        all.push_back({query->real(0), query->real(1)});
    return row ? core::Result<std::vector<Totals>>(std::move(all)) : tl::unexpected(row.error());
}

core::Result<std::vector<Sample>> SummarySite::samples(int recorded) {
    auto stored = session::SessionView::open(*m_reader, database::Actor::simulated(),
                                             m_recorded[static_cast<std::size_t>(recorded)]);
    CHIRON_TRY(stored);
    std::vector<Sample> all;
    auto done = (*stored)->eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames)
            all.push_back({frame, (*stored)->positions().p_WT_m(0, frame.tool[0])});
        return {};
    });
    return done ? core::Result<std::vector<Sample>>(std::move(all)) : tl::unexpected(done.error());
}

} // namespace chiron::bench
