// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/verdict.h"

#include "desktop/plots/session_token_words.h"
#include "report/report_text.h"
#include "session_report/metric_words.h"

#include <QCoreApplication>

#include <algorithm>

namespace chiron::desktop {

using database::SessionState;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Verdict)
};

/// A scripted demonstration: no person passed or stopped anything.
bool isDemonstration(const DebriefHead& head) {
    return !head.record.summary.operatorName.empty() &&
           head.record.summary.person == database::Actor::kSimulatedPerson;
}

std::vector<const report::MetricRow*> missedRows(const DebriefHead& head) {
    std::vector<const report::MetricRow*> missed;
    for (const report::MetricRow& row : head.report.metrics)
        if (row.passed == std::optional<bool>(false))
            missed.push_back(&row);
    return missed;
}

/// Adds the missed pass marks and the advice for each, causes first.
void tellMissed(Verdict& verdict, const DebriefHead& head, const QLocale& locale,
                const std::vector<MetricAdvice>& advice) {
    std::vector<const report::MetricRow*> missed = missedRows(head);
    const auto place = [&](const report::MetricRow* row) {
        return std::find_if(advice.begin(), advice.end(),
                            [&](const MetricAdvice& one) { return one.metric == row->id.toStdString(); });
    };
    std::stable_sort(missed.begin(), missed.end(),
                     [&](const auto* a, const auto* b) { return place(a) < place(b); });
    for (const report::MetricRow* row : missed) {
        const auto found = place(row);
        verdict.reasons << missedGateText(*row, locale);
        verdict.advice.push_back(found == advice.end() ? MetricAdvice{row->id.toStdString(), {}} : *found);
    }
}

Verdict ofCompleted(const DebriefHead& head, const QLocale& locale, const std::vector<MetricAdvice>& advice) {
    if (!head.report.passed)
        return {"info",
                QStringLiteral("dialog-ok-apply"),
                Words::tr("Completed"),
                Words::tr("This level has no pass mark. The values below are for comparison only."),
                {}};
    if (*head.report.passed)
        return {"good",
                QStringLiteral("dialog-ok-apply"),
                isDemonstration(head) ? Words::tr("The demonstration passed") : Words::tr("Passed"),
                Words::tr("Every pass mark of this level was met."),
                {}};
    Verdict verdict{"warning", QStringLiteral("dialog-warning"), Words::tr("Not passed yet"), {}, {}};
    tellMissed(verdict, head, locale, advice);
    verdict.text = Words::tr("%n pass mark(s) of this level were not met:", nullptr,
                             static_cast<int>(verdict.reasons.size()));
    return verdict;
}

/// How much was completed, as a sentence that all unfinished states share.
QString reached(const DebriefHead& head) {
    if (head.record.setup.plannedTrials <= 1)
        return Words::tr("The procedure was not completed.");
    return Words::tr("%1 of %2 trials were completed.")
        .arg(QLocale().toString(head.report.trialsDone), QLocale().toString(head.record.setup.plannedTrials));
}

Verdict ofUnfinished(const DebriefHead& head, SessionState state) {
    Verdict verdict{"warning", stateIcon(state), {}, {}, {}};
    switch (state) {
    case SessionState::stopped:
        verdict.title = isDemonstration(head) ? Words::tr("The demonstration was stopped")
                                              : Words::tr("Stopped before the end");
        verdict.text = isDemonstration(head)
                           ? Words::tr("%1 What was recorded can be played back.").arg(reached(head))
                           : Words::tr("%1 What was recorded is kept and can be played back. The session "
                                       "does not count towards passing; try "
                                       "again when you are ready.")
                                 .arg(reached(head));
        break;
    case SessionState::interrupted:
        verdict.title = Words::tr("Interrupted");
        verdict.text = Words::tr("The program ended during this session. %1 Everything recorded up to then "
                                 "was saved and can be played "
                                 "back. The session does not count towards passing.")
                           .arg(reached(head));
        break;
    case SessionState::incomplete:
        verdict.title = Words::tr("Incomplete recording");
        verdict.text =
            Words::tr("The computer could not keep up and %n sample(s) were lost. The rest is kept and can "
                      "be played back. The "
                      "session does not count towards passing; close other programs before the next attempt.",
                      nullptr, static_cast<int>(head.record.summary.dropped));
        break;
    case SessionState::faulted:
        verdict.kind = "bad";
        verdict.title = Words::tr("Ended by a fault");
        verdict.text =
            Words::tr("The device or the force supervisor stopped this session for safety. %1 What was "
                      "recorded is kept. The "
                      "session does not count towards passing; check the device before the next attempt.")
                .arg(reached(head));
        break;
    case SessionState::running:
        verdict.kind = "info";
        verdict.title = Words::tr("Still running");
        verdict.text = Words::tr("This session has not ended yet. Its result will appear here when it ends.");
        break;
    case SessionState::completed:
    case SessionState::voided:
        break;
    }
    return verdict;
}

Verdict ofVoided(const DebriefHead& head) {
    const QString reason = QString::fromStdString(head.record.voidReason);
    Verdict verdict{"warning", stateIcon(SessionState::voided), Words::tr("Voided"), {}, {}};
    verdict.text =
        reason.isEmpty()
            ? Words::tr(
                  "A trainer declared this session void. Recording and scores are kept but do not count.")
            : Words::tr(
                  "A trainer declared this session void: %1\nRecording and scores are kept but do not count.")
                  .arg(reason);
    return verdict;
}

double overBy(const report::MetricRow& row) {
    if (row.gateMaximum && *row.value > *row.gateMaximum)
        return *row.value - *row.gateMaximum;
    return row.gateMinimum ? *row.gateMinimum - *row.value : 0.0;
}

} // namespace

QString missedGateText(const report::MetricRow& row, const QLocale& locale) {
    const QString name = session_report::metricTitle(row.id, row.trials);
    const QString gate = report::formatGate(row, locale);
    if (!row.value)
        return Words::tr("%1: no value (%2), but the pass mark is %3")
            .arg(name, session_report::metricReason(row.reason), gate);
    const QString value = report::formatValue(row.value, row.unit, locale);
    const QString by =
        row.unit == QLatin1String("%")
            ? Words::tr("%1 percentage points").arg(report::formatValue(overBy(row), {}, locale))
            : report::formatValue(overBy(row), row.unit, locale);
    const bool above = row.gateMaximum && *row.value > *row.gateMaximum;
    if (row.unit == QLatin1String("count"))
        return above ? Words::tr("%1: %2, but the pass mark is %3 (%4 too many)").arg(name, value, gate, by)
                     : Words::tr("%1: %2, but the pass mark is %3 (%4 too few)").arg(name, value, gate, by);
    return above ? Words::tr("%1: %2, but the pass mark is %3 (%4 too much)").arg(name, value, gate, by)
                 : Words::tr("%1: %2, but the pass mark is %3 (%4 too little)").arg(name, value, gate, by);
}

QString changeText(const DebriefHead& head, const QLocale& locale, bool own) {
    constexpr int kMost = 3; // as many as there are main numbers
    enum class Tells { fails, failedBefore, other };
    QStringList changes;
    for (const Tells wanted : {Tells::fails, Tells::failedBefore, Tells::other})
        for (const report::MetricRow& row : head.report.metrics) {
            const auto before = head.before.find(row.id.toStdString());
            if (!row.passed || !row.value || before == head.before.end() || changes.size() >= kMost)
                continue;
            const bool missedBefore = (row.gateMaximum && before->second > *row.gateMaximum) ||
                                      (row.gateMinimum && before->second < *row.gateMinimum);
            const Tells tells = !*row.passed   ? Tells::fails
                                : missedBefore ? Tells::failedBefore
                                               : Tells::other;
            const QString was = report::formatValue(before->second, row.unit, locale),
                          is = report::formatValue(row.value, row.unit, locale);
            // An unchanged value within its pass mark is not worth mentioning.
            if (tells == wanted && (was != is || tells != Tells::other))
                changes
                    << Words::tr("%1 %2 → %3").arg(session_report::metricTitle(row.id, row.trials), was, is);
        }
    if (changes.isEmpty())
        return {};
    return (own ? Words::tr("Since your last attempt: %1") : Words::tr("Since the previous attempt: %1"))
        .arg(changes.join(QStringLiteral(" · ")));
}

Verdict verdictOf(const DebriefHead& head, const QLocale& locale, const std::vector<MetricAdvice>& advice) {
    const SessionState state = head.record.summary.state;
    Verdict verdict = state == SessionState::completed ? ofCompleted(head, locale, advice)
                      : state == SessionState::voided  ? ofVoided(head)
                                                       : ofUnfinished(head, state);
    if (head.record.summary.familiarisation) {
        verdict.kind = "info";
        verdict.text = Words::tr("Familiarisation is recorded but never counts. %1").arg(verdict.text);
    }
    return verdict;
}

} // namespace chiron::desktop
