// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/platform_words.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

using mechanisms::FingertipPublished;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PlatformCheck)
};

QString newtons(double value, const QLocale& locale) { return Words::tr("%1 N").arg(locale.toString(value, 'f', 4)); }

QString degrees(double value, const QLocale& locale) { return Words::tr("%1°").arg(locale.toString(value, 'f', 2)); }

QString plantPart(const std::string& what) {
    if (what == "force_noise")
        return Words::tr("Noise, hysteresis and creep of the force sensors");
    if (what == "adc")
        return Words::tr("Steps of the converter");
    if (what == "delay")
        return Words::tr("Delay of the force sensors");
    if (what == "friction")
        return Words::tr("Friction of the drives");
    if (what == "backlash")
        return Words::tr("Backlash of the gears");
    if (what == "imu")
        return Words::tr("Noise and offset of the orientation sensor");
    return QString::fromStdString(what);
}

QString factorText(const mechanisms::FingertipDegradation& row, const QLocale& locale) {
    if (row.what == "adc")
        return row.factor == 0.0 ? Words::tr("16 bits") : Words::tr("× %1 as coarse").arg(locale.toString(row.factor, 'g', 3));
    return row.factor == 0.0 ? Words::tr("none") : Words::tr("× %1").arg(locale.toString(row.factor, 'g', 3));
}

} // namespace

QString platformVerdict(const PlatformCheck& check, const QLocale& locale) {
    const auto& v = check.verified;
    const QString force = newtons(v.meanRmse_N, locale);
    const QString angle = degrees(v.meanError_deg, locale);
    return v.holds() ? Words::tr("Passed: force follows within %1 and orientation within %2, both better than published.").arg(force, angle)
                     : Words::tr("Not passed: force follows within %1 and orientation within %2; published were %3 and %4.")
                           .arg(force, angle, newtons(FingertipPublished::kMeanRmse_N, locale), degrees(FingertipPublished::kMeanError_deg, locale));
}

QStringList platformFacts(const PlatformCheck& check, const QLocale& locale) {
    const auto& p = check.plant;
    const auto number = [&locale](double value, int decimals = 1) { return locale.toString(value, 'f', decimals); };
    return {Words::tr("This is the simulated platform, with a plant that is as bad as such parts are: force noise of %1 mN and %2 bits of the "
                      "converter, hysteresis of %3 %, a delay of %4 ms from sensor to controller, gear friction of %5 N a drive, backlash of %6 µm, an orientation sensor with %7° bias and %8° noise.")
                .arg(number(1e3 * p.force.noise_N), locale.toString(p.force.adcBits), number(100.0 * p.force.hysteresis, 0),
                     locale.toString(p.force.delay_ticks), number(p.drive.friction.coulomb, 2), number(1e6 * p.drive.backlash_m, 0),
                     number(p.imu.bias_rad * 57.29577951308232), number(p.imu.noise_rad * 57.29577951308232)),
            Words::tr("Friction as identified by moving the drives: %1 N, and %2 N·s/m with speed.")
                .arg(number(check.friction.coulomb_N, 3), number(check.friction.viscous_Ns_per_m, 2)),
            Words::tr("A step of force is felt after %1 ms. With the damping of drives and pad alone, a wall is stable up to %2 N/mm.")
                .arg(number(1e3 * check.verified.latency_s), number(1e-3 * check.stiffnessCap_N_per_m, 2))};
}

report::CheckTable platformFigures(const PlatformCheck& check, const QLocale& locale) {
    const auto& v = check.verified;
    report::CheckTable table{Words::tr("Beside the published figures"),
                             {{Words::tr("Figure"), Words::tr("By its own sensors"), Words::tr("What was really so"), Words::tr("Published (P3)")}}};
    for (std::size_t i = 0; i < v.rmse_N.size(); ++i)
        table.lines.push_back({Words::tr("Force, cycle %1: root mean square error").arg(locale.toString(static_cast<int>(i) + 1)), newtons(v.rmse_N[i], locale),
                               newtons(v.rmseTrue_N[i], locale), newtons(FingertipPublished::kRmse_N[i], locale)});
    table.lines.push_back({Words::tr("Force, mean of the cycles"), newtons(v.meanRmse_N, locale), newtons(v.meanRmseTrue_N, locale), newtons(FingertipPublished::kMeanRmse_N, locale)});
    table.lines.push_back({Words::tr("Orientation, mean error of %1 poses").arg(locale.toString(static_cast<int>(v.poses.size()))), degrees(v.meanError_deg, locale),
                           degrees(v.meanErrorTrue_deg, locale), degrees(FingertipPublished::kMeanError_deg, locale)});
    table.lines.push_back({Words::tr("Orientation, standard deviation"), degrees(v.sdError_deg, locale), degrees(v.sdErrorTrue_deg, locale), degrees(FingertipPublished::kSdError_deg, locale)});
    return table;
}

report::CheckTable platformDegradation(const PlatformCheck& check, const QLocale& locale) {
    report::CheckTable table{Words::tr("When one thing gets worse"),
                             {{Words::tr("What"), Words::tr("How much"), Words::tr("Force error"), Words::tr("Orientation error"), Words::tr("Better than published")}}};
    for (const mechanisms::FingertipDegradation& row : check.worse)
        table.lines.push_back({plantPart(row.what), factorText(row, locale), newtons(row.rmse_N, locale), degrees(row.meanError_deg, locale),
                               row.holds ? Words::tr("yes") : Words::tr("no")});
    return table;
}

} // namespace chiron::desktop
