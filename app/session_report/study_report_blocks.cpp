// SPDX-License-Identifier: GPL-3.0-or-later
// The head of a study's report: the design and the participants.
#include "session_report/study_report_blocks.h"

#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <qcustomplot.h>

namespace chiron::session_report {

namespace words = study_report_words;

QString StudyReportData::conditionName(std::size_t condition) const {
    if (blind())
        return QString::fromStdString(analysis.conditions[condition].condition);
    return words::text(analysis.design.conditions[condition].title, language);
}

psychophysics::Attribute StudyReportData::attribute(std::size_t condition) const {
    return blind() ? psychophysics::Attribute::stiffness
                   : analysis.design.conditions[condition].stimulus.attribute;
}

std::vector<std::size_t> StudyReportData::conditionsInOrder() const {
    std::vector<std::size_t> places(analysis.conditions.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    return places;
}

StudyReportBlocks::StudyReportBlocks(const StudyReportData& data, const report::PlotTheme& theme,
                                     double width)
    : BlockMaker(theme, width), m_data(data) {
    addBanner();
    addTitle();
    addDesign();
    addConditions();
    addComparisons();
    addParticipants();
    for (const std::size_t condition : data.conditionsInOrder())
        addCondition(condition);
    addFidelity();
    addQuestionnaires();
}

void StudyReportBlocks::addMuted(const QString& text) {
    addText(text, m_theme.font(11.5), m_theme.muted, 5);
}

void StudyReportBlocks::addBanner() {
    if (m_data.analysis.record.summary.demonstration)
        addNotice(Words::tr("DEMONSTRATION: invented people and results"));
    const auto simulated = std::count_if(m_data.participants.begin(), m_data.participants.end(),
                                         [](const database::Participant& each) { return each.simulated; });
    if (simulated > 0)
        addNotice(Words::tr("SIMULATED: %n participant(s) are programs, not people", nullptr,
                            static_cast<int>(simulated)));
    if (m_data.blind())
        addNotice(Words::tr("BLINDED: conditions carry sealed codes until the study is unblinded"));
}

void StudyReportBlocks::addTitle() {
    addText(words::text(m_data.analysis.design.title, m_data.language), m_theme.font(24, true), m_theme.ink,
            12);
    const QString objective = words::text(m_data.analysis.design.objective, m_data.language);
    if (!objective.isEmpty())
        addText(objective, m_theme.font(14), m_theme.muted, 4);
}

void StudyReportBlocks::addDesign() {
    const database::StudySummary& study = m_data.analysis.record.summary;
    const psychophysics::StudyDesign& design = m_data.analysis.design;
    const QLocale& locale = m_theme.locale;
    addPairs(
        {{Words::tr("Study"), QString::fromStdString(study.key)},
         {Words::tr("State"), words::state(study.state)},
         {Words::tr("Frozen on"), words::day(study.frozenUtc, locale)},
         {Words::tr("Participants, planned"),
          QStringLiteral("%1, %2").arg(locale.toString(static_cast<int>(m_data.participants.size())),
                                       locale.toString(design.participantsPlanned))},
         {Words::tr("Scored trials"), locale.toString(study.trials)},
         {Words::tr("Order of conditions"), m_data.blind() ? QString() : words::order(design.order)},
         {Words::tr("Seed"), m_data.blind() ? QString() : QString::number(design.seed)},
         {Words::tr("Participants blinded"), design.blindParticipant ? Words::tr("yes") : Words::tr("no")},
         {Words::tr("Experimenters blinded"), !design.blindExperimenter ? Words::tr("no")
                                              : study.unblinded         ? Words::tr("unblinded")
                                                                        : Words::tr("yes")}},
        3);
    addPairs({{Words::tr("Frozen design (SHA-256)"), QString::fromStdString(study.sha256)}}, 1);
}

void StudyReportBlocks::addConditions() {
    if (m_data.blind())
        return;
    addHeading(Words::tr("Conditions"));
    std::vector<std::vector<QString>> rows;
    for (const std::size_t at : m_data.conditionsInOrder()) {
        const psychophysics::Condition& condition = m_data.analysis.design.conditions[at];
        QStringList procedures;
        for (const psychophysics::ProcedureSpec& spec : condition.procedures)
            procedures << words::procedure(psychophysics::kindOf(spec));
        procedures.removeDuplicates();
        const auto& differences = condition.stimulus.differences;
        const auto ratio = [&](double difference) {
            return words::number(100.0 * (std::pow(10.0, difference) - 1.0), m_theme.locale);
        };
        rows.push_back(
            {m_data.conditionName(at), words::attribute(condition.stimulus.attribute),
             words::value(condition.stimulus.reference, condition.stimulus.attribute, m_theme.locale),
             words::task(condition.task), procedures.join(QStringLiteral(", ")),
             differences.empty()
                 ? QString()
                 : QStringLiteral("%1 … %2 %").arg(ratio(differences.front()), ratio(differences.back()))});
    }
    addTable({Words::tr("Condition"), Words::tr("Attribute"), Words::tr("Reference"), Words::tr("Task"),
              Words::tr("Procedure"), Words::tr("Differences")},
             rows, {0.23, 0.13, 0.12, 0.17, 0.18, 0.17}, {false, false, true, false, false, true});
}

void StudyReportBlocks::addParticipants() {
    addHeading(Words::tr("Participants"));
    const QLocale& locale = m_theme.locale;
    std::vector<std::vector<QString>> rows;
    for (const database::Participant& participant : m_data.participants) {
        int done = 0;
        for (const session::AnalysedCondition& condition : m_data.analysis.conditions)
            for (const session::AnalysedRun& run : condition.runs)
                done += run.participant.id == participant.id &&
                                run.run.state == database::StudyRunState::completed
                            ? 1
                            : 0;
        rows.push_back(
            {QString::fromStdString(participant.code), words::participantState(participant.state),
             participant.simulated ? QString::fromStdString(participant.observer) : Words::tr("person"),
             words::day(participant.enrolledUtc, locale), words::day(participant.consentUtc, locale),
             Words::tr("%1 of %2")
                 .arg(locale.toString(done),
                      locale.toString(static_cast<int>(m_data.analysis.conditions.size())))});
    }
    if (rows.empty())
        return addMuted(Words::tr("Nobody takes part yet."));
    addTable({Words::tr("Code"), Words::tr("State"), Words::tr("Person or simulated"), Words::tr("Enrolled"),
              Words::tr("Consent"), Words::tr("Conditions done")},
             rows, {0.15, 0.18, 0.24, 0.14, 0.14, 0.15}, {false, false, false, false, false, true});
}

} // namespace chiron::session_report
