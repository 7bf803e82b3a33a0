// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/platform_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

using mechanisms::FingertipPublished;
// These names are used unqualified below, because lupdate assigns the texts of a function with a qualified
// type to another context.
using report::CheckTable;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PlatformCheck)
};

QString newtons(double value, const QLocale& locale) {
    return Words::tr("%1 N").arg(locale.toString(value, 'f', 4));
}

QString shortNewtons(double value, const QLocale& locale) {
    return Words::tr("%1 N").arg(locale.toString(value, 'f', 2));
}

QString degrees(double value, const QLocale& locale) {
    return Words::tr("%1°").arg(locale.toString(value, 'f', 2));
}

QString plantPart(const std::string& what) {
    if (what == "force_noise")
        return Words::tr("Noise, hysteresis and creep of the force sensors");
    if (what == "adc")
        return Words::tr("Resolution of the converter");
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

QString fingerName(const std::string& finger) {
    if (finger == "half")
        return Words::tr("Half as stiff");
    if (finger == "double")
        return Words::tr("Twice as stiff");
    if (finger == "thick")
        return Words::tr("Thick");
    if (finger == "thin")
        return Words::tr("Thin");
    if (finger == "relaxing")
        return Words::tr("Its force relaxes by 40 %");
    if (finger == "softest")
        return Words::tr("Half as stiff, thick, relaxing");
    if (finger == "stiffest")
        return Words::tr("Twice as stiff, thin, relaxing");
    return Words::tr("The assumed finger");
}

QString factorText(const mechanisms::FingertipDegradation& row, const QLocale& locale) {
    if (row.what == "adc")
        return row.factor == 0.0 ? Words::tr("16 bits")
                                 : Words::tr("%1 times as coarse").arg(locale.toString(row.factor, 'g', 3));
    return row.factor == 0.0 ? Words::tr("none") : Words::tr("× %1").arg(locale.toString(row.factor, 'g', 3));
}

} // namespace

QString platformVerdict(const PlatformCheck& check, const QLocale& locale) {
    using mechanisms::FingertipBounds;
    const auto& v = check.verified;
    const QString bounds = Words::tr("bounds: %1, %2, %3 %, %4")
                               .arg(newtons(FingertipPublished::kMeanRmse_N, locale),
                                    degrees(FingertipPublished::kMeanError_deg, locale),
                                    locale.toString(100.0 * FingertipBounds::kOvershootOfForce, 'f', 0),
                                    shortNewtons(FingertipBounds::kLimit_N, locale));
    double force = v.meanRmseTrue_N, angle = v.meanErrorTrue_deg, overshoot = v.overshootOfForce,
           most = v.largest_N;
    int held = v.holds() ? 1 : 0;
    for (const mechanisms::FingertipOnFinger& on : check.fingers) {
        force = std::max(force, on.verified.meanRmseTrue_N);
        angle = std::max(angle, on.verified.meanErrorTrue_deg);
        overshoot = std::max(overshoot, on.verified.overshootOfForce);
        most = std::max(most, on.verified.largest_N);
        held += on.verified.holds() ? 1 : 0;
    }
    const int fingers = 1 + static_cast<int>(check.fingers.size());
    return Words::tr("A simulation: the simulated platform stays within its bounds on %1 of %2 simulated "
                     "fingers. At worst, the force on "
                     "the fingertip is off by %3 (root mean square), the orientation by %4, a step "
                     "overshoots by %5 % of the force, and "
                     "the fingertip gets at most %6 (%7). A real platform has to be measured separately.")
        .arg(locale.toString(held), locale.toString(fingers), newtons(force, locale), degrees(angle, locale),
             locale.toString(100.0 * overshoot, 'f', 1), shortNewtons(most, locale), bounds);
}

QStringList platformFacts(const PlatformCheck& check, const QLocale& locale) {
    const auto& p = check.plant;
    const auto number = [&locale](double value, int decimals = 1) {
        return locale.toString(value, 'f', decimals);
    };
    return {Words::tr("This is the simulated platform, with hardware as imperfect as real parts are: force "
                      "noise of %1 mN and %2 bits of "
                      "the converter, hysteresis of %3 %, a delay of %4 ms from sensor to controller, gear "
                      "friction of %5 N per drive, "
                      "backlash of %6 µm, an orientation sensor with %7° bias and %8° noise.")
                .arg(number(1e3 * p.force.noise_N), locale.toString(p.force.adcBits),
                     number(100.0 * p.force.hysteresis, 0), locale.toString(p.force.delay_ticks),
                     number(p.drive.friction.coulomb, 2), number(1e6 * p.drive.backlash_m, 0),
                     number(p.imu.bias_rad * 57.29577951308232), number(p.imu.noise_rad * 57.29577951308232)),
            Words::tr("Friction, identified by moving the drives: %1 N, plus %2 N·s/m with speed.")
                .arg(number(check.friction.coulomb_N, 3), number(check.friction.viscous_Ns_per_m, 2)),
            Words::tr("A step of force is felt after %1 ms. With the damping of drives and fingertip alone, "
                      "a wall is stable up to %2 N/mm.")
                .arg(number(1e3 * check.verified.latency_s), number(1e-3 * check.stiffnessCap_N_per_m, 2))};
}

CheckTable platformFigures(const PlatformCheck& check, const QLocale& locale) {
    const auto& v = check.verified;
    CheckTable table{Words::tr("Compared with the published figures"),
                     {{Words::tr("Figure"), Words::tr("By its own sensors"), Words::tr("True value"),
                       Words::tr("Published (P3)")}}};
    for (std::size_t i = 0; i < v.rmse_N.size(); ++i)
        table.lines.push_back({Words::tr("Force, cycle %1: root mean square error")
                                   .arg(locale.toString(static_cast<int>(i) + 1)),
                               newtons(v.rmse_N[i], locale), newtons(v.rmseTrue_N[i], locale),
                               newtons(FingertipPublished::kRmse_N[i], locale)});
    table.lines.push_back({Words::tr("Force, mean of the cycles"), newtons(v.meanRmse_N, locale),
                           newtons(v.meanRmseTrue_N, locale),
                           newtons(FingertipPublished::kMeanRmse_N, locale)});
    table.lines.push_back({Words::tr("Orientation, mean error of %1 poses")
                               .arg(locale.toString(static_cast<int>(v.poses.size()))),
                           degrees(v.meanError_deg, locale), degrees(v.meanErrorTrue_deg, locale),
                           degrees(FingertipPublished::kMeanError_deg, locale)});
    table.lines.push_back({Words::tr("Orientation, standard deviation"), degrees(v.sdError_deg, locale),
                           degrees(v.sdErrorTrue_deg, locale),
                           degrees(FingertipPublished::kSdError_deg, locale)});
    return table;
}

CheckTable platformFingers(const PlatformCheck& check, const QLocale& locale) {
    CheckTable table{Words::tr("On other fingers: the true force on the fingertip"),
                     {{Words::tr("Simulated finger"), Words::tr("Force error"), Words::tr("Gain, phase"),
                       Words::tr("Overshoot"), Words::tr("Max. at 1 N"), Words::tr("Max. at 4 N"),
                       Words::tr("Within its bounds")}}};
    const auto add = [&](const std::string& name, const mechanisms::FingertipVerification& v) {
        table.lines.push_back(
            {fingerName(name), newtons(v.meanRmseTrue_N, locale),
             Words::tr("%1, %2°").arg(locale.toString(v.gain, 'f', 3), locale.toString(v.phase_deg, 'f', 1)),
             Words::tr("%1 %").arg(locale.toString(100.0 * v.overshootOfForce, 'f', 1)),
             shortNewtons(v.oneNewton_N, locale), shortNewtons(v.largest_N, locale),
             v.holds() ? Words::tr("yes") : Words::tr("no")});
    };
    add({}, check.verified);
    for (const mechanisms::FingertipOnFinger& on : check.fingers)
        add(on.finger, on.verified);
    return table;
}

CheckTable platformDegradation(const PlatformCheck& check, const QLocale& locale) {
    CheckTable table{Words::tr("When one part gets worse"),
                     {{Words::tr("What"), Words::tr("How much"), Words::tr("Force error"),
                       Words::tr("Orientation error"), Words::tr("Within its bounds")}}};
    for (const mechanisms::FingertipDegradation& row : check.worse)
        table.lines.push_back({plantPart(row.what), factorText(row, locale), newtons(row.rmse_N, locale),
                               degrees(row.meanError_deg, locale),
                               row.holds ? Words::tr("yes") : Words::tr("no")});
    return table;
}

} // namespace chiron::desktop
