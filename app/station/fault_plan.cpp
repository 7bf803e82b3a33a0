// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/fault_plan.h"

#include <array>
#include <charconv>
#include <optional>

namespace chiron::station {

namespace {

struct Kind {
    std::string_view name;
    FaultKind kind;
    double usual;
    double most;
};
constexpr std::array kKinds{
    Kind{"delay", FaultKind::delay, 5.0, 1000.0},
    Kind{"jitter", FaultKind::jitter, 5.0, 1000.0},
    Kind{"drop", FaultKind::drop, 0.1, 1.0},
    Kind{"duplicate", FaultKind::duplicate, 0.1, 1.0},
    Kind{"reorder", FaultKind::reorder, 0.1, 1.0},
    Kind{"corrupt", FaultKind::corrupt, 0.1, 1.0},
    Kind{"freeze", FaultKind::freeze, 100.0, 60'000.0},
    Kind{"unplug", FaultKind::unplug, 1000.0, 60'000.0},
    Kind{"saturate", FaultKind::saturate, 0.2, 1.0},
    Kind{"drift", FaultKind::drift, 1000.0, 1e9},
};

/// Reads all of `text` as a number.
std::optional<double> numberIn(std::string_view text) {
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    return error == std::errc() && stopped == end ? std::optional(value) : std::nullopt;
}

} // namespace

std::string faultKinds() {
    std::string all;
    for (const Kind& kind : kKinds)
        all += (all.empty() ? "" : ", ") + std::string(kind.name);
    return all;
}

core::Result<FaultPlan> readFaultPlan(std::string_view text) {
    const auto refuse = [text](const std::string& why) {
        return core::fail(core::ErrorCode::badInput, "--fault " + std::string(text) + ": " + why);
    };
    const std::size_t first = text.find(':');
    const std::string_view name = text.substr(0, first);
    FaultPlan plan;
    const Kind* found = nullptr;
    for (const Kind& kind : kKinds)
        if (kind.name == name)
            found = &kind;
    if (found == nullptr)
        return refuse("expected KIND[:WHEN[:AMOUNT]], and as KIND one of " + faultKinds());
    plan.kind = found->kind;
    plan.amount = found->usual;
    if (first == std::string_view::npos)
        return plan;
    const std::string_view rest = text.substr(first + 1);
    const std::size_t second = rest.find(':');
    const auto when = numberIn(rest.substr(0, second));
    if (!when || !(*when >= 0.0 && *when <= 86'400.0))
        return refuse("WHEN is a time in seconds, 0 to 86400");
    plan.when_s = *when;
    if (second == std::string_view::npos)
        return plan;
    const auto amount = numberIn(rest.substr(second + 1));
    if (!amount || !(*amount >= 0.0 && *amount <= found->most))
        return refuse("AMOUNT of " + std::string(name) + " is a number from 0 to " +
                      std::to_string(found->most));
    plan.amount = *amount;
    return plan;
}

} // namespace chiron::station
