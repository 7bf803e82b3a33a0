// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact_bits.h"
#include "session/bids_motion.h"
#include "session/study_export_table.h"
#include "session/yield_cause.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <map>

namespace chiron::session {

namespace {

/// The tools under which tissue gave way in this frame.
void addYields(const core::HapticFrame& frame, const ToolPositions& positions,
               std::vector<BidsEvent>& events) {
    for (int tool = 0; tool < positions.tools(); ++tool) {
        const core::ToolFrame& sample = frame.tool[static_cast<std::size_t>(tool)];
        if (core::contactOfStatus(sample.status) & core::contact_bits::kYielded)
            events.push_back({frame.header.index, frame.header.index, kTissueYielded,
                              QString::number(frame.header.trial), yieldPlaceOf(&positions, tool, sample)});
    }
}

} // namespace

core::Result<void> exportSessionBids(SessionView& session, const std::filesystem::path& folder) {
    auto made = NewFolder::begin(folder);
    CHIRON_TRY(made);
    const auto& record = session.record();
    const QString subject = QStringLiteral("session%1").arg(record.summary.id);
    const QString exercise = QString::fromStdString(session.setup().level.exercise);
    const QJsonObject description{{"Name", exercise},
                                  {"BIDSVersion", "1.9.0"},
                                  {"DatasetType", "raw"},
                                  {"Authors", QJsonArray{"n/a"}},
                                  {"GeneratedBy", QJsonArray{QJsonObject{{"Name", "Chiron"}}}}};
    const BidsRecording recording{subject, bidsLabel(exercise), {}, 1, exercise, {}};
    std::map<int, BidsEvent> trials;
    std::vector<BidsEvent> events;
    auto read = session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames) {
            auto& event = trials
                              .try_emplace(frame.header.trial, BidsEvent{frame.header.index, 0, "trial",
                                                                         QString::number(frame.header.trial)})
                              .first->second;
            event.lastTick = frame.header.index;
            addYields(frame, session.positions(), events);
        }
        return {};
    });
    if (!read)
        return read;
    for (const auto& trial : trials)
        events.push_back(trial.second);
    std::stable_sort(events.begin(), events.end(),
                     [](const BidsEvent& a, const BidsEvent& b) { return a.firstTick < b.firstTick; });
    const ExportTable participants{"participants",
                                   {},
                                   {{"participant_id", "", "the session's number"}},
                                   {{QStringLiteral("sub-") + subject}}};
    if (auto written = made->write("dataset_description.json", QJsonDocument(description).toJson()); !written)
        return written;
    if (auto written = made->write("README", "One recorded session: motion of the tool with forces, its "
                                             "trials as events. Who did it is not part of it.\n");
        !written)
        return written;
    if (auto written = made->write("participants.tsv", tsvOf(participants)); !written)
        return written;
    if (auto written = writeBidsMotion(*made, session, recording, events); !written)
        return written;
    return made->commit();
}

} // namespace chiron::session
