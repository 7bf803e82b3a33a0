// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <type_traits>
#include <typeinfo>

namespace chiron::core {

/// The cues that only one exercise shows, in addition to those that every exercise has. They are one value of
/// the exercise's own type, stored in place, so that they pass through the force loop as plain bytes. The
/// exercise's scene writes the value; its operators and screens, which know the type, read it; all other code
/// only passes it on.
class ExerciseCues {
public:
    static constexpr std::size_t kSize = 1024; ///< largest size of an exercise's type, bytes

    /// Returns the value if it has the type `Own`; otherwise (another type or no value) a default-constructed
    /// `Own`.
    template <class Own> const Own& of() const noexcept {
        check<Own>();
        static constexpr Own kNothing{};
        return holds<Own>() ? *std::launder(reinterpret_cast<const Own*>(m_bytes.data())) : kNothing;
    }
    /// Returns the value for writing. If it has another type, a default-constructed `Own` replaces it first.
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
        static_assert(std::is_trivially_copyable_v<Own> && sizeof(Own) <= kSize &&
                      alignof(Own) <= alignof(std::max_align_t));
    }

    alignas(std::max_align_t) std::array<std::byte, kSize> m_bytes{};
    const std::type_info* m_type = nullptr;
};

static_assert(std::is_trivially_copyable_v<ExerciseCues>);

} // namespace chiron::core
