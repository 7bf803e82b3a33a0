// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clock.h"

#include <array>
#include <ctime>

namespace chiron::core {

std::int64_t monotonicNow_ns() noexcept {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

std::string utcNowIso8601() {
    timespec t{};
    clock_gettime(CLOCK_REALTIME, &t);
    std::tm utc{};
    gmtime_r(&t.tv_sec, &utc);
    std::array<char, 32> date{};
    std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &utc);
    std::string text = date.data();
    const std::string millis = std::to_string(1000 + t.tv_nsec / 1'000'000);
    text += "." + millis.substr(1) + "Z";
    return text;
}

} // namespace chiron::core
