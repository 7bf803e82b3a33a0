// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/design_faults.h"

#include "catalogue/study_json.h"
#include "desktop/studies/study_screen.h"
#include "desktop/studies/study_words.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>

namespace chiron::desktop {

using psychophysics::Condition;
using psychophysics::StudyDesign;

namespace {

struct FaultWords {
    Q_DECLARE_TR_FUNCTIONS(DesignFaults)
};

/// A line of the reader's error: "file:3:4: $.conditions[0].id: found: expected".
struct ReaderFault {
    QString path; ///< without "$."
    QString found, expected;
};

std::vector<ReaderFault> readerFaults(const core::Error& error) {
    static const QRegularExpression kLine(
        QStringLiteral("^.*?:\\d+:\\d+:\\s*\\$\\.?([^:]*): (.*?): (?:expected )?(.*)$"));
    std::vector<ReaderFault> faults;
    for (const QString& line :
         QString::fromStdString(error.message).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        const QRegularExpressionMatch match = kLine.match(line);
        if (match.hasMatch())
            faults.push_back({match.captured(1), match.captured(2), match.captured(3)});
        else
            faults.push_back({{}, line, {}});
    }
    return faults;
}

/// Where the texts, rules and limits of a study are edited: the beginning of a path, the page, the field.
struct Spot {
    const char* path;
    int tab;
    const char* field;
};
constexpr Spot kSpots[] = {
    {"title", StudyScreen::generalTab, "design.title"},
    {"objective", StudyScreen::generalTab, "design.objective"},
    {"source", StudyScreen::generalTab, "design.source"},
    {"ethics", StudyScreen::generalTab, "design.ethics"},
    {"consent", StudyScreen::generalTab, "design.consent"},
    {"participants_planned", StudyScreen::generalTab, "design.planned"},
    {"own_instructions", StudyScreen::trialsTab, "design.instructions"},
    {"instructions", StudyScreen::trialsTab, "design.instructions"},
    {"order", StudyScreen::trialsTab, "design.order"},
    {"seed", StudyScreen::trialsTab, "design.seed"},
    {"trial.explore_limit_s", StudyScreen::trialsTab, "trial.explore_limit"},
    {"trial.answer_limit_s", StudyScreen::trialsTab, "trial.answer_limit"},
    {"trial.between_trials_s", StudyScreen::trialsTab, "trial.between_trials"},
    {"trial.break_at_least_s", StudyScreen::trialsTab, "trial.break_at_least"},
    {"trial.practice_trials", StudyScreen::trialsTab, "trial.practice_trials"},
    {"trial.break_every", StudyScreen::trialsTab, "trial.break_every"},
    {"trial.probe_at_least_N", StudyScreen::trialsTab, "trial.probe_at_least"},
    {"fidelity.force_error_rms_N", StudyScreen::trialsTab, "fidelity.force_error"},
    {"fidelity.stiffness_error", StudyScreen::trialsTab, "fidelity.stiffness_error"},
    {"fidelity.late_ticks", StudyScreen::trialsTab, "fidelity.late_ticks"},
    {"fidelity.saturated", StudyScreen::trialsTab, "fidelity.saturated"},
    {"fidelity.peak_force_N", StudyScreen::trialsTab, "fidelity.peak_force"},
    {"fidelity.mean_speed_m_per_s", StudyScreen::trialsTab, "fidelity.mean_speed"},
    {"fidelity.repeats_at_most", StudyScreen::trialsTab, "fidelity.repeats_at_most"},
    {"questionnaires", StudyScreen::questionnairesTab, ""},
};

/// Fields of a condition, by the end of the path.
constexpr std::pair<const char*, const char*> kConditionSpots[] = {
    {"instructions", "condition.instructions"},
    {"title", "condition.title"},
    {"id", "condition.id"},
    {"stimulus.attribute", "condition.attribute"},
    {"stimulus.reference", "condition.reference"},
    {"stimulus.differences", "differences.levels"},
    {"task", "condition.task"},
    {"scale", "condition.scale"},
    {"criterion", "condition.criterion"},
};

const QString kTableField = QStringLiteral("differences.levels");

/// Field of a procedure; handles the fields whose names differ from their keys.
QString procedureField(const QString& procedure, const QString& key) {
    QString end = key;
    end.remove(QRegularExpression(QStringLiteral("^stop\\.?")));
    if (end.startsWith(QStringLiteral("differences")) || end.startsWith(QStringLiteral("stimuli")))
        return kTableField; // because they are taken from it
    static const QRegularExpression kGrid(QStringLiteral("^parameters\\[(\\d+)\\]"));
    if (const auto match = kGrid.match(end); match.hasMatch())
        end = QStringLiteral("grid") + match.captured(1);
    end.remove(QRegularExpression(QStringLiteral("[.\\[].*$")));
    return QStringLiteral("procedure.%1.%2").arg(procedure, end.isEmpty() ? QStringLiteral("kind") : end);
}

/// Field of a questionnaire or of one of its questions; empty where a path names neither.
QString questionField(const QString& path) {
    static const QRegularExpression kItem(
        QStringLiteral("^questionnaires\\[(\\d+)\\]\\.items\\[(\\d+)\\]\\.(\\w+)"));
    if (const auto match = kItem.match(path); match.hasMatch())
        return QStringLiteral("item.%1.%2.%3").arg(match.captured(1), match.captured(2), match.captured(3));
    static const QRegularExpression kQuestionnaire(QStringLiteral("^questionnaires\\[(\\d+)\\]\\.(\\w+)"));
    const auto match = kQuestionnaire.match(path);
    return match.hasMatch() ? QStringLiteral("questionnaire.%1.%2").arg(match.captured(1), match.captured(2))
                            : QString();
}

void place(DesignFault& fault, const QString& path) {
    static const QRegularExpression kCondition(QStringLiteral("^conditions\\[(\\d+)\\]\\.?(.*)$"));
    static const QRegularExpression kProcedure(QStringLiteral("^procedures\\[(\\d+)\\]\\.?(.*)$"));
    if (const auto match = kCondition.match(path); match.hasMatch()) {
        fault.tab = StudyScreen::conditionsTab;
        fault.condition = match.captured(1).toInt();
        const QString rest = match.captured(2);
        if (const auto procedure = kProcedure.match(rest); procedure.hasMatch())
            fault.field = procedureField(procedure.captured(1), procedure.captured(2));
        for (const auto& [start, field] : kConditionSpots)
            if (rest.startsWith(QLatin1String(start)))
                fault.field = QLatin1String(field);
        return;
    }
    fault.tab =
        path.startsWith(QStringLiteral("conditions")) ? StudyScreen::conditionsTab : StudyScreen::generalTab;
    for (const Spot& spot : kSpots)
        if (path == QLatin1String(spot.path) ||
            path.startsWith(QLatin1String(spot.path) + QLatin1Char('.')) ||
            path.startsWith(QLatin1String(spot.path) + QLatin1Char('['))) {
            fault.tab = spot.tab;
            fault.field =
                spot.tab == StudyScreen::questionnairesTab ? questionField(path) : QLatin1String(spot.field);
            return;
        }
}

QString rangeWords(psychophysics::Attribute attribute, const QLocale& locale) {
    const catalogue::ValueRange range = catalogue::valueRange(attribute);
    return FaultWords::tr("%1 to %2")
        .arg(study_words::value(range.lowest, attribute, locale),
             study_words::value(range.highest, attribute, locale));
}

/// The error text for a reference or a table: what can be rendered, in the attribute's unit.
QString stimulusWords(const Condition& condition, const QString& field, const ReaderFault& fault,
                      const QLocale& locale) {
    const psychophysics::StimulusDesign& stimulus = condition.stimulus;
    const QString allowed = rangeWords(stimulus.attribute, locale);
    if (field == QStringLiteral("condition.reference"))
        return FaultWords::tr("%1 cannot be rendered. Choose a reference of %2.")
            .arg(study_words::value(stimulus.reference, stimulus.attribute, locale), allowed);
    static const QRegularExpression kObject(QStringLiteral("an object of ([-+0-9.e]+)"));
    if (const auto match = kObject.match(fault.found); match.hasMatch())
        return FaultWords::tr("An object would have %1, but only %2 can be rendered. Choose smaller "
                              "differences or another reference.")
            .arg(study_words::value(match.captured(1).toDouble(), stimulus.attribute, locale), allowed);
    if (fault.expected.startsWith(QStringLiteral("more than 0")))
        return FaultWords::tr(
            "This task compares with objects above the reference only: every difference must be above 0 %.");
    if (fault.expected.startsWith(QStringLiteral("more than the one before")))
        return FaultWords::tr("A difference is listed twice. Remove one of them.");
    return {};
}

const QString kTwice = QStringLiteral("not given twice");

QString generalWords(const ReaderFault& fault, const QLocale& locale) {
    static const QRegularExpression kBetween(
        QStringLiteral("(-?[0-9.]+(?:e[-+]?\\d+)?) to (-?[0-9.]+(?:e[-+]?\\d+)?)"));
    if (fault.found == QStringLiteral("0 characters") || fault.found == QStringLiteral("missing"))
        return FaultWords::tr("This is empty. Write something.");
    if (fault.expected.startsWith(QStringLiteral("lower-case letters")))
        return FaultWords::tr("Use only lower-case letters, digits and _, and begin with a letter.");
    if (fault.expected.contains(kTwice))
        return FaultWords::tr("This is already used. Choose something else.");
    if (fault.expected == QStringLiteral("more than lowest"))
        return FaultWords::tr("The maximum has to be above the minimum.");
    static const QRegularExpression kChoices(QStringLiteral("^an array of (\\d+) to (\\d+) texts$"));
    if (const auto match = kChoices.match(fault.expected); match.hasMatch())
        return FaultWords::tr("Enter %1 to %2 choices, one per line.")
            .arg(match.captured(1), match.captured(2));
    static const QRegularExpression kAtMost(QStringLiteral("^at most \\w+, (\\d+)$"));
    if (const auto match = kAtMost.match(fault.expected); match.hasMatch())
        return FaultWords::tr("Choose a value of at most %1.")
            .arg(locale.toString(match.captured(1).toLongLong()));
    // The ends of the table, for procedures that begin within it.
    if (fault.expected.startsWith(QStringLiteral("a number from minimum to maximum")) ||
        fault.expected.contains(QStringLiteral("as the table of differences has")))
        return FaultWords::tr(
            "A level lies outside the table of differences. Choose one within it, or change the table.");
    if (const auto match = kBetween.match(fault.expected); match.hasMatch())
        return FaultWords::tr("Choose a value from %1 to %2.")
            .arg(locale.toString(match.captured(1).toDouble(), 'g', 6),
                 locale.toString(match.captured(2).toDouble(), 'g', 6));
    return fault.expected.isEmpty()
               ? fault.found
               : FaultWords::tr("Found: %1. Expected: %2.").arg(fault.found, fault.expected);
}

/// The error text for the smallest force: what prevents it.
QString probeWords(const ReaderFault& fault, const QLocale& locale) {
    static const QRegularExpression kForce(QStringLiteral("([0-9.]+(?:e[-+]?\\d+)?) N"));
    const auto match = kForce.match(fault.expected);
    const QString most = match.hasMatch() ? locale.toString(match.captured(1).toDouble(), 'g', 3) : QString();
    if (match.hasMatch() && fault.expected.startsWith(QStringLiteral("at most")))
        return FaultWords::tr("The lightest object weighs only %1 N, so lifting it would not count as "
                              "touching. Choose a smaller force.")
            .arg(most);
    if (match.hasMatch() && fault.expected.startsWith(QStringLiteral("less than")))
        return FaultWords::tr("A trial with more than %1 N does not count, so this force has to be smaller.")
            .arg(most);
    return generalWords(fault, locale);
}

QString wordsOf(const StudyDesign& design, const DesignFault& fault, const ReaderFault& said,
                const QLocale& locale) {
    const bool ofCondition =
        fault.condition >= 0 && static_cast<std::size_t>(fault.condition) < design.conditions.size();
    if (ofCondition && (fault.field == QStringLiteral("condition.reference") ||
                        fault.field == QStringLiteral("differences.levels")))
        if (const QString words = stimulusWords(design.conditions[static_cast<std::size_t>(fault.condition)],
                                                fault.field, said, locale);
            !words.isEmpty())
            return words;
    if (fault.field == QStringLiteral("design.planned"))
        return FaultWords::tr("At least one participant is needed.");
    if (fault.field == QStringLiteral("trial.probe_at_least"))
        return probeWords(said, locale);
    if (fault.field == QStringLiteral("trial.explore_limit") ||
        fault.field == QStringLiteral("fidelity.stiffness_error") || !said.expected.isEmpty())
        return generalWords(said, locale);
    return said.found;
}

/// Reports the fault at both conditions, because either may be the one that was just changed.
void addToBoth(std::vector<DesignFault>& faults, const StudyDesign& design, const DesignFault& fault) {
    for (std::size_t i = 0; i < design.conditions.size(); ++i)
        if (design.conditions[i].id == design.conditions[static_cast<std::size_t>(fault.condition)].id) {
            DesignFault one = fault;
            one.condition = static_cast<int>(i);
            faults.push_back(std::move(one));
        }
}

bool sameTitle(const Condition& a, const Condition& b) {
    return std::any_of(a.title.begin(), a.title.end(), [&](const auto& each) {
        const auto found = b.title.find(each.first);
        return found != b.title.end() && QString::fromStdString(found->second).trimmed() ==
                                             QString::fromStdString(each.second).trimmed();
    });
}

} // namespace

std::vector<DesignFault> designFaults(const StudyDesign& design, const core::Error& error,
                                      const QLocale& locale) {
    std::vector<DesignFault> faults;
    for (const ReaderFault& each : readerFaults(error)) {
        DesignFault fault;
        place(fault, each.path);
        fault.words = wordsOf(design, fault, each, locale);
        const bool ofTable = fault.field == kTableField && each.path.contains(QStringLiteral(".stimulus."));
        if (ofTable) // removes the procedures' errors that follow from the table's error
            std::erase_if(faults, [&](const DesignFault& other) {
                return other.condition == fault.condition && other.field == kTableField;
            });
        if (fault.field == QStringLiteral("condition.id") && each.expected.contains(kTwice))
            addToBoth(faults, design, fault);
        else
            faults.push_back(std::move(fault));
    }
    std::stable_sort(faults.begin(), faults.end(),
                     [](const DesignFault& a, const DesignFault& b) { return a.tab < b.tab; });
    return faults;
}

std::vector<DesignFault> nameFaults(const StudyDesign& design) {
    std::vector<DesignFault> faults;
    for (std::size_t i = 0; i < design.conditions.size(); ++i) {
        const auto twins =
            std::count_if(design.conditions.begin(), design.conditions.end(),
                          [&](const Condition& other) { return sameTitle(design.conditions[i], other); });
        if (twins > 1)
            faults.push_back(
                {StudyScreen::conditionsTab, static_cast<int>(i), QStringLiteral("condition.title"),
                 FaultWords::tr(
                     "Another condition has the same name. Tables and figures could not tell them apart.")});
    }
    return faults;
}

QMap<QString, QString> faultsOfPage(const std::vector<DesignFault>& faults, int tab, int condition) {
    QMap<QString, QString> words;
    for (const DesignFault& fault : faults)
        if (fault.tab == tab && (fault.condition < 0 || fault.condition == condition) &&
            !fault.field.isEmpty() && !words.contains(fault.field))
            words[fault.field] = fault.words;
    return words;
}

} // namespace chiron::desktop
