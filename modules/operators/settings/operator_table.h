// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace chiron::operators {

/// The error of a name that no operator has: notFound, listing the names that exist.
inline tl::unexpected<core::Error> unknownOperator(std::string_view name,
                                                   std::span<const std::string_view> names) {
    std::string text = "operator '" + std::string(name) + "' is unknown; expected ";
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0)
            text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return core::fail(core::ErrorCode::notFound, std::move(text));
}

/// The scripted operators of an exercise by name, in the order in which they are offered. `Settings` is the
/// exercise's own struct; its member `name` is filled from here. Static data of the exercise.
/// Thread: any.
template <class Settings, std::size_t N> class OperatorTable {
public:
    struct Line {
        std::string_view name;
        Settings (*settings)();
    };
    constexpr explicit OperatorTable(const Line (&lines)[N]) noexcept {
        for (std::size_t i = 0; i < N; ++i) {
            m_names[i] = lines[i].name;
            m_settings[i] = lines[i].settings;
        }
    }

    constexpr std::span<const std::string_view> names() const noexcept { return m_names; }
    /// Returns the settings of the operator with this name.
    /// Errors: notFound for an unknown name, listing the known ones.
    core::Result<Settings> settings(std::string_view name) const {
        for (std::size_t i = 0; i < N; ++i)
            if (m_names[i] == name) {
                Settings made = m_settings[i]();
                made.name = name;
                return made;
            }
        return unknownOperator(name, m_names);
    }

private:
    std::array<std::string_view, N> m_names{};
    std::array<Settings (*)(), N> m_settings{};
};

} // namespace chiron::operators
