// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/undefined_reason.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace chiron::scoring {

namespace {

/// Returns the counts in `stored` if it matches the pattern with a number for each "#".
std::optional<std::array<int, 3>> matched(std::string_view pattern, std::string_view stored) {
    std::array<int, 3> counts{};
    std::size_t count = 0;
    for (const char wanted : pattern) {
        if (wanted != '#') {
            if (stored.empty() || stored.front() != wanted)
                return std::nullopt;
            stored.remove_prefix(1);
            continue;
        }
        const auto [end, error] =
            std::from_chars(stored.data(), stored.data() + stored.size(), counts[count++]);
        if (error != std::errc{} || counts[count - 1] < 0)
            return std::nullopt;
        stored.remove_prefix(static_cast<std::size_t>(end - stored.data()));
    }
    return stored.empty() ? std::optional(counts) : std::nullopt;
}

} // namespace

std::size_t countsOf(const UndefinedReason& reason) noexcept {
    return static_cast<std::size_t>(std::count(reason.stored.begin(), reason.stored.end(), '#'));
}

std::string storedText(const Undefined& undefined) {
    std::string text;
    std::size_t count = 0;
    for (const char c : undefined.reason.stored) {
        if (c == '#')
            text += std::to_string(undefined.counts[count++]);
        else
            text += c;
    }
    return text;
}

std::optional<Undefined> undefinedOf(std::string_view stored) {
    for (const UndefinedReason& reason : undefinedReasons())
        if (const auto counts = matched(reason.stored, stored))
            return Undefined{reason, *counts};
    return std::nullopt;
}

} // namespace chiron::scoring
