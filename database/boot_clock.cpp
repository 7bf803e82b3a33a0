// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/boot_clock.h"

#include <QFile>
#include <ctime>

namespace chiron::database {

BootTime SystemBootClock::now() const {
    BootTime time;
    QFile file(QStringLiteral("/proc/sys/kernel/random/boot_id"));
    if (file.open(QIODevice::ReadOnly)) {
        time.bootId = file.readAll().trimmed().toStdString();
    }
    timespec spec{};
    clock_gettime(CLOCK_BOOTTIME, &spec);
    time.now_ns = static_cast<std::int64_t>(spec.tv_sec) * 1'000'000'000 + spec.tv_nsec;
    return time;
}

} // namespace chiron::database
