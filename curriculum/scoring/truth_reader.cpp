// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/truth_reader.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace chiron::scoring {

namespace {

/// The shortest text that gives the same number.
std::string textOf(double value) {
    std::array<char, 32> text{};
    const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::string(text.data(), end) : std::string("?");
}

std::string wholeNumber(int least, int most) {
    return "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
}

bool isWithin(double value, int least, int most) {
    return value >= least && value <= most;
}

} // namespace

std::optional<double> TruthReader::optional(std::string_view id) const {
    for (const NamedValue& value : m_truth)
        if (value.id == id && std::isfinite(value.value))
            return value.value;
    return std::nullopt;
}

std::optional<int> TruthReader::optionalCount(std::string_view id, int least, int most) {
    const std::optional<double> found = optional(id);
    if (!found)
        return std::nullopt;
    const double rounded = std::round(*found);
    if (isWithin(rounded, least, most))
        return static_cast<int>(rounded);
    fault(id, found, wholeNumber(least, most));
    return std::nullopt;
}

double TruthReader::number(std::string_view id) {
    const std::optional<double> found = optional(id);
    if (!found)
        fault(id, found, "a number");
    return found.value_or(0.0);
}

double TruthReader::atLeast(double least, std::string_view id) {
    const std::optional<double> found = optional(id);
    if (!found || *found < least)
        fault(id, found, "a number of " + textOf(least) + " or more");
    return found.value_or(0.0);
}

int TruthReader::count(std::string_view id, int least, int most) {
    const std::optional<double> found = optional(id);
    const double rounded = std::round(found.value_or(0.0));
    if (found && isWithin(rounded, least, most))
        return static_cast<int>(rounded);
    fault(id, found, wholeNumber(least, most));
    return least;
}

core::Result<void> TruthReader::done() const {
    if (m_fault)
        return tl::unexpected(*m_fault);
    return {};
}

void TruthReader::fault(std::string_view id, std::optional<double> found, const std::string& expected) {
    if (!m_fault)
        m_fault =
            core::Error{core::ErrorCode::badInput, "truth \"" + std::string(id) + "\": found " +
                                                       (found ? textOf(*found) : std::string("nothing")) +
                                                       ", expected " + expected};
}

void addRecorded(std::vector<NamedValue>& truth, std::string_view id, std::optional<double> value) {
    if (value)
        truth.push_back({std::string(id), *value});
}

} // namespace chiron::scoring
