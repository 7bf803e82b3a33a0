// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/apex_output.h"

#include "cli/study/study_access.h"
#include "session/study/trial_fidelity.h"

#include <QJsonArray>
#include <cmath>

namespace chiron::cli {

namespace {

using psychophysics::ApexAxis;
using psychophysics::ApexSummary;

constexpr double kPercent = 100.0;

QJsonValue value(double number) {
    return std::isfinite(number) ? QJsonValue(number) : QJsonValue(QJsonValue::Null);
}

QJsonArray ends(const psychophysics::Interval& interval, double factor = 1.0) {
    return {value(interval.low * factor), value(interval.high * factor)};
}

QJsonObject axisJson(const ApexAxis& axis, bool blinded) {
    const double percentPerMm = axis.biasPercent / axis.bias_mm; // the interval is stored in mm
    QJsonObject json{{"bias_percent", value(axis.biasPercent)}, {"sd_percent", value(axis.sdPercent)}};
    json.insert("bias_ci_percent",
                ends(axis.bias95_mm, std::isfinite(percentPerMm) ? percentPerMm : std::nan("")));
    if (blinded)
        return json;
    json.insert("bias_mm", value(axis.bias_mm));
    json.insert("bias_ci_mm", ends(axis.bias95_mm));
    json.insert("sd_mm", value(axis.sd_mm));
    json.insert("sd_within_mm", value(axis.sdWithin_mm));
    json.insert("sd_between_mm", value(axis.sdBetween_mm));
    return json;
}

} // namespace

QJsonObject apexJson(const ApexSummary& summary, bool blinded) {
    QJsonObject json{{"participants", summary.participants},
                     {"trials", summary.trials},
                     {"axes", QJsonObject{{"x", axisJson(summary.axes[0], blinded)},
                                          {"y", axisJson(summary.axes[1], blinded)}}},
                     {"mean_absolute_percent", value(summary.meanAbsolutePercent)},
                     {"sd_absolute_percent", value(summary.sdAbsolutePercent)},
                     {"mean_absolute_ci_percent", ends(summary.meanAbsolute95)},
                     {"mean_absolute_bootstrap_percent", ends(summary.meanAbsoluteBootstrap95)},
                     {"sd_over_mean", value(summary.sdOverMean)},
                     {"implied_sd_percent", value(summary.impliedSdPercent)},
                     {"warnings", warningsJson(summary.warnings, blinded)}};
    if (blinded)
        return json;
    json.insert("mean_absolute_mm", value(summary.meanAbsolute_mm));
    json.insert("mean_distance_mm", value(summary.meanDistance_mm));
    json.insert("implied_sd_mm", value(summary.impliedSd_mm));
    return json;
}

QJsonObject apexMarkJson(const database::StudyTrial& trial) {
    const auto mark = session::apexMarkOf(trial.fidelityJson);
    if (!mark)
        return {};
    const double percent = mark->radius_m > 0.0 ? kPercent / mark->radius_m : std::nan("");
    return {{"error_x_m", mark->errorX_m},
            {"error_y_m", mark->errorY_m},
            {"error_x_percent", value(mark->errorX_m * percent)},
            {"error_y_percent", value(mark->errorY_m * percent)},
            {"in_contact", mark->inContact},
            {"planned", mark->planned}};
}

QJsonObject apexPlanJson(int participants, int marksEach, int studies, std::uint64_t seed) {
    const psychophysics::ApexObserver observer;
    const auto plan = psychophysics::planApex(observer, participants, marksEach,
                                              psychophysics::kP2EarlierMeanPercent, studies, seed);
    return {{"observer_sd_percent", observer.sdPercent},
            {"participants", participants},
            {"marks_each", marksEach},
            {"mean_absolute_percent", value(plan.meanAbsolutePercent)},
            {"half_width_percent", value(plan.halfWidthPercent)},
            {"against_percent", psychophysics::kP2EarlierMeanPercent},
            {"power", value(plan.power)},
            {"mean_absolute_percent_error", value(plan.meanError)},
            {"half_width_percent_error", value(plan.halfWidthError)},
            {"power_error", value(plan.powerError)}};
}

TextTable apexTable(bool blinded) {
    QStringList headings{"participant", "condition", ">trials"};
    const QString unit = blinded ? QStringLiteral("%R") : QStringLiteral("mm");
    for (const char* axis : {"x", "y"})
        headings << QStringLiteral(">bias %1 (%2)").arg(QLatin1String(axis), unit)
                 << QStringLiteral(">sd %1 (%2)").arg(QLatin1String(axis), unit);
    return TextTable(headings + QStringList{">mean |error| (%R)", ">sd", "warnings"});
}

void addApexRow(TextTable& table, const QString& who, const QString& condition, const ApexSummary& summary,
                bool blinded) {
    QStringList cells{who, condition, QString::number(summary.trials)};
    for (const ApexAxis& axis : summary.axes)
        cells << shortNumber(blinded ? axis.biasPercent : axis.bias_mm)
              << shortNumber(blinded ? axis.sdPercent : axis.sd_mm);
    table.add(cells + QStringList{shortNumber(summary.meanAbsolutePercent),
                                  shortNumber(summary.sdAbsolutePercent), warningTokens(summary.warnings)});
}

} // namespace chiron::cli
