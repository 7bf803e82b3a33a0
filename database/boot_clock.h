// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace chiron::database {

/// Time that nobody can set back: nanoseconds since this boot (CLOCK_BOOTTIME, suspend included) and which
/// boot it is.
struct BootTime {
    std::string bootId;
    std::int64_t now_ns = 0;
};

/// Where the throttle takes its time from; replaced in tests.
class IBootClock {
public:
    virtual ~IBootClock() = default;
    virtual BootTime now() const = 0;
};

/// The kernel's clock; /proc/sys/kernel/random/boot_id names the boot.
class SystemBootClock final : public IBootClock {
public:
    BootTime now() const override;
};

} // namespace chiron::database
