// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/bids_motion.h"
#include "session/study_export_table.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <map>

namespace chiron::session {

namespace {

/// The trials by their numbers, each from its first frame to its last.
class TrialSpans final : public BidsSpans {
public:
    void add(const core::HapticFrame& frame, double t_s) override {
        const int trial = frame.header.trial;
        m_spans.try_emplace(trial, BidsSpan{t_s, t_s, "trial", QString::number(trial)}).first->second.end_s =
            t_s;
    }
    std::vector<BidsSpan> take() override {
        std::vector<BidsSpan> spans;
        for (auto& [trial, span] : m_spans)
            spans.push_back(std::move(span));
        return spans;
    }

private:
    std::map<int, BidsSpan> m_spans;
};

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
    TrialSpans trials;
    const ExportTable participants{"participants",
                                   {},
                                   {{"participant_id", "", "the session's number"}},
                                   {{QStringLiteral("sub-") + subject}}};
    CHIRON_TRY(made->write("dataset_description.json", QJsonDocument(description).toJson()));
    CHIRON_TRY(made->write("README", "One recorded session: motion of the tool with forces, its "
                                     "trials as events. Who did it is not part of it.\n"));
    CHIRON_TRY(made->write("participants.tsv", tsvOf(participants)));
    CHIRON_TRY(writeBidsMotion(*made, session, recording, trials));
    return made->commit();
}

} // namespace chiron::session
