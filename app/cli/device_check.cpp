// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/device_check.h"

#include "cli/text_table.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

namespace {

using mechanisms::FingertipPublished;

QString in(double value, int digits) { return QString::number(value, 'f', digits); }

QJsonArray numbers(const std::vector<double>& values) {
    QJsonArray array;
    for (const double value : values)
        array.append(value);
    return array;
}

QJsonObject publishedJson() {
    QJsonArray cycles;
    for (const double rmse : FingertipPublished::kRmse_N)
        cycles.append(rmse);
    return {{"rmse_cycles_N", cycles},
            {"rmse_N", FingertipPublished::kMeanRmse_N},
            {"angle_error_deg", FingertipPublished::kMeanError_deg},
            {"angle_error_sd_deg", FingertipPublished::kSdError_deg}};
}

QJsonArray degradationJson(const FingertipCheck& check) {
    QJsonArray rows;
    for (const auto& row : check.degradation)
        rows.append(QJsonObject{{"what", QString::fromStdString(row.what)},
                                {"factor", row.factor},
                                {"rmse_N", row.rmse_N},
                                {"rmse_true_N", row.rmseTrue_N},
                                {"angle_error_deg", row.meanError_deg},
                                {"angle_error_true_deg", row.meanErrorTrue_deg},
                                {"holds", row.holds}});
    return rows;
}

QJsonObject seriesJson(const mechanisms::FingertipVerification& v) {
    QJsonArray poses;
    for (const auto& pose : v.poses)
        poses.append(QJsonArray{core::degFromRad(pose.referencePitch_rad), core::degFromRad(pose.referenceRoll_rad),
                                core::degFromRad(pose.measuredPitch_rad), core::degFromRad(pose.measuredRoll_rad),
                                core::degFromRad(pose.truePitch_rad), core::degFromRad(pose.trueRoll_rad)});
    return {{"time_s", numbers(v.series.time_s)},
            {"reference_N", numbers(v.series.reference_N)},
            {"measured_N", numbers(v.series.measured_N)},
            {"true_N", numbers(v.series.true_N)},
            {"height_m", numbers(v.series.height_m)},
            {"poses_deg", poses}};
}

QJsonObject toJson(const FingertipCheck& check, bool withSeries) {
    const auto& v = check.verification;
    QJsonArray cycles;
    for (const double rmse : v.rmse_N)
        cycles.append(rmse);
    QJsonObject json{{"mechanism", "fingertip_arm"},
                     {"seed", QString::number(check.seed)}, // a text: JSON numbers lose large seeds
                     {"holds", v.holds()},
                     {"frequency_Hz", v.settings.frequency_Hz},
                     {"peak_N", v.settings.peak_N},
                     {"rmse_cycles_N", cycles},
                     {"rmse_N", v.meanRmse_N},
                     {"rmse_true_N", v.meanRmseTrue_N},
                     {"poses", v.settings.poses},
                     {"angle_error_deg", v.meanError_deg},
                     {"angle_error_sd_deg", v.sdError_deg},
                     {"angle_error_true_deg", v.meanErrorTrue_deg},
                     {"latency_us", 1e6 * v.latency_s},
                     {"friction", QJsonObject{{"coulomb_N", check.friction.coulomb_N}, {"viscous_Ns_per_m", check.friction.viscous_Ns_per_m}}},
                     {"damping_Ns_per_m", check.damping_Ns_per_m},
                     {"stiffness_cap_N_per_m", check.stiffnessCap_N_per_m},
                     {"published", publishedJson()}};
    if (!check.degradation.empty())
        json["degradation"] = degradationJson(check);
    if (withSeries)
        json["series"] = seriesJson(v);
    return json;
}

QString figures(const FingertipCheck& check) {
    const auto& v = check.verification;
    TextTable table({QStringLiteral("figure"), QStringLiteral(">here"), QStringLiteral(">P3"), QStringLiteral(">really")});
    for (std::size_t cycle = 0; cycle < 3; ++cycle)
        table.add({QStringLiteral("force RMSE, cycle %1 (N)").arg(cycle + 1), in(v.rmse_N[cycle], 4),
                   in(FingertipPublished::kRmse_N[cycle], 3), in(v.rmseTrue_N[cycle], 4)});
    table.add({QStringLiteral("force RMSE, mean (N)"), in(v.meanRmse_N, 4), in(FingertipPublished::kMeanRmse_N, 4), in(v.meanRmseTrue_N, 4)});
    table.add({QStringLiteral("angle error, mean (°)"), in(v.meanError_deg, 2), in(FingertipPublished::kMeanError_deg, 2),
               in(v.meanErrorTrue_deg, 2)});
    table.add({QStringLiteral("angle error, SD (°)"), in(v.sdError_deg, 2), in(FingertipPublished::kSdError_deg, 2), in(v.sdErrorTrue_deg, 2)});
    return table.toText();
}

QString degradation(const FingertipCheck& check) {
    TextTable table({QStringLiteral("what"), QStringLiteral(">times"), QStringLiteral(">RMSE (N)"), QStringLiteral(">really (N)"),
                     QStringLiteral(">angle (°)"), QStringLiteral(">really (°)"), QStringLiteral("holds")});
    for (const auto& row : check.degradation)
        table.add({QString::fromStdString(row.what), QString::number(row.factor), in(row.rmse_N, 4), in(row.rmseTrue_N, 4),
                   in(row.meanError_deg, 2), in(row.meanErrorTrue_deg, 2), row.holds ? QStringLiteral("yes") : QStringLiteral("no")});
    return QLatin1Char('\n') + table.toText();
}

} // namespace

CommandOutput describeFingertipCheck(const FingertipCheck& check, bool withSeries) {
    const auto& v = check.verification;
    QString text = QStringLiteral("Fingertip platform, simulated; seed %1; sine 0 to %2 N at %3 Hz, %4 poses.\n"
                                  "\"here\" is what its own sensors measure, as P3 did; \"really\" what the pad gets.\n\n")
                       .arg(check.seed)
                       .arg(v.settings.peak_N)
                       .arg(v.settings.frequency_Hz)
                       .arg(v.settings.poses);
    text += figures(check) + QLatin1Char('\n');
    text += alignedPairs({{QStringLiteral("latency"), in(1e3 * v.latency_s, 1) + QStringLiteral(" ms")},
                          {QStringLiteral("friction of a drive"), QStringLiteral("%1 N + %2 N·s/m").arg(in(check.friction.coulomb_N, 3), in(check.friction.viscous_Ns_per_m, 2))},
                          {QStringLiteral("stiffest wall"), QStringLiteral("%1 N/m, with b + B = %2 N·s/m").arg(in(check.stiffnessCap_N_per_m, 0), shortNumber(check.damping_Ns_per_m))}});
    if (!check.degradation.empty())
        text += degradation(check);
    text += QLatin1Char('\n') + (v.holds() ? QStringLiteral("Holds: better than P3 in force and angle.\n")
                                           : QStringLiteral("Does not hold: not better than P3 in force and angle.\n"));
    return {QJsonDocument(toJson(check, withSeries)), text, v.holds() ? 0 : 1};
}

} // namespace chiron::cli
