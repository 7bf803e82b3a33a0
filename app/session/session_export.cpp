// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_export.h"

#include "catalogue/catalogue.h"
#include "core/contact_bits.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "scoring/trace_grid.h"
#include "session/device_time.h"
#include "session/trace_assembler.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QSaveFile>
#include <algorithm>
#include <array>
#include <map>

namespace chiron::session {

namespace {

core::Error cannotWrite(const QString& path, const QString& why) {
    return {core::ErrorCode::storage, (path + ": cannot be written: " + why).toStdString()};
}

core::Vec3 forceOf(const core::Array6& wrench) {
    return {scoring::onMillinewtons(wrench[0]), scoring::onMillinewtons(wrench[1]),
            scoring::onMillinewtons(wrench[2])};
}

core::Vec3 torqueOf(const core::Array6& wrench) {
    return {scoring::onTorqueGrid(wrench[3]), scoring::onTorqueGrid(wrench[4]),
            scoring::onTorqueGrid(wrench[5])};
}

/// Converts frames to rows: the session's own trials (trace()) give the outcomes, the frames give the
/// samples.
class RowMaker {
public:
    RowMaker(SessionView& session, const std::vector<scoring::TrialTrace>& trials,
             const scoring::TraceColumns& columns)
        : m_session(session), m_columns(columns), m_quantities(session.reader().table()) {
        for (const scoring::TrialTrace& trial : trials)
            m_trials[trial.trial] = &trial;
    }

    /// Call it before the rows of the frame.
    void begin(const core::HapticFrame& frame) { m_time.at(frame); }

    /// Returns false if the packet was refused or read before: each sample is written once, as it is scored
    /// once.
    bool takes(const core::HapticFrame& frame, int tool) {
        const core::ToolFrame& t = frame.tool[static_cast<std::size_t>(tool)];
        const bool isNew =
            !isRefused(t) && m_clocks[static_cast<std::size_t>(tool)].advances(t.deviceTime_us);
        return isNew && m_time.started();
    }

    scoring::TraceRow row(const core::HapticFrame& frame, int tool) {
        const core::ToolFrame& t = frame.tool[static_cast<std::size_t>(tool)];
        scoring::TraceRow row;
        const core::ToolState pose = m_session.positions().pose(tool, t);
        row.t_s = scoring::onMicroseconds(m_time.since(t.deviceTime_us));
        for (int i = 0; i < 3; ++i)
            row.p_WT_m[i] = scoring::onNanometres(pose.p_WT[i]);
        row.q_WT = pose.q_WT;
        row.jaw_rad = pose.jaw_rad;
        row.buttons = t.buttons;
        row.tool = static_cast<std::uint8_t>(tool);
        row.tissue_N = forceOf(t.tissue);
        row.tissueTorque_Nm = torqueOf(t.tissue);
        row.commanded_N = forceOf(t.commanded);
        row.measured_N = forceOf(t.measured);
        row.trial = frame.header.trial;
        row.phase = frame.header.phase;
        row.paused = frame.header.paused != 0;
        row.contact = core::contactOfStatus(t.status);
        row.forceLimit_N = m_session.record().setup.forceLimit_N;
        row.plannedTrials = m_session.record().setup.plannedTrials;
        for (std::size_t i = 0; tool == 0 && i < m_quantities.size(); ++i) // tool 0 represents the tick
            row.quantities.push_back(m_quantities.value(i, frame));
        addOutcome(row);
        return row;
    }

private:
    void addOutcome(scoring::TraceRow& row) const {
        if (m_trials.empty())
            return;
        const auto found = m_trials.find(row.trial);
        const bool known = found != m_trials.end();
        // Samples between trials belong to no trial; their columns hold values that a reader accepts.
        const scoring::TrialTrace& trial = known ? *found->second : *m_trials.begin()->second;
        scoring::setTrial(row, trial, m_columns);
        row.truth = scoring::truthOf(trial, m_columns.truth);
        if (!known)
            return;
        setOwnSample(row, trial);
        row.marked = trial.marked;
        row.timedOut = trial.timedOut;
        row.completed = trial.completed;
        row.failed = trial.failed;
        row.unfinished = trial.unfinished;
        row.markInContact = trial.markInContact;
        row.p_WMark_m = trial.p_WMark_m;
    }

    /// Finds the sample by its time: the exercise's own part has a value for each sample that is scored.
    static void setOwnSample(scoring::TraceRow& row, const scoring::TrialTrace& trial) {
        if (!trial.own || row.tool != 0 || trial.tools.empty())
            return;
        const std::vector<double>& t_s = trial.tools.front().t_s;
        const auto sample = std::lower_bound(t_s.begin(), t_s.end(), row.t_s);
        if (sample != t_s.end() && *sample == row.t_s)
            scoring::setSample(row, trial, static_cast<std::size_t>(sample - t_s.begin()), row.t_s);
    }

    SessionView& m_session;
    const scoring::TraceColumns& m_columns;
    RecordedQuantities m_quantities;
    std::map<int, const scoring::TrialTrace*> m_trials;
    std::array<SampleClock, core::kMaxTools> m_clocks{};
    DeviceTime m_time;
};

/// Those that the trials' targets and the exercise's own part have.
void addColumns(scoring::TraceColumns& columns, const std::vector<scoring::TrialTrace>& trials) {
    if (trials.empty())
        return;
    const scoring::TrialTrace& first = trials.front();
    columns.target = first.target.has_value();
    if (!first.own)
        return;
    columns.own = &first.own->columns();
    if (columns.own->required != nullptr)
        columns.*columns.own->required = true;
    if (columns.own->withTorque)
        columns.torque = !first.tools.empty() && !first.tools[0].tissueTorque_Nm.empty();
}

scoring::TraceColumns columnsOf(SessionView& session, const std::vector<scoring::TrialTrace>& trials) {
    scoring::TraceColumns columns;
    columns.orientation = columns.buttons = columns.tool = columns.tissue = columns.commanded = true;
    columns.trial = columns.phase = columns.paused = columns.mark = columns.forceLimit = columns.contact =
        true;
    for (const auto& device : session.setup().devices) {
        columns.jaw = columns.jaw || device.jawResolution_rad > 0.0;
        columns.measured = columns.measured || device.measuresForce;
    }
    const RecordedQuantities quantities(session.reader().table());
    for (const RecordedQuantities::Quantity& quantity : quantities.list())
        columns.quantities.push_back(quantity.id);
    columns.truth = scoring::truthIdsOf(trials);
    // In exercises with quantities, a trial can end in more than one way.
    columns.failed = quantities.size() > 0;
    columns.completed = columns.failed;
    addColumns(columns, trials);
    columns.unfinished =
        std::any_of(trials.begin(), trials.end(), [](const auto& trial) { return trial.unfinished; });
    columns.planned = true;
    return columns;
}

} // namespace

core::Result<void> exportCsv(SessionView& session, const QString& path) {
    auto trace = session.trace();
    CHIRON_TRY(trace);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return tl::unexpected(cannotWrite(path, file.errorString()));
    const scoring::TraceColumns columns = columnsOf(session, (*trace)->trials);
    std::string text = scoring::traceCsvHeader(columns);
    RowMaker rows(session, (*trace)->trials, columns);
    const int tools = session.positions().tools();
    const auto flush = [&]() -> core::Result<void> {
        if (file.write(text.data(), qint64(text.size())) != qint64(text.size()))
            return tl::unexpected(cannotWrite(path, file.errorString()));
        text.clear();
        return {};
    };
    auto written = session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames) {
            rows.begin(frame);
            for (int tool = 0; tool < tools; ++tool)
                if (rows.takes(frame, tool))
                    scoring::appendTraceCsvRow(text, columns, rows.row(frame, tool));
        }
        return flush();
    });
    if (written)
        written = flush(); // only the header, if nothing was recorded
    CHIRON_TRY(written);
    if (!file.commit())
        return tl::unexpected(cannotWrite(path, file.errorString()));
    return {};
}

core::Result<void> exportJson(SessionView& session, const QJsonObject& summary, const QString& path) {
    QJsonObject document = summary;
    const auto& setup = session.record().setup;
    const auto embed = [](const std::string& text) {
        return QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    };
    document.insert("content", embed(setup.contentJson));
    document.insert("content_sha256", QString::fromStdString(session.record().contentSha256));
    document.insert("task_sha256", QString::fromStdString(catalogue::taskSha256(setup.contentJson)));
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
