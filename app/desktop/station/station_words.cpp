// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/station_words.h"

#include <algorithm>
#include <limits>
#include <string>

namespace chiron::desktop {

namespace {
constexpr double kMostLate = 0.003; // speed.md: share of all ticks that may be more than 100 µs late
} // namespace

double StationWords::lateShare(const session::LoopReport& loop) {
    return loop.ticks > 0 ? static_cast<double>(loop.late) / static_cast<double>(loop.ticks) : 0.0;
}

double StationWords::mostLate() noexcept {
    return kMostLate;
}

QString StationWords::text(std::string_view marked) {
    return marked.empty() ? QString() : QCoreApplication::translate("Drivers", std::string(marked).c_str());
}

QString StationWords::driver(const devices::Driver& entry) {
    return text(entry.name.empty() ? entry.title : entry.name);
}

QString StationWords::device(const devices::Driver& entry, std::string_view kinematics) {
    return text(devices::nameOf(entry, kinematics));
}

QString StationWords::needs(const devices::Driver& entry) {
    return text(entry.readiness.empty() ? entry.needs : entry.readiness);
}

QString StationWords::forceClass(devices::DeviceClass deviceClass) {
    return deviceClass == devices::DeviceClass::felt ? tr("Force is felt") : tr("Force is shown, not felt");
}

QString StationWords::priority(bool granted) {
    return granted ? tr("The force loop has real-time priority.")
                   : tr("The force loop has no real-time priority: under load, touch may "
                        "feel rough.");
}

QString StationWords::howToGetPriority() {
    return tr("To permit it, the administrator of this computer adds two lines to a file in "
              "/etc/security/limits.d, where \"group\" is the "
              "group of those who train: \"@group - rtprio 80\" and \"@group - memlock unlimited\". It takes "
              "effect at the next login to "
              "the computer.");
}

QString StationWords::memory(bool locked) {
    return locked ? tr("Memory is locked: nothing the loop needs can be swapped out.")
                  : tr("Memory is not locked: when it runs short, the loop may have to wait for the disk.");
}

QString StationWords::punctuality(const session::LoopReport& loop, const QLocale& locale) {
    const auto number = [&locale](const std::optional<double>& value_us) {
        return value_us ? locale.toString(*value_us, 'f', 1) : QStringLiteral("–");
    };
    return tr("%1 ticks of 1 ms. Half of them started within %2 µs, 99 of 100 within %3 µs, the latest after "
              "%4 µs. %5 were more than 100 "
              "µs late, %6 were skipped.")
        .arg(locale.toString(static_cast<qulonglong>(loop.ticks)), number(loop.p50_us), number(loop.p99_us),
             number(loop.max_us), locale.toString(static_cast<qulonglong>(loop.late)),
             locale.toString(static_cast<qulonglong>(loop.skipped)));
}

const char* StationWords::verdictKind(const session::LoopReport& loop) {
    return lateShare(loop) <= kMostLate && loop.skipped == 0 ? "good" : "warning";
}

QString StationWords::verdict(const session::LoopReport& loop, const QLocale& locale) {
    const auto percent = [&locale](double share) {
        return locale.toString(100.0 * share, 'f', share > 0.0 && share < 0.001 ? 3 : 1);
    };
    const QString measured = percent(lateShare(loop));
    const QString limit = percent(kMostLate);
    if (loop.skipped > 0) // in each skipped tick the device was not served for one millisecond
        return tr("The loop does not run on time: %n tick(s) were skipped. Close other programs, or permit "
                  "real-time priority.",
                  nullptr,
                  static_cast<int>(std::min<std::uint64_t>(loop.skipped, std::numeric_limits<int>::max())));
    return QLatin1String(verdictKind(loop)) == QLatin1String("good")
               ? tr("The loop runs on time: %1 % of the ticks were late (limit %2 %), and none was skipped.")
                     .arg(measured, limit)
               : tr("The loop does not run on time: %1 % of the ticks were late (limit %2 %). Close other "
                    "programs, or permit real-time "
                    "priority.")
                     .arg(measured, limit);
}

} // namespace chiron::desktop
