// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <type_traits>
#include <utility>

namespace chiron::core {

/// The parameters of one level of an exercise: a value of that exercise's own type. Code that knows the type
/// reads it; all other code only passes it on.
class ExerciseParameters {
public:
    ExerciseParameters() = default; ///< belongs to no exercise
    template <class Own>
        requires(!std::is_same_v<std::remove_cvref_t<Own>, ExerciseParameters>)
    explicit ExerciseParameters(Own&& value) : m_value(std::forward<Own>(value)) {}
    template <class Own>
        requires(!std::is_same_v<std::remove_cvref_t<Own>, ExerciseParameters>)
    ExerciseParameters& operator=(Own&& value) {
        m_value = std::forward<Own>(value);
        return *this;
    }

    /// Returns null if the parameters have another type.
    template <class Own> const Own* find() const noexcept { return std::any_cast<Own>(&m_value); }
    template <class Own> Own* find() noexcept { return std::any_cast<Own>(&m_value); }
    /// For code that knows the type. Throws std::bad_any_cast if the parameters have another type.
    template <class Own> const Own& as() const { return std::any_cast<const Own&>(m_value); }
    template <class Own> Own& as() { return std::any_cast<Own&>(m_value); }

private:
    std::any m_value;
};

} // namespace chiron::core
