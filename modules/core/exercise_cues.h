// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>
#include <typeinfo>

namespace chiron::core {

/// What an exercise shows beside what all exercises show: one value of its own type, at a fixed place, so that it passes the force loop
/// as bytes. Its scene writes it; its operators and screens, which know the type, read it; all others pass it on.
class ExerciseCues {
public:
    static constexpr std::size_t kSize = 1024; ///< bytes that a type may have

    /// As a scene of that type showed it; where it showed another or nothing, the type's default.
    template <class Own> const Own& of() const noexcept {
        check<Own>();
        static constexpr Own kNothing{};
        return holds<Own>() ? *std::launder(reinterpret_cast<const Own*>(m_bytes.data())) : kNothing;
    }
    /// The same to be written; a value of another type makes room for a default one.
    template <class Own> Own& own() noexcept {
        check<Own>();
        if (holds<Own>())
            return *std::launder(reinterpret_cast<Own*>(m_bytes.data()));
        m_type = &typeid(Own);
        return *::new (static_cast<void*>(m_bytes.data())) Own{};
    }
    template <class Own> bool holds() const noexcept { return m_type && *m_type == typeid(Own); }

private:
    template <class Own> static constexpr void check() {
        static_assert(std::is_trivially_copyable_v<Own> && sizeof(Own) <= kSize && alignof(Own) <= alignof(std::max_align_t));
    }

    alignas(std::max_align_t) std::array<std::byte, kSize> m_bytes{};
    const std::type_info* m_type = nullptr;
};

static_assert(std::is_trivially_copyable_v<ExerciseCues>);

} // namespace chiron::core
