// SPDX-License-Identifier: GPL-3.0-or-later
// The quality of the data, and the participants' questionnaires.
#include "session/study/questionnaire_replies.h"
#include "session_report/study_report_blocks.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <algorithm>
#include <map>
#include <qcustomplot.h>

namespace chiron::session_report {

namespace words = study_report_words;
using psychophysics::QuestionnaireItem;

namespace {

double quantileOf(const std::vector<double>& sorted, double q) {
    const double at = q * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(at);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Totals over the runs of one condition.
struct Tally {
    int scored = 0;
    int spoiled = 0;
    int practice = 0;
    int chosen = 0; ///< choices of procedures, repeated from the log
    int same = 0;
    std::map<std::string, int> why;
};

Tally tallyOf(const session::AnalysedCondition& condition) {
    Tally tally;
    for (const session::AnalysedRun& run : condition.runs) {
        tally.scored += run.scored;
        tally.spoiled += run.spoiled;
        tally.practice += run.practice;
        tally.chosen += run.replayed.trials;
        tally.same += run.replayed.same + run.replayed.ties;
        for (const database::StudyTrial& trial : run.trials)
            if (database::isRepeated(trial))
                ++tally.why[trial.spoiled];
    }
    return tally;
}

/// A condition's title by its label in the answers; while blind, the label is the sealed code.
QString titleOf(const StudyReportData& data, const std::string& label) {
    for (const psychophysics::Condition& each : data.analysis.design.conditions)
        if (!data.blind() && each.id == label)
            return words::text(each.title, data.language);
    return QString::fromStdString(label);
}

} // namespace

void StudyReportBlocks::addFidelity() {
    addHeading(Words::tr("Fidelity"));
    if (m_data.analysis.sealed())
        return addQuality();
    const QLocale& locale = m_theme.locale;
    std::vector<std::vector<QString>> rows;
    for (const std::size_t at : m_data.conditionsInOrder()) {
        const Tally tally = tallyOf(m_data.analysis.conditions[at]);
        QStringList why;
        for (const auto& [token, count] : tally.why)
            why << QStringLiteral("%1: %2").arg(words::spoiled(token), locale.toString(count));
        rows.push_back(
            {m_data.conditionName(at), locale.toString(tally.scored), locale.toString(tally.spoiled),
             locale.toString(tally.practice),
             // A reason such as "stiffness_error" would reveal the condition.
             m_data.blind() ? QStringLiteral("–") : why.join(QStringLiteral(" · ")),
             tally.chosen > 0
                 ? Words::tr("%1 of %2").arg(locale.toString(tally.same), locale.toString(tally.chosen))
                 : QStringLiteral("–")});
    }
    addTable({Words::tr("Condition"), Words::tr("Scored"), Words::tr("Repeated"), Words::tr("Practice"),
              Words::tr("Why repeated"), Words::tr("Choices reproduced")},
             rows, {0.25, 0.1, 0.11, 0.1, 0.27, 0.17}, {false, true, true, true, false, true});
    const psychophysics::FidelityLimits& limits = m_data.analysis.design.fidelity;
    addMuted(Words::tr("A trial is repeated when the force is off by more than %1 N, the felt value by more "
                       "than %2, more than %3 of the "
                       "ticks are late, or the device is at its limit for more than %4 of the contact.")
                 .arg(words::number(limits.forceErrorRms_N, locale),
                      words::percent(limits.stiffnessError, locale), words::percent(limits.lateTicks, locale),
                      words::percent(limits.saturated, locale)));
    addMuted(Words::tr(
        "Choices reproduced: when run again from its log, the procedure chose the same presentations."));
}

/// The quality by participant, over all conditions together.
void StudyReportBlocks::addQuality() {
    const QLocale& locale = m_theme.locale;
    const QString dash = QStringLiteral("–");
    std::vector<std::vector<QString>> rows;
    for (const database::Participant& participant : m_data.participants) {
        for (const database::ParticipantQuality& quality : m_data.analysis.quality) {
            if (quality.participant != participant.id)
                continue;
            int repeated = 0;
            for (const auto& [reason, count] : quality.spoiled)
                repeated += count;
            rows.push_back(
                {QString::fromStdString(participant.code),
                 Words::tr("%1 of %2")
                     .arg(locale.toString(quality.conditionsDone), locale.toString(quality.conditions)),
                 words::percent(quality.lateTicks, locale),
                 !quality.felt   ? dash
                 : *quality.felt ? Words::tr("felt")
                                 : Words::tr("shown"),
                 quality.whole ? locale.toString(quality.scored) : dash,
                 quality.whole ? locale.toString(repeated) : dash});
        }
    }
    if (!rows.empty())
        addTable({Words::tr("Code"), Words::tr("Conditions done"), Words::tr("Late ticks"),
                  Words::tr("Force"), Words::tr("Scored"), Words::tr("Repeated")},
                 rows, {0.2, 0.2, 0.15, 0.15, 0.15, 0.15}, {false, false, true, false, true, true});
    addMuted(Words::tr("Over all conditions together. The number of trials is shown only for those who have "
                       "done every condition."));
}

QString StudyReportBlocks::answersTo(const std::vector<database::QuestionnaireAnswer>& answers,
                                     const QuestionnaireItem& item) const {
    const QLocale& locale = m_theme.locale;
    std::vector<double> numbers;
    int texts = 0;
    for (const database::QuestionnaireAnswer& answer : answers) {
        if (answer.item != item.id)
            continue;
        if (answer.number)
            numbers.push_back(*answer.number);
        else
            texts += answer.text.empty() ? 0 : 1;
    }
    if (numbers.empty())
        return texts == 0 ? Words::tr("No answers")
                          : Words::tr("%n free text(s), in the exported tables", nullptr, texts);
    std::sort(numbers.begin(), numbers.end());
    if (item.kind != QuestionnaireItem::Kind::choice)
        return Words::tr("Median %1, interquartile range %2 to %3, n = %4")
            .arg(words::plainNumber(quantileOf(numbers, 0.5), locale),
                 words::plainNumber(quantileOf(numbers, 0.25), locale),
                 words::plainNumber(quantileOf(numbers, 0.75), locale),
                 locale.toString(static_cast<int>(numbers.size())));
    QStringList counts;
    for (std::size_t i = 0; i < item.choices.size(); ++i)
        counts << QStringLiteral("%1: %2").arg(words::text(item.choices[i], m_data.language),
                                               locale.toString(static_cast<int>(std::count(
                                                   numbers.begin(), numbers.end(), static_cast<double>(i)))));
    return counts.join(QStringLiteral(" · "));
}

void StudyReportBlocks::addQuestionnaires() {
    for (const psychophysics::Questionnaire& questionnaire : m_data.analysis.design.questionnaires) {
        addHeading(words::text(questionnaire.title, m_data.language));
        const auto parts = session::answeredParts(m_data.analysis.design, questionnaire, m_data.answers);
        if (parts.empty())
            addMuted(std::any_of(m_data.answers.begin(), m_data.answers.end(),
                                 [](const database::QuestionnaireAnswer& answer) { return answer.withheld; })
                         ? Words::tr("Answers about single conditions are shown once the study is unblinded.")
                         : Words::tr("No answers"));
        for (const session::AnsweredPart& part : parts) {
            if (!part.label.empty())
                addMuted(Words::tr("About the condition %1").arg(titleOf(m_data, part.label)));
            std::vector<std::vector<QString>> rows;
            for (const QuestionnaireItem& item : questionnaire.items) {
                QString question = words::text(item.text, m_data.language);
                if (item.kind == QuestionnaireItem::Kind::likert)
                    question +=
                        QStringLiteral(" (1 %1 … %2 %3)")
                            .arg(words::text(item.low, m_data.language), m_theme.locale.toString(item.scale),
                                 words::text(item.high, m_data.language));
                rows.push_back({question, answersTo(part.answers, item)});
            }
            addTable({Words::tr("Question"), Words::tr("Answers")}, rows, {0.55, 0.45}, {false, false});
        }
    }
}

} // namespace chiron::session_report
