// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/group_words.h"

#include "psychophysics/measures/run_warnings.h"
#include "psychophysics/study/group_estimate.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace chiron::session_report {

namespace {

using psychophysics::WarningKind;
using session::GroupRoll;
using session::Presence;
using session::Remedy;
using session::RolledPerson;

QString whetherThereIsOne(const GroupRoll& roll, const QLocale& locale) {
    if (!roll.codesOf(Presence::sealed).empty())
        return Words::tr("The group value stays sealed until the study is unblinded.");
    const int used = roll.used();
    const int expected = roll.expected();
    if (expected == 0)
        return Words::tr("There is no group value: nobody takes part.");
    if (used == 0)
        return Words::tr("There is no group value yet: no participant's run is included so far.");
    return used == expected ? Words::tr("The group value includes everybody who takes part.")
                            : Words::tr("The group value includes %1 of %2 participants.")
                                  .arg(locale.toString(used), locale.toString(expected));
}

static_assert(psychophysics::kFewTrials == 20); // openValue() says it

/// What a run has whose answers leave the value open, and what would help. "%1": the codes.
QString openValue(const RolledPerson& person) {
    QStringList said;
    switch (person.presence) {
    case Presence::allRight:
        said << Words::tr("%1: every answer was right, so the threshold may lie far below the smallest "
                          "difference presented.");
        break;
    case Presence::guessing:
        said << (person.guesses
                     ? Words::tr("%1: the answers are no better than guessing, so the threshold may lie far "
                                 "above the largest difference presented. Check that the task was "
                                 "understood.")
                     : Words::tr("%1: the answers do not rule out a threshold far above the largest "
                                 "difference presented."));
        break;
    default:
        said << (person.openBelow
                     ? Words::tr("%1: the answers do not rule out a threshold far below the smallest "
                                 "difference presented.")
                     : Words::tr("%1: the answers do not rule out a threshold far below the smallest "
                                 "difference presented, nor one far above the largest."));
        break;
    }
    const bool larger = person.presence == Presence::guessing;
    switch (person.remedy) {
    case Remedy::none:
        break;
    case Remedy::moreTrials:
        said << (person.answers > 0 && person.answers < psychophysics::kFewTrials
                     ? Words::tr("Fewer than 20 answers rarely measure a threshold.")
                     : Words::tr("There are too few answers to measure the threshold."));
        said << Words::tr("Copy the study and plan more trials: its page “Expected precision” shows how many "
                          "trials most runs need to give a value.");
        break;
    case Remedy::unusedDifferences:
        said << (larger ? Words::tr("The study's table has larger differences, which were not presented. To "
                                    "measure the threshold, copy the study and plan more trials or a larger "
                                    "first difference.")
                        : Words::tr("The study's table has smaller differences, which were not presented. To "
                                    "measure the threshold, copy the study and plan more trials."));
        break;
    case Remedy::otherDifferences:
        said << (larger
                     ? Words::tr("To measure the threshold, copy the study and plan larger differences.")
                     : Words::tr("To measure the threshold, copy the study and plan smaller differences."));
        break;
    case Remedy::moreDifferences:
        said << Words::tr("Only one difference was presented. To measure the threshold, copy the study and "
                          "plan several.");
        break;
    }
    return said.join(QLatin1Char(' '));
}

/// The reason why a participant is not included, and the action to take. "%1": the codes of all who have it.
QString reason(const RolledPerson& person, bool closed) {
    switch (person.presence) {
    case Presence::notBegun:
        return closed ? Words::tr("%1: this condition was not begun, and no run can be started any more "
                                  "because the study is closed.")
                      : Words::tr("%1: this condition has not been begun. Begin it under Run.");
    case Presence::noAnswers:
        return Words::tr("%1: no answer counts yet. Resume the run under Run.");
    case Presence::unfinished:
        return closed
                   ? Words::tr("%1: the answers give no value, and the run cannot be resumed because the "
                               "study is closed.")
                   : Words::tr("%1: the answers give no value yet. The run is not finished: resume it under "
                               "Run if the participant goes on.");
    case Presence::allRight:
    case Presence::guessing:
    case Presence::unbounded:
        return openValue(person);
    case Presence::noValue:
        return Words::tr("%1: the answers give no value. The warnings of the run say why.");
    case Presence::shown:
        return Words::tr(
            "%1: objects were shown, not felt. Such runs are left out unless they are included on purpose.");
    case Presence::simulated:
        return Words::tr("%1: simulated, and therefore left out of a group of people.");
    case Presence::withdrawn:
        return Words::tr("%1: withdrawn, and therefore left out.");
    case Presence::used:
    case Presence::sealed:
        break;
    }
    return {};
}

/// The codes of people who have a value in only one of two conditions.
std::vector<std::string> onlyIn(const GroupRoll& roll, const GroupRoll& other) {
    std::vector<std::string> codes = roll.codesOf(Presence::used);
    std::erase_if(codes, [&](const std::string& code) { return other.of(code) == Presence::used; });
    return codes;
}

QString notCompared(const GroupRoll& first, const GroupRoll& second, const QString& a, const QString& b) {
    for (const auto& [roll, name] : {std::pair{&first, a}, std::pair{&second, b}})
        if (roll->used() == 0)
            return Words::tr("“%1” and “%2” are not compared yet: “%3” has no group value.").arg(a, b, name);
    std::vector<std::string> both;
    for (const std::string& code : first.codesOf(Presence::used))
        if (second.of(code) == Presence::used)
            both.push_back(code);
    if (both.empty())
        // For stated numbers (magnitude estimation) there is no Weber fraction.
        return Words::tr("“%1” and “%2” are not compared: their values cannot be set against each other.")
            .arg(a, b);
    return Words::tr("“%1” and “%2” are not compared yet: only %3 has a value in both, and at least two "
                     "participants are needed; nor are there two groups, since nobody has a "
                     "value in “%4” alone.")
        .arg(a, b, study_report_words::codes(both), onlyIn(first, second).empty() ? a : b);
}

/// If one of two groups is a single person, there is a ratio but no measure of its uncertainty.
QString withoutInterval(const session::ComparedConditions& compared, const QString& a, const QString& b,
                        const QLocale& locale) {
    const psychophysics::ConditionComparison& weber = compared.weber;
    if (std::isfinite(weber.pValue) || weber.paired)
        return {};
    return Words::tr("“%1” and “%2” have a ratio, but no interval and no p: each of the two groups needs at "
                     "least two people, and these have %3 and %4.")
        .arg(a, b, locale.toString(weber.first), locale.toString(weber.second));
}

/// The same reasons in a few words.
QString whyNot(Presence presence) {
    switch (presence) {
    case Presence::used:
        return Words::tr("in the group value");
    case Presence::sealed:
        return Words::tr("sealed");
    case Presence::notBegun:
        return Words::tr("not begun");
    case Presence::noAnswers:
        return Words::tr("no answer counts yet");
    case Presence::unfinished:
        return Words::tr("the answers give no value yet");
    case Presence::allRight:
        return Words::tr("every answer was right");
    case Presence::guessing:
        return Words::tr("the threshold may be far above the largest difference");
    case Presence::unbounded:
        return Words::tr("the answers leave the threshold open");
    case Presence::noValue:
        return Words::tr("the answers give no value");
    case Presence::shown:
        return Words::tr("shown, not felt");
    case Presence::simulated:
        return Words::tr("simulated");
    case Presence::withdrawn:
        return Words::tr("withdrawn");
    }
    return {};
}

bool isSupported(const psychophysics::RunEstimate& estimate) {
    return psychophysics::usableInGroup(estimate) == psychophysics::Usable::yes;
}

/// True if the participant is left out of the whole study; the group sentences already state this.
bool isOut(Presence presence) {
    return presence == Presence::withdrawn || presence == Presence::simulated;
}

/// The participants who are missing from the comparison of two conditions, and why. `groups`: the comparison
/// is between different people, and somebody who did both is in neither group.
QStringList missing(const GroupRoll& first, const GroupRoll& second, const QString& a, const QString& b,
                    bool groups) {
    QStringList said;
    std::vector<std::string> codes;
    for (const GroupRoll* roll : {&first, &second})
        for (const RolledPerson& person : roll->people)
            if (std::find(codes.begin(), codes.end(), person.code) == codes.end())
                codes.push_back(person.code);
    for (const std::string& code : codes) {
        const Presence inFirst = first.of(code), inSecond = second.of(code);
        const bool inPair = inFirst == Presence::used && inSecond == Presence::used;
        const bool inGroup = (inFirst == Presence::used) != (inSecond == Presence::used);
        if ((groups ? inGroup : inPair) || isOut(inFirst) || isOut(inSecond))
            continue;
        if (inPair)
            said << Words::tr("%1 is not in this comparison: it compares two separate groups, and %1 has a "
                              "value in both “%2” and “%3”.")
                        .arg(QString::fromStdString(code), a, b);
        else
            said << Words::tr("%1 is not in this comparison (“%2”: %3; “%4”: %5).")
                        .arg(QString::fromStdString(code), a, whyNot(inFirst), b, whyNot(inSecond));
    }
    return said;
}

/// The participants who are left out of the whole study, each once.
QStringList outOfAll(const std::vector<GroupRoll>& rolls) {
    QStringList said;
    for (const Presence presence : {Presence::simulated, Presence::withdrawn}) {
        std::vector<std::string> codes;
        for (const GroupRoll& roll : rolls)
            for (const std::string& code : roll.codesOf(presence))
                if (std::find(codes.begin(), codes.end(), code) == codes.end())
                    codes.push_back(code);
        if (!codes.empty())
            said << reason({codes.front(), presence}, false).arg(study_report_words::codes(codes));
    }
    return said;
}

/// "2 of 6 participants (A, B)", or the codes alone where there is nobody else.
QString countedCodes(const std::vector<std::string>& codes, int of, const QLocale& locale) {
    const QString names = study_report_words::codes(codes);
    return of < 2 ? names
                  : Words::tr("%1 of %2 participants (%3)")
                        .arg(locale.toString(static_cast<int>(codes.size())), locale.toString(of), names);
}

/// One sentence for each reason why people with this presence are not included, with their number among
/// those who could be, and their codes.
QStringList reasons(const GroupRoll& roll, Presence presence, const QLocale& locale) {
    std::vector<std::pair<QString, std::vector<std::string>>> codesOf; // by reason, in the order of the roll
    for (const RolledPerson& person : roll.people) {
        if (person.presence != presence)
            continue;
        const QString why = reason(person, roll.closed);
        auto same =
            std::find_if(codesOf.begin(), codesOf.end(), [&](const auto& each) { return each.first == why; });
        if (same == codesOf.end())
            same = codesOf.emplace(codesOf.end(), why, std::vector<std::string>());
        same->second.push_back(person.code);
    }
    const int of = isOut(presence) ? static_cast<int>(roll.people.size()) : roll.expected();
    QStringList said;
    for (const auto& [why, codes] : codesOf)
        said << why.arg(countedCodes(codes, of, locale));
    return said;
}

} // namespace

QString groupRule() {
    return Words::tr(
        "A run counts if its answers rule out two things: a threshold far below the smallest difference "
        "presented (usually a tenth of it) and one far above the largest (usually ten times it). It does "
        "not matter whether the run is finished, or which other warnings it has. “Rule out” means that with "
        "such a threshold "
        "the answers are less than 15 % as likely as with the best one. Left out, from groups and "
        "comparisons alike, are runs whose answers do not rule out both or give no value, runs with objects "
        "shown and not felt (unless you include them), participants who have withdrawn, and simulated "
        "participants where there are people.");
}

QStringList groupSentences(const GroupRoll& roll, const QLocale& locale) {
    QStringList said{whetherThereIsOne(roll, locale)};
    if (!roll.codesOf(Presence::sealed).empty())
        return said;
    for (const Presence presence :
         {Presence::notBegun, Presence::noAnswers, Presence::unfinished, Presence::allRight,
          Presence::guessing, Presence::unbounded, Presence::noValue, Presence::shown, Presence::simulated,
          Presence::withdrawn})
        said << reasons(roll, presence, locale);
    const bool simulatedAlone = roll.enrolled == 0 && !roll.people.empty();
    if (!roll.closed && !simulatedAlone && roll.enrolled < roll.planned)
        said
            << Words::tr(
                   "So far %1 of %2 planned participants are enrolled. Enrol the others on the study's page.")
                   .arg(locale.toString(roll.enrolled), locale.toString(roll.planned));
    std::vector<std::string> open;
    for (const RolledPerson& person : roll.people)
        if (person.open && person.presence == Presence::used)
            open.push_back(person.code);
    if (!open.empty())
        said << Words::tr("%1: the group value includes a run that is not finished, so it may still "
                          "change. Resume the run under Run.")
                    .arg(countedCodes(open, roll.expected(), locale));
    return said;
}

std::vector<psychophysics::Warning> furtherWarnings(const std::vector<psychophysics::Warning>& warnings) {
    std::vector<psychophysics::Warning> further;
    for (const psychophysics::Warning& warning : warnings)
        switch (warning.kind) {
        case WarningKind::leftOutParticipants:
        case WarningKind::noParticipants:
        case WarningKind::withdrawn:
        case WarningKind::simulatedLeftOut:
        case WarningKind::shownLeftOut:
        case WarningKind::sealed:
            break;
        default:
            further.push_back(warning);
        }
    return further;
}

QString presenceWords(Presence presence) {
    if (presence == Presence::used)
        return Words::tr("yes");
    return presence == Presence::sealed ? whyNot(presence) : Words::tr("no: %1").arg(whyNot(presence));
}

QString supportedValue(const QString& value, const psychophysics::RunEstimate& estimate, bool open) {
    if (isSupported(estimate))
        return markedValue(value, estimate);
    return open ? Words::tr("no value yet") : Words::tr("no value");
}

QString supportedInterval(const QString& interval, const psychophysics::RunEstimate& estimate) {
    return isSupported(estimate) ? interval : QStringLiteral("–");
}

QString whyNoValue(const psychophysics::RunEstimate& estimate) {
    return isSupported(estimate) ? QString() : whyNot(session::presenceOf(estimate, true));
}

QString markedValue(const QString& value, const psychophysics::RunEstimate& estimate) {
    return estimate.warnings.empty() || !std::isfinite(estimate.weber) ? value : QStringLiteral("! ") + value;
}

QString markMeaning() {
    return Words::tr("“!” before a value: the run has warnings. Read them before you use the value.");
}

QStringList comparisonSentences(const std::vector<GroupRoll>& rolls,
                                const std::vector<session::ComparedConditions>& compared,
                                const std::function<QString(std::size_t)>& name, const QLocale& locale) {
    QStringList said;
    for (std::size_t i = 0; i < rolls.size(); ++i)
        for (std::size_t j = i + 1; j < rolls.size(); ++j) {
            const auto found = std::find_if(compared.begin(), compared.end(), [&](const auto& each) {
                return each.first == i && each.second == j;
            });
            if (found == compared.end())
                said << notCompared(rolls[i], rolls[j], name(i), name(j));
            else if (const QString why = withoutInterval(*found, name(i), name(j), locale); !why.isEmpty())
                said << why;
            said << missing(rolls[i], rolls[j], name(i), name(j),
                            found != compared.end() && !found->weber.paired);
        }
    return said + outOfAll(rolls);
}

} // namespace chiron::session_report
