// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_export.h"

#include "scoring/trace_csv.h"
#include "scoring/trace_grid.h"
#include "session/exercise_kind.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <map>

namespace chiron::session {

namespace {

core::Error cannotWrite(const QString& path, const QString& why) {
    return {core::ErrorCode::storage, (path + ": cannot be written: " + why).toStdString()};
}

core::Vec3 forceOf(const core::Array6& wrench) {
    return {scoring::onMillinewtons(wrench[0]), scoring::onMillinewtons(wrench[1]), scoring::onMillinewtons(wrench[2])};
}

/// Frames -> rows. Keeps the session's time origin and each trial's truth.
class RowMaker {
public:
    RowMaker(StoredSession& session, const ExerciseKind& kind) : m_session(session), m_kind(kind) {}

    scoring::TraceRow row(const core::HapticFrame& frame, int tool) {
        const core::ToolFrame& t = frame.tool[static_cast<std::size_t>(tool)];
        if (!m_haveOrigin) {
            m_origin_us = frame.tool[0].deviceTime_us;
            m_haveOrigin = true;
        }
        scoring::TraceRow row;
        const core::ToolState pose = m_session.positions().pose(tool, t);
        const auto sinceStart_us = static_cast<std::int64_t>(t.deviceTime_us - m_origin_us);
        row.t_s = scoring::onMicroseconds(static_cast<double>(sinceStart_us) * 1e-6);
        for (int i = 0; i < 3; ++i)
            row.p_WT_m[i] = scoring::onNanometres(pose.p_WT[i]);
        row.q_WT = pose.q_WT;
        row.jaw_rad = pose.jaw_rad;
        row.buttons = t.buttons;
        row.tool = static_cast<std::uint8_t>(tool);
        row.tissue_N = forceOf(t.tissue);
        row.commanded_N = forceOf(t.commanded);
        row.measured_N = forceOf(t.measured);
        row.trial = frame.header.trial;
        row.phase = frame.header.phase;
        row.paused = frame.header.paused != 0;
        addOutcome(frame, tool, row);
        return row;
    }

private:
    void addOutcome(const core::HapticFrame& frame, int tool, scoring::TraceRow& row) {
        const scoring::TrialTrace& truth = truthOf(frame.header.trial);
        if (truth.apex) {
            row.target_m = {truth.apex->x_m, truth.apex->y_m, 0.0};
            row.targetRadius_m = truth.apex->radius_m;
        }
        row.forceLimit_N = m_session.record().setup.forceLimit_N;
        row.marked = (frame.header.events & core::event_bits::kMarked) != 0;
        row.timedOut = (frame.header.events & core::event_bits::kTimedOut) != 0;
        if (tool == 0 && (row.marked || row.timedOut)) {
            row.p_WMark_m = row.p_WT_m;
            row.markInContact = row.tissue_N.norm() > 0.02;
        }
    }

    const scoring::TrialTrace& truthOf(int trial) {
        auto [entry, isNew] = m_truths.try_emplace(trial);
        if (isNew) {
            entry->second.trial = trial;
            m_kind.addTruth(m_session.setup().level, m_session.setup().seed, entry->second);
        }
        return entry->second;
    }

    StoredSession& m_session;
    const ExerciseKind& m_kind;
    bool m_haveOrigin = false;
    std::uint64_t m_origin_us = 0;
    std::map<int, scoring::TrialTrace> m_truths;
};

scoring::TraceColumns columnsOf(const StoredSession& session) {
    scoring::TraceColumns columns;
    columns.orientation = columns.buttons = columns.tool = columns.tissue = columns.commanded = true;
    columns.trial = columns.phase = columns.paused = columns.mark = columns.forceLimit = true;
    for (const auto& device : session.setup().devices) {
        columns.jaw = columns.jaw || device.jawResolution_rad > 0.0;
        columns.measured = columns.measured || device.measuresForce;
    }
    scoring::TrialTrace first;
    if (const auto kind = exerciseKind(session.setup().level.exercise))
        (*kind)->addTruth(session.setup().level, session.setup().seed, first);
    columns.target = first.apex.has_value();
    return columns;
}

} // namespace

core::Result<void> exportCsv(StoredSession& session, const QString& path) {
    auto kind = exerciseKind(session.setup().level.exercise);
    if (!kind)
        return tl::unexpected(kind.error());
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(cannotWrite(path, file.errorString()));
    const scoring::TraceColumns columns = columnsOf(session);
    std::string text = scoring::traceCsvHeader(columns);
    RowMaker rows(session, **kind);
    const int tools = session.positions().tools();
    const auto flush = [&]() -> core::Result<void> {
        if (file.write(text.data(), qint64(text.size())) != qint64(text.size()))
            return tl::unexpected(cannotWrite(path, file.errorString()));
        text.clear();
        return {};
    };
    auto written = session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames)
            for (int tool = 0; tool < tools; ++tool)
                scoring::appendTraceCsvRow(text, columns, rows.row(frame, tool));
        return flush();
    });
    if (written)
        written = flush(); // the header alone, where nothing was recorded
    if (!written)
        return written;
    if (!file.commit())
        return tl::unexpected(cannotWrite(path, file.errorString()));
    return {};
}

core::Result<void> exportJson(StoredSession& session, const QJsonObject& summary, const QString& path) {
    QJsonObject document = summary;
    const auto& setup = session.record().setup;
    const auto embed = [](const std::string& text) {
        return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    };
    document.insert("content", embed(setup.contentJson));
    document.insert("content_sha256", QString::fromStdString(session.record().contentSha256));
    document.insert("device", embed(setup.deviceJson));
    document.insert("mapping", embed(setup.mappingJson));
    document.insert("supervisor", embed(setup.supervisorJson));
    document.insert("versions", embed(setup.versionsJson));
    document.insert("build", QString::fromStdString(setup.buildId));
    document.insert("cpu_class", QString::fromStdString(setup.cpuClass));
    QSaveFile file(path);
    const QByteArray text = QJsonDocument(document).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return tl::unexpected(cannotWrite(path, file.errorString()));
    return {};
}

} // namespace chiron::session
