// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace chiron::database {

/// A time that nobody can set back: nanoseconds since this boot (CLOCK_BOOTTIME, suspend included), and the
/// id of the boot.
struct BootTime {
    std::string bootId;
    std::int64_t now_ns = 0;
};

/// The source of time for the throttle; replaced in tests.
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
