// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/participant_progress.h"

#include "desktop/studies/study_words.h"
#include "session/study/study_store.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

/// The translation context of the texts.
struct ParticipantProgress {
    Q_DECLARE_TR_FUNCTIONS(ParticipantProgress)
};

using ProgressState = ConditionProgress::State;

const LeftRun* leftOf(const ParticipantRow& row, database::StudyRunNumber run) {
    const auto found = std::find_if(row.left.begin(), row.left.end(),
                                    [run](const LeftRun& each) { return each.run == run; });
    return found == row.left.end() ? nullptr : &*found;
}

/// A questionnaire that follows each condition must be answered after every completed one.
bool isAnswered(const OpenStudy& study, const ParticipantRow& row,
                const psychophysics::Questionnaire& questions) {
    if (questions.when != psychophysics::Questionnaire::When::afterCondition)
        return study.answered.contains({row.participant.id, questions.id});
    return std::all_of(row.runs.begin(), row.runs.end(), [&](const database::StudyRun& run) {
        return run.state != database::StudyRunState::completed ||
               study.answeredAfter.contains({run.id, questions.id});
    });
}

/// The first questionnaire that is not answered yet; null if there is none.
const psychophysics::Questionnaire* unanswered(const OpenStudy& study, const ParticipantRow& row) {
    const auto& all = study.design.questionnaires;
    const auto found = std::find_if(all.begin(), all.end(), [&](const psychophysics::Questionnaire& each) {
        return !isAnswered(study, row, each);
    });
    return found == all.end() ? nullptr : &*found;
}

/// Whether this participant may begin a condition, now or after the consent.
bool mayBegin(const OpenStudy& study, const ParticipantRow& row) {
    using database::ParticipantState;
    return study.summary.state == database::StudyState::frozen &&
           (row.participant.state == ParticipantState::enrolled ||
            row.participant.state == ParticipantState::consented);
}

} // namespace

std::vector<ConditionProgress> conditionProgress(const OpenStudy& study, const ParticipantRow& row) {
    std::vector<ConditionProgress> all;
    for (const std::string& label :
         session::labelsInOrder(study.design, study.sealed, row.participant.order)) {
        ConditionProgress progress;
        progress.label = label;
        // The runs are in order of starting, so the last one determines the state.
        for (const database::StudyRun& run : row.runs) {
            if (session::labelOf(run) != label)
                continue;
            progress.state = run.state == database::StudyRunState::completed ? ProgressState::done
                             : run.state == database::StudyRunState::open    ? ProgressState::interrupted
                                                                             : ProgressState::ended;
            progress.left = run.state == database::StudyRunState::open ? leftOf(row, run.id) : nullptr;
        }
        progress.closed =
            progress.state == ProgressState::notBegun && study.summary.state != database::StudyState::frozen;
        progress.withdrawn = progress.state == ProgressState::notBegun &&
                             row.participant.state == database::ParticipantState::withdrawn;
        all.push_back(std::move(progress));
    }
    return all;
}

QString interruptedWords(const OpenStudy& study, const LeftRun& left, const QLocale& locale) {
    const QString when = study_words::moment(left.lastUtc, locale);
    if (study.blinding.seals()) // the trial number would reveal how many there were
        return ParticipantProgress::tr("interrupted, %1").arg(when);
    const QString next = locale.toString(left.scored + 1);
    const QString where = left.atMost > 0
                              ? ParticipantProgress::tr("interrupted at trial %1 of at most %2")
                                    .arg(next, locale.toString(std::max(left.atMost, left.scored + 1)))
                              : ParticipantProgress::tr("interrupted at trial %1").arg(next);
    return ParticipantProgress::tr("%1, %2").arg(where, when);
}

QString progressWords(const OpenStudy& study, const ConditionProgress& progress, const QLocale& locale) {
    switch (progress.state) {
    case ProgressState::done:
        return ParticipantProgress::tr("done");
    case ProgressState::interrupted:
        return progress.left ? interruptedWords(study, *progress.left, locale)
                             : ParticipantProgress::tr("interrupted");
    case ProgressState::ended:
        return ParticipantProgress::tr("broken off when the participant withdrew");
    case ProgressState::notBegun:
        return progress.withdrawn ? ParticipantProgress::tr("not begun before the participant withdrew")
               : progress.closed  ? ParticipantProgress::tr("not begun, and the study is closed")
                                  : ParticipantProgress::tr("not begun yet");
    }
    return {};
}

QString participantProgress(const OpenStudy& study, const ParticipantRow& row, const QLocale& locale) {
    if (row.runs.empty() && mayBegin(study, row))
        return ParticipantProgress::tr("not begun yet");
    const auto in = [&row](database::StudyRunState state) {
        return std::count_if(row.runs.begin(), row.runs.end(),
                             [state](const database::StudyRun& run) { return run.state == state; });
    };
    const QString text = ParticipantProgress::tr("%1 of %2 done")
                             .arg(locale.toString(static_cast<int>(in(database::StudyRunState::completed))),
                                  locale.toString(static_cast<int>(study.design.conditions.size())));
    if (in(database::StudyRunState::open) > 0)
        return ParticipantProgress::tr("%1, one interrupted").arg(text);
    return in(database::StudyRunState::stopped) > 0 ? ParticipantProgress::tr("%1, one broken off").arg(text)
                                                    : text;
}

QString participantStanding(const OpenStudy& study, const ParticipantRow& row, const QLocale& locale) {
    if (row.participant.state == database::ParticipantState::consented)
        return participantProgress(study, row, locale);
    const QString state = study_words::participantState(row.participant.state);
    return row.participant.state == database::ParticipantState::completed && isWaiting(study, row)
               ? ParticipantProgress::tr("%1, with questions to answer").arg(state)
               : state;
}

bool isWaiting(const OpenStudy& study, const ParticipantRow& row) {
    using database::ParticipantState;
    if (row.participant.simulated)
        return false;
    if (row.participant.state == ParticipantState::enrolled)
        return study.summary.state == database::StudyState::frozen; // later nothing could be begun
    if (row.participant.state == ParticipantState::completed)
        return unanswered(study, row) != nullptr;
    if (row.participant.state != ParticipantState::consented || (row.runs.empty() && !mayBegin(study, row)))
        return false;
    const std::vector<ConditionProgress> conditions = conditionProgress(study, row);
    return unanswered(study, row) ||
           std::any_of(conditions.begin(), conditions.end(), [](const ConditionProgress& each) {
               return each.state == ProgressState::interrupted ||
                      (each.state == ProgressState::notBegun && !each.closed);
           });
}

QString nextStepFor(const OpenStudy& study, const ParticipantRow& row, const QString& language) {
    using database::ParticipantState;
    if (row.participant.simulated)
        return ParticipantProgress::tr(
            "This participant is simulated: its runs are made on the command line.");
    if (row.participant.state == ParticipantState::withdrawn)
        return ParticipantProgress::tr("Nothing is left to do: this participant has withdrawn. If somebody "
                                       "else is to take their place, enrol that person.");
    if (study.summary.state == database::StudyState::archived)
        return ParticipantProgress::tr(
            "Bring the study back from the archive before this participant goes on.");
    if (row.participant.state == ParticipantState::enrolled)
        return ParticipantProgress::tr("Record the consent. Then the first condition can begin.");
    const std::vector<ConditionProgress> conditions = conditionProgress(study, row);
    const auto name = [&](const ConditionProgress& each) {
        return conditionName(study, each.label, language);
    };
    for (const ConditionProgress& each : conditions) // participants do them in this order
        if (each.state == ProgressState::interrupted)
            return ParticipantProgress::tr(
                       "Press Run and resume “%1” at the trial where it stopped. If this participant does "
                       "not come back, withdraw them: what they did is kept.")
                .arg(name(each));
    const psychophysics::Questionnaire* questions = unanswered(study, row);
    const QString asked = questions ? study_words::text(questions->title, language) : QString();
    for (const ConditionProgress& each : conditions)
        if (each.state == ProgressState::notBegun) {
            if (!each.closed)
                return ParticipantProgress::tr("Press Run and begin “%1”.").arg(name(each));
            const QString closed =
                ParticipantProgress::tr("“%1” can no longer be started, because the study is "
                                        "closed. The conditions that are done count.")
                    .arg(name(each));
            return isWaiting(study, row)
                       ? closed + QLatin1Char(' ') +
                             ParticipantProgress::tr("The questionnaire “%1” is not answered yet.").arg(asked)
                       : closed;
        }
    return questions
               ? ParticipantProgress::tr(
                     "Every condition is done. The questionnaire “%1” is not answered yet.")
                     .arg(asked)
               : ParticipantProgress::tr("Nothing is left to do: this participant has done everything.");
}

} // namespace chiron::desktop
