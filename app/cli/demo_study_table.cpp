// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/demo_study_table.h"

#include "cli/study/study_access.h"
#include "cli/text_table.h"

#include <QJsonArray>
#include <cmath>

namespace chiron::cli {

namespace {

QString percent(double share) {
    return std::isfinite(share) ? QString::number(100.0 * share, 'f', 1) : QStringLiteral("-");
}
QString range(const psychophysics::Interval& ends) {
    return QStringLiteral("%1 to %2").arg(percent(ends.low), percent(ends.high));
}
QString jnd(double value, const std::string& unit) {
    return std::isfinite(value)
               ? QStringLiteral("%1 %2").arg(value, 0, 'f', 2).arg(QString::fromStdString(unit))
               : QStringLiteral("-");
}

} // namespace

QString demoStudyTable(const session::DemoStudy& study) {
    TextTable table({"participant", "observer", "rendered", ">trials", ">Weber %", "95 % interval", ">JND",
                     "same choices", "replay"});
    for (const session::DemoStudyRun& run : study.runs) {
        const bool rendered = run.session != 0;
        table.add({QString::fromStdString(run.participant), QString::fromStdString(run.observer),
                   rendered ? "yes" : "no", QString::number(run.estimate.trials), percent(run.estimate.weber),
                   range(run.estimate.weber95), jnd(run.estimate.jnd, run.estimate.unit),
                   run.choicesSame ? "yes" : "DIFFERS",
                   !rendered               ? "-"
                   : study.replayIdentical ? "identical"
                                           : "DIFFERS"});
    }
    const psychophysics::GroupEstimate& group = study.group;
    table.add({QStringLiteral("(group of %1)").arg(group.participants),
               {},
               {},
               {},
               percent(group.weber),
               range(group.weber95),
               jnd(group.jnd, group.unit)});
    return QStringLiteral("study %1, condition %2: simulated participants\n")
               .arg(QString::fromStdString(study.key), QString::fromStdString(study.condition)) +
           table.toText() +
           QStringLiteral("\nWeber: difference told apart in three of four comparisons, in % of the "
                          "reference; JND: the same in its unit; rendered: felt through\n"
                          "the scene and recorded, otherwise the observer was told the values; same choices: "
                          "the log chooses the same stimuli again\n\n");
}

QJsonObject demoStudyJson(const session::DemoStudy& study) {
    const auto number = [](double value) {
        return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
    };
    QJsonArray runs;
    for (const session::DemoStudyRun& run : study.runs)
        runs.append(QJsonObject{{"participant", QString::fromStdString(run.participant)},
                                {"observer", QString::fromStdString(run.observer)},
                                {"rendered", run.session != 0},
                                {"session_id", static_cast<qint64>(run.session)},
                                {"estimate", estimateJson(run.estimate, false)},
                                {"choices_same", run.choicesSame}});
    const psychophysics::GroupEstimate& g = study.group;
    const QJsonObject group{{"weber", number(g.weber)},
                            {"ci_low", number(g.weber95.low)},
                            {"ci_high", number(g.weber95.high)},
                            {"jnd", number(g.jnd)},
                            {"unit", QString::fromStdString(g.unit)},
                            {"participants", g.participants}};
    return {{"study", QString::fromStdString(study.key)},
            {"id", static_cast<qint64>(study.study)},
            {"draft_id", static_cast<qint64>(study.draft)},
            {"condition", QString::fromStdString(study.condition)},
            {"simulated", true},
            {"runs", runs},
            {"group", group},
            {"replay_identical", study.replayIdentical}};
}

} // namespace chiron::cli
