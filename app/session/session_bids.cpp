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

/// The trials, each from its first frame to its last, and the moments at which tissue gave way.
class SessionSpans final : public BidsSpans {
public:
    explicit SessionSpans(const ToolPositions& positions) : m_positions(positions) {}
    void add(const core::HapticFrame& frame, double t_s) override {
        const QString trial = QString::number(frame.header.trial);
        m_trials.try_emplace(frame.header.trial, BidsSpan{t_s, t_s, "trial", trial}).first->second.end_s =
            t_s;
        for (int tool = 0; tool < m_positions.tools(); ++tool) {
            const core::ToolFrame& sample = frame.tool[static_cast<std::size_t>(tool)];
            const YieldLoad load = m_loads.at(tool, sample);
            if (core::contactOfStatus(sample.status) & core::contact_bits::kYielded)
                m_yields.push_back({t_s, t_s, kTissueYielded, trial,
                                    BidsYield{tool, load, yieldPlaceOf(&m_positions, tool, sample)}});
        }
    }
    BidsMeaning meaning() const override {
        return {{{"trial", "trial of the exercise"}},
                "until the last sample of the trial",
                "number of the trial, from 0"};
    }
    std::vector<BidsSpan> take() override {
        std::vector<BidsSpan> spans = std::move(m_yields);
        for (auto& [number, span] : m_trials)
            spans.push_back(std::move(span));
        std::stable_sort(spans.begin(), spans.end(),
                         [](const BidsSpan& a, const BidsSpan& b) { return a.onset_s < b.onset_s; });
        return spans;
    }

private:
    const ToolPositions& m_positions;
    YieldLoads m_loads;
    std::map<int, BidsSpan> m_trials;
    std::vector<BidsSpan> m_yields;
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
    SessionSpans spans(session.positions());
    const ExportTable participants{"participants",
                                   {},
                                   {{"participant_id", "", "the session's number"}},
                                   {{QStringLiteral("sub-") + subject}}};
    CHIRON_TRY(made->write("dataset_description.json", QJsonDocument(description).toJson()));
    CHIRON_TRY(made->write(
        "README",
        "One recorded session: motion of the tool with forces, its trials as events. Tissue that gave way "
        "under a tool (a perforation, rupture or tear) is an event as well, tissue_yielded: when it "
        "happened, under which tool, under which force and torque, and where. Its columns are described "
        "beside the events file; they are left out if no tissue gave way. Who did it is not part of it.\n"));
    CHIRON_TRY(made->write("participants.tsv", tsvOf(participants)));
    CHIRON_TRY(writeBidsMotion(*made, session, recording, spans));
    return made->commit();
}

} // namespace chiron::session
