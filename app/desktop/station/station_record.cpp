// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/station_record.h"

#include "desktop/station/station_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

using mechanisms::FingertipBounds;
using mechanisms::FingertipPublished;
using report::CheckRecord; // unqualified, as in platform_words.cpp
using report::CheckTable;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StationRecord)
};

QString passed(bool good) {
    return good ? Words::tr("pass") : Words::tr("FAIL");
}

CheckTable limitsTable() {
    return {Words::tr("Measured values and their limits"),
            {{Words::tr("Quantity"), Words::tr("Measured"), Words::tr("Limit"), Words::tr("Result")}}};
}

} // namespace

QString serialWords(const std::optional<QString>& serial) {
    return !serial             ? Words::tr("none")
           : serial->isEmpty() ? Words::tr("not reported by the device")
                               : *serial;
}

std::vector<std::pair<QString, QString>> checkHead(const CheckCircumstances& of, const QLocale& locale) {
    std::vector<std::pair<QString, QString>> head{
        {Words::tr("Checked by"), of.who},
        {Words::tr("Date and time"), locale.toString(of.when, QLocale::LongFormat)},
        {Words::tr("Station"), of.station},
        {Words::tr("Device"), of.device},
        {Words::tr("Serial number"), serialWords(of.serial)},
        {Words::tr("Program build"), of.build},
        {Words::tr("Entry in the audit trail"),
         of.entry > 0 ? locale.toString(static_cast<qlonglong>(of.entry)) : Words::tr("not written")}};
    if (!of.site.isEmpty())
        head.insert(head.begin(), {Words::tr("Site"), of.site});
    return head;
}

QString checkFoot(const CheckCircumstances& of, const QLocale& locale) {
    return Words::tr("%1, %2, %3").arg(of.station, locale.toString(of.when, QLocale::ShortFormat), of.who);
}

bool loopHolds(const session::SelfTestResult& result) {
    return !result.cancelled &&
           QLatin1String(StationWords::verdictKind(result.loop)) == QLatin1String("good");
}

CheckTable loopLimits(const session::SelfTestResult& result, const QLocale& locale) {
    const session::LoopReport& loop = result.loop;
    CheckTable table = limitsTable();
    const double share = StationWords::lateShare(loop);
    const auto percent = [&](double value) {
        return Words::tr("%1 %").arg(locale.toString(100.0 * value, 'f', 3));
    };
    const auto micro = [&](const std::optional<double>& value_us) {
        return value_us ? Words::tr("%1 µs").arg(locale.toString(*value_us, 'f', 1))
                        : Words::tr("not measured");
    };
    const QString told = Words::tr("no limit");
    table.lines.push_back({Words::tr("Ticks more than 100 µs late, of %1")
                               .arg(locale.toString(static_cast<qulonglong>(loop.ticks))),
                           percent(share), Words::tr("at most %1").arg(percent(StationWords::mostLate())),
                           passed(share <= StationWords::mostLate())});
    table.lines.push_back({Words::tr("Ticks skipped"), locale.toString(static_cast<qulonglong>(loop.skipped)),
                           locale.toString(0), passed(loop.skipped == 0)});
    table.lines.push_back(
        {Words::tr("Lateness, half of the ticks"), micro(loop.p50_us), told, QStringLiteral("–")});
    table.lines.push_back(
        {Words::tr("Lateness, 99 of 100 ticks"), micro(loop.p99_us), told, QStringLiteral("–")});
    table.lines.push_back(
        {Words::tr("Lateness, the latest tick"), micro(loop.max_us), told, QStringLiteral("–")});
    const auto yes = [](bool on) { return on ? Words::tr("yes") : Words::tr("no"); };
    table.lines.push_back({Words::tr("Real-time priority"), yes(loop.priorityGranted),
                           Words::tr("recommended"), QStringLiteral("–")});
    table.lines.push_back({Words::tr("Memory locked"), yes(result.granted.memoryLocked),
                           Words::tr("recommended"), QStringLiteral("–")});
    return table;
}

CheckTable platformLimits(const PlatformCheck& check, const QLocale& locale) {
    std::vector<const mechanisms::FingertipVerification*> all{&check.verified};
    for (const mechanisms::FingertipOnFinger& on : check.fingers)
        all.push_back(&on.verified);
    const auto worst = [&](double mechanisms::FingertipVerification::*member) {
        double most = 0.0;
        for (const mechanisms::FingertipVerification* each : all)
            most = std::max(most, each->*member);
        return most;
    };
    const auto newtons = [&](double value, int decimals) {
        return Words::tr("%1 N").arg(locale.toString(value, 'f', decimals));
    };
    const auto degrees = [&](double value) { return Words::tr("%1°").arg(locale.toString(value, 'f', 2)); };
    const auto percent = [&](double value) {
        return Words::tr("%1 %").arg(locale.toString(100.0 * value, 'f', 1));
    };
    CheckTable table = limitsTable();
    table.title = Words::tr("Measured values and their limits, the worst of %n finger(s)", nullptr,
                            static_cast<int>(all.size()));
    const auto add = [&](const QString& what, double measured, double limit, const auto& shown, bool below) {
        table.lines.push_back(
            {what, shown(measured),
             below ? Words::tr("below %1").arg(shown(limit)) : Words::tr("at most %1").arg(shown(limit)),
             passed(below ? measured < limit : measured <= limit)});
    };
    using V = mechanisms::FingertipVerification;
    const auto fine = [&](double value) { return newtons(value, 4); };
    const auto coarse = [&](double value) { return newtons(value, 2); };
    add(Words::tr("Force error by the platform's own sensors (root mean square)"), worst(&V::meanRmse_N),
        FingertipPublished::kMeanRmse_N, fine, true);
    add(Words::tr("Force error on the finger pad (root mean square)"), worst(&V::meanRmseTrue_N),
        FingertipPublished::kMeanRmse_N, fine, true);
    add(Words::tr("Orientation error by the platform's own sensor"), worst(&V::meanError_deg),
        FingertipPublished::kMeanError_deg, degrees, true);
    add(Words::tr("Orientation error, true"), worst(&V::meanErrorTrue_deg),
        FingertipPublished::kMeanError_deg, degrees, true);
    add(Words::tr("Overshoot of a step of force"), worst(&V::overshootOfForce),
        FingertipBounds::kOvershootOfForce, percent, false);
    add(Words::tr("Largest force on the finger pad"), worst(&V::largest_N), FingertipBounds::kLimit_N, coarse,
        false);
    return table;
}

CheckRecord loopRecord(const session::SelfTestResult& result, const CheckCircumstances& of,
                       const QLocale& locale) {
    CheckRecord record;
    record.title = Words::tr("Station check: timing of the force loop");
    record.head = checkHead(of, locale);
    record.foot = checkFoot(of, locale);
    record.verdict = loopHolds(result)
                         ? Words::tr("Passed. %1").arg(StationWords::verdict(result.loop, locale))
                         : Words::tr("Failed. %1").arg(StationWords::verdict(result.loop, locale));
    record.facts = {StationWords::punctuality(result.loop, locale),
                    StationWords::priority(result.loop.priorityGranted),
                    StationWords::memory(result.granted.memoryLocked)};
    record.tables = {loopLimits(result, locale)};
    return record;
}

} // namespace chiron::desktop
