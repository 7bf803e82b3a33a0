// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/bids_motion.h"

#include "session/study_export_table.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <set>

namespace chiron::session {

namespace {

constexpr double kTick_s = 1e-3; ///< nominal duration of a tick

struct Channel {
    const char* name;
    const char* component;
    const char* type;
    const char* unit;
    const char* description;
};

/// The channels as defined by BIDS 1.9 (motion, BEP029): LATENCY since the first sample, POS, ORNT; all
/// others are MISC.
constexpr std::array<Channel, 18> kChannels{
    {{"latency", "n/a", "LATENCY", "s", "since the first sample"},
     {"tip_x", "x", "POS", "m", "tool tip"},
     {"tip_y", "y", "POS", "m", "tool tip"},
     {"tip_z", "z", "POS", "m", "tool tip"},
     {"tip_quat_w", "quat_w", "ORNT", "n/a", "orientation of the tool"},
     {"tip_quat_x", "quat_x", "ORNT", "n/a", "orientation of the tool"},
     {"tip_quat_y", "quat_y", "ORNT", "n/a", "orientation of the tool"},
     {"tip_quat_z", "quat_z", "ORNT", "n/a", "orientation of the tool"},
     {"tissue_force_x", "x", "MISC", "N", "force that the scene answered"},
     {"tissue_force_y", "y", "MISC", "N", "force that the scene answered"},
     {"tissue_force_z", "z", "MISC", "N", "force that the scene answered"},
     {"commanded_force_x", "x", "MISC", "N", "force asked of the device"},
     {"commanded_force_y", "y", "MISC", "N", "force asked of the device"},
     {"commanded_force_z", "z", "MISC", "N", "force asked of the device"},
     {"measured_force_x", "x", "MISC", "N", "force measured by the device"},
     {"measured_force_y", "y", "MISC", "N", "force measured by the device"},
     {"measured_force_z", "z", "MISC", "N", "force measured by the device"},
     {"buttons", "n/a", "MISC", "n/a", "buttons held, bit 0 the mark"}}};

int count(const char* type) {
    int number = 0;
    for (const Channel& channel : kChannels)
        number += QLatin1String(channel.type) == QLatin1String(type) ? 1 : 0;
    return number;
}

QByteArray channelsTsv() {
    ExportTable table{"channels",
                      {},
                      {{"name", "", ""},
                       {"component", "", ""},
                       {"type", "", ""},
                       {"tracked_point", "", ""},
                       {"units", "", ""},
                       {"reference_frame", "", ""},
                       {"description", "", ""}},
                      {}};
    for (const Channel& c : kChannels) {
        const bool placed = QLatin1String(c.component) != QLatin1String("n/a");
        table.rows.push_back(
            {c.name, c.component, c.type, "tooltip", c.unit, placed ? "workspace" : "n/a", c.description});
    }
    return tsvOf(table);
}

QByteArray channelsJson() {
    const QJsonObject frame{{"SpatialAxes", "RAS"},
                            {"RotationRule", "right-hand"},
                            {"Description", "of the exercise (W): x to the participant's right, y away, z "
                                            "up; origin in the middle of the workspace"}};
    return QJsonDocument(
               QJsonObject{
                   {"reference_frame",
                    QJsonObject{{"Description", "frame that positions, orientations and forces are given in"},
                                {"Levels", QJsonObject{{"workspace", frame}}}}}})
        .toJson();
}

struct Written {
    std::uint64_t samples = 0;
    double duration_s = 0.0;
    std::int64_t first_ns = 0;
};

/// The spans of events whose ticks are known.
class SpansOfTicks final : public BidsSpans {
public:
    explicit SpansOfTicks(const std::vector<BidsEvent>& events) : m_events(events) {
        for (const BidsEvent& event : events)
            m_spans.push_back({kNotYet, kNotYet, event.type, event.value});
    }
    void add(const core::HapticFrame& frame, double t_s) override {
        for (std::size_t i = 0; i < m_events.size(); ++i) {
            if (frame.header.index >= m_events[i].firstTick && m_spans[i].onset_s < 0.0)
                m_spans[i].onset_s = t_s;
            if (frame.header.index <= m_events[i].lastTick)
                m_spans[i].end_s = t_s;
        }
    }
    BidsMeaning meaning() const override {
        return {{{"trial", "scored presentation"},
                 {"practice", "practice, never scored"},
                 {"spoiled", "presentation that does not count"}},
                "until the answer",
                "presentation within the run, as in the beh file"};
    }
    std::vector<BidsSpan> take() override {
        std::erase_if(m_spans, [](const BidsSpan& span) { return span.onset_s < 0.0; });
        return std::move(m_spans);
    }

private:
    static constexpr double kNotYet = -1.0;
    const std::vector<BidsEvent>& m_events;
    std::vector<BidsSpan> m_spans;
};

void addCell(QByteArray& row, double value) {
    row += '\t';
    row += QByteArray::number(value, 'g', 9);
}

QByteArray rowOf(const core::HapticFrame& frame, const core::ToolState& pose, double t_s) {
    const core::ToolFrame& tool = frame.tool[0];
    QByteArray row = QByteArray::number(t_s, 'f', 6);
    for (int i = 0; i < 3; ++i)
        addCell(row, pose.p_WT[i]);
    for (const double part : {pose.q_WT.w(), pose.q_WT.x(), pose.q_WT.y(), pose.q_WT.z()})
        addCell(row, part);
    const bool measured = (tool.status & core::sample_status::kMeasuredForce) != 0;
    for (const auto* wrench : {&tool.tissue, &tool.commanded})
        for (std::size_t i = 0; i < 3; ++i)
            addCell(row, (*wrench)[i]);
    for (std::size_t i = 0; i < 3; ++i) {
        if (measured)
            addCell(row, tool.measured[i]);
        else
            row += "\tn/a";
    }
    row += '\t' + QByteArray::number(tool.buttons) + '\n';
    return row;
}

core::Result<Written> writeSamples(QFile& file, SessionView& session, BidsSpans& spans) {
    Written written;
    auto done = session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        QByteArray text;
        for (const core::HapticFrame& frame : frames) {
            if (written.samples++ == 0)
                written.first_ns = frame.header.now_ns;
            const double t_s = 1e-9 * static_cast<double>(frame.header.now_ns - written.first_ns);
            written.duration_s = t_s;
            text += rowOf(frame, session.positions().pose(0, frame.tool[0]), t_s);
            spans.add(frame, t_s);
        }
        if (file.write(text) != text.size())
            return core::fail(core::ErrorCode::storage,
                              (file.fileName() + ": cannot be written: " + file.errorString()).toStdString());
        return {};
    });
    CHIRON_TRY(done);
    if (!file.flush())
        return core::fail(core::ErrorCode::storage,
                          (file.fileName() + ": cannot be written: " + file.errorString()).toStdString());
    return written;
}

QByteArray sidecar(const SessionView& session, const BidsRecording& recording, const Written& written) {
    const double frequency = written.duration_s > 0.0
                                 ? static_cast<double>(written.samples - 1) / written.duration_s
                                 : 1.0 / kTick_s;
    QJsonObject json{
        {"TaskName", recording.task},
        {"TaskDescription", recording.taskDescription},
        {"SamplingFrequency", 1.0 / kTick_s},
        {"SamplingFrequencyEffective", frequency},
        {"TrackingSystemName", "haptic"},
        {"ManufacturersModelName", session.setup().devices.front().model.empty()
                                       ? kNotAvailable
                                       : QString::fromStdString(session.setup().devices.front().model)},
        {"SoftwareVersions", QString::fromStdString(session.record().setup.buildId)},
        {"MissingValues", "n/a"},
        {"TrackedPointsCount", 1},
        {"MotionChannelCount", static_cast<int>(kChannels.size())},
        {"POSChannelCount", count("POS")},
        {"ORNTChannelCount", count("ORNT")},
        {"MISCChannelCount", count("MISC")},
        {"LATENCYChannelCount", count("LATENCY")},
        {"RecordingDuration", written.duration_s}};
    // The schema of this file does not allow additional keys.
    if (!recording.protocolSha256.isEmpty())
        json.insert("TaskDescription", QStringLiteral("%1 (protocol SHA-256 %2)")
                                           .arg(recording.taskDescription, recording.protocolSha256));
    return QJsonDocument(json).toJson();
}

/// The columns of what gave way are there only where something did.
bool haveYields(const std::vector<BidsSpan>& spans) {
    return std::any_of(spans.begin(), spans.end(),
                       [](const BidsSpan& span) { return span.yield.has_value(); });
}

struct YieldColumn {
    const char* name;
    const char* unit;
    const char* description;
    QString (*cell)(const BidsYield&);
};

template <int axis> QString placeOf(const BidsYield& yield) {
    return yield.p_W ? exportNumber((*yield.p_W)[axis]) : kNotAvailable;
}

constexpr const char* kPlace = "tip of the tool at that moment, in the frame of the motion file";
constexpr std::array kYieldColumns{
    YieldColumn{"tool", "", "tool concerned, from 0, which is that of the motion file",
                [](const BidsYield& yield) { return QString::number(yield.tool); }},
    YieldColumn{"force", "N", "force at which it gave way or came off",
                [](const BidsYield& yield) { return exportNumber(yield.load.force_N); }},
    YieldColumn{"torque", "N m", "torque at which it gave way",
                [](const BidsYield& yield) { return exportNumber(yield.load.torque_Nm); }},
    YieldColumn{"position_x", "m", kPlace, placeOf<0>},
    YieldColumn{"position_y", "m", kPlace, placeOf<1>},
    YieldColumn{"position_z", "m", kPlace, placeOf<2>}};

QByteArray eventsTsv(const std::vector<BidsSpan>& spans) {
    ExportTable table{
        "events",
        {},
        {{"onset", "s", ""}, {"duration", "s", ""}, {"trial_type", "", ""}, {"ordinal", "1", ""}},
        {}};
    const bool yields = haveYields(spans);
    for (const YieldColumn& column : kYieldColumns)
        if (yields)
            table.columns.push_back({column.name, column.unit, ""});
    for (const BidsSpan& span : spans) {
        QStringList row{exportNumber(span.onset_s), exportNumber(std::max(0.0, span.end_s - span.onset_s)),
                        span.type, span.value};
        for (const YieldColumn& column : kYieldColumns)
            if (yields)
                row << (span.yield ? column.cell(*span.yield) : kNotAvailable);
        table.rows.push_back(row);
    }
    return tsvOf(table);
}

QByteArray eventsJson(const std::vector<BidsSpan>& spans, const BidsMeaning& meaning) {
    QJsonObject levels;
    for (const auto& [type, description] : meaning.types)
        levels.insert(type, description);
    const bool yields = haveYields(spans);
    if (yields)
        levels.insert(QLatin1String(kTissueYielded),
                      "tissue gave way to a tool (a perforation, rupture or tear), or an object of a study "
                      "came off it; it has no duration, and its ordinal is that of the trial");
    QJsonObject json{
        {"onset",
         QJsonObject{{"Description", "begin, since the first sample of the motion file"}, {"Units", "s"}}},
        {"duration", QJsonObject{{"Description", meaning.duration}, {"Units", "s"}}},
        {"trial_type", QJsonObject{{"Description", "what was presented"}, {"Levels", levels}}},
        {"ordinal", QJsonObject{{"Description", meaning.ordinal}}}};
    for (const YieldColumn& column : kYieldColumns) {
        if (!yields)
            continue;
        QJsonObject words{{"Description", QLatin1String(column.description) + "; n/a for other events"}};
        if (*column.unit != '\0')
            words.insert("Units", column.unit);
        json.insert(QLatin1String(column.name), words);
    }
    return QJsonDocument(json).toJson();
}

} // namespace

QString BidsRecording::stem() const {
    return QStringLiteral("sub-%1_task-%2").arg(subject, task);
}

QString BidsRecording::tail() const {
    return (acquisition.isEmpty() ? QString() : QStringLiteral("_acq-") + acquisition) +
           QStringLiteral("_run-%1").arg(run);
}

QString bidsLabel(const QString& words) {
    QString label;
    bool upper = false;
    for (const QChar c : words) {
        const bool kept = (c >= u'a' && c <= u'z') || (c >= u'A' && c <= u'Z') || (c >= u'0' && c <= u'9');
        if (kept)
            label += upper ? c.toUpper() : c;
        upper = !kept && !label.isEmpty();
    }
    return label.isEmpty() ? QStringLiteral("x") : label;
}

std::map<QString, QString> bidsLabels(QStringList words) {
    std::sort(words.begin(), words.end());
    std::stable_partition(words.begin(), words.end(),
                          [](const QString& word) { return bidsLabel(word) == word; });
    std::map<QString, QString> labels;
    std::set<QString> taken;
    for (const QString& word : words) {
        if (labels.count(word) > 0)
            continue;
        const QString wished = bidsLabel(word);
        QString label = wished;
        for (int number = 2; !taken.insert(label.toLower()).second; ++number)
            label = wished + QStringLiteral("x%1").arg(number);
        labels[word] = label;
    }
    return labels;
}

core::Result<void> writeBidsMotion(NewFolder& folder, SessionView& session, const BidsRecording& recording,
                                   const std::vector<BidsEvent>& events) {
    SpansOfTicks spans(events);
    return writeBidsMotion(folder, session, recording, spans);
}

core::Result<void> writeBidsMotion(NewFolder& folder, SessionView& session, const BidsRecording& recording,
                                   BidsSpans& spans) {
    const QString base = QStringLiteral("sub-%1/motion/%2").arg(recording.subject, recording.stem());
    const QString tracked = base + QStringLiteral("_tracksys-haptic") + recording.tail();
    const auto path = folder.place(tracked + "_motion.tsv");
    CHIRON_TRY(path);
    QFile file(*path);
    if (!file.open(QIODevice::WriteOnly))
        return core::fail(core::ErrorCode::storage,
                          (*path + ": cannot be written: " + file.errorString()).toStdString());
    const auto written = writeSamples(file, session, spans);
    CHIRON_TRY(written);
    const std::vector<BidsSpan> found = spans.take();
    for (const auto& [name, bytes] :
         {std::pair{tracked + "_motion.json", sidecar(session, recording, *written)},
          {tracked + "_channels.tsv", channelsTsv()},
          {tracked + "_channels.json", channelsJson()},
          {tracked + "_events.tsv", eventsTsv(found)},
          {tracked + "_events.json", eventsJson(found, spans.meaning())}})
        CHIRON_TRY(folder.write(name, bytes));
    return {};
}

} // namespace chiron::session
