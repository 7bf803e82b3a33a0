// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_types.h"

#include <utility>

namespace chiron::database {
namespace {
constexpr std::array<std::pair<SessionState, std::string_view>, 7> kStates{{
    {SessionState::running, "running"},
    {SessionState::completed, "completed"},
    {SessionState::stopped, "stopped"},
    {SessionState::interrupted, "interrupted"},
    {SessionState::incomplete, "incomplete"},
    {SessionState::faulted, "faulted"},
    {SessionState::voided, "voided"},
}};
} // namespace

std::string_view token(SessionState state) noexcept {
    for (const auto& [value, word] : kStates) {
        if (value == state) {
            return word;
        }
    }
    return {};
}

std::optional<SessionState> sessionStateFromToken(std::string_view word) noexcept {
    for (const auto& [value, text] : kStates) {
        if (text == word) {
            return value;
        }
    }
    return std::nullopt;
}

} // namespace chiron::database
