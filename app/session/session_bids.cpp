// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/bids_motion.h"
#include "session/study_export_table.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <map>

namespace chiron::session {

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
    auto read = session.eachChunk([&](std::span<const core::HapticFrame> frames) -> core::Result<void> {
        for (const core::HapticFrame& frame : frames) {
            auto& event = trials
                              .try_emplace(frame.header.trial, BidsEvent{frame.header.index, 0, "trial",
                                                                         QString::number(frame.header.trial)})
                              .first->second;
            event.lastTick = frame.header.index;
        }
        return {};
    });
    CHIRON_TRY(read);
    std::vector<BidsEvent> events;
    for (const auto& trial : trials)
        events.push_back(trial.second);
    const ExportTable participants{"participants",
                                   {},
                                   {{"participant_id", "", "the session's number"}},
                                   {{QStringLiteral("sub-") + subject}}};
    CHIRON_TRY(made->write("dataset_description.json", QJsonDocument(description).toJson()));
    CHIRON_TRY(made->write("README", "One recorded session: motion of the tool with forces, its "
                                     "trials as events. Who did it is not part of it.\n"));
    CHIRON_TRY(made->write("participants.tsv", tsvOf(participants)));
    CHIRON_TRY(writeBidsMotion(*made, session, recording, events));
    return made->commit();
}

} // namespace chiron::session
