// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/observers/observer_spec.h"

#include "psychophysics/procedures/rank3_quest_plus.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

struct Part {
    std::string_view name;
    double ObserverSpec::*value;
    double lowest, highest;
    std::string_view expected;
    bool always; ///< written even if it has the default value
};

constexpr std::array<Part, 4> kParts{
    {{"weber", &ObserverSpec::weber, 1e-6, 100.0, "a Weber fraction from 0.000001 to 100", true},
     {"lapse", &ObserverSpec::lapse, 0.0, 1.0, "a share from 0 to 1", true},
     {"bias", &ObserverSpec::bias, -100.0, 100.0, "a number of internal noise sd, -100 to 100", true},
     {"ties", &ObserverSpec::ties, 0.0, 100.0, "a number of internal noise sd, 0 to 100", false}}};

constexpr std::string_view kTrainee = "operator:";

core::Result<void> readTrainee(std::string_view name, ObserverSpec& spec) {
    const bool word = !name.empty() && name.size() <= 32 && std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || c == '_';
    });
    if (!word)
        return fail(ErrorCode::badInput,
                    "observer: operator:" + std::string(name) + ": expected the name of a scripted trainee");
    spec.trainee = std::string(name);
    return {};
}

core::Result<void> readPart(std::string_view text, ObserverSpec& spec) {
    if (text.substr(0, kTrainee.size()) == kTrainee)
        return readTrainee(text.substr(kTrainee.size()), spec);
    const std::size_t colon = text.find(':');
    for (const Part& part : kParts) {
        if (colon == std::string_view::npos || text.substr(0, colon) != part.name)
            continue;
        const std::string_view digits = text.substr(colon + 1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size() ||
            !(value >= part.lowest && value <= part.highest))
            return fail(ErrorCode::badInput,
                        "observer: " + std::string(text) + ": expected " + std::string(part.expected));
        spec.*part.value = value;
        return {};
    }
    return fail(ErrorCode::badInput,
                "observer: \"" + std::string(text) +
                    "\": expected weber:W, lapse:L, bias:B, ties:T or operator:NAME, separated by commas");
}

} // namespace

core::Result<ObserverSpec> parseObserver(std::string_view text) {
    ObserverSpec spec;
    std::string_view seen;
    bool known = false; // whether the text says how accurate the observer is
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        CHIRON_TRY(readPart(rest.substr(0, comma), spec));
        seen = rest.substr(0, rest.find(':'));
        known = known || seen == "weber" || !spec.trainee.empty();
        if (comma == std::string_view::npos && !known)
            return fail(ErrorCode::badInput, "observer: " + std::string(text) +
                                                 ": how well it feels is missing; expected weber:W");
        if (comma == std::string_view::npos)
            return spec;
        rest = rest.substr(comma + 1);
        if (("," + std::string(rest)).find("," + std::string(seen) + ":") != std::string::npos)
            return fail(ErrorCode::badInput, "observer: " + std::string(seen) + " is given twice");
    }
}

std::string observerText(const ObserverSpec& spec) {
    std::string text;
    for (const Part& part : kParts) {
        if (!part.always && spec.*part.value == ObserverSpec{}.*part.value)
            continue;
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), spec.*part.value).ptr;
        text += (text.empty() ? "" : ",") + std::string(part.name) + ":" + std::string(digits.data(), end);
    }
    if (!spec.trainee.empty())
        text += "," + std::string(kTrainee) + spec.trainee;
    return text;
}

double sigmaOf(const ObserverSpec& spec) {
    return std::log10(1.0 + spec.weber) / kJndPerSigma;
}

} // namespace chiron::psychophysics
