// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <string>

namespace chiron::database {

inline constexpr int kMinimumPasswordCharacters = 10;
inline constexpr int kMaximumPasswordBytes = 1024;
inline constexpr int kMinimumDifferentCharacters = 4;
inline constexpr int kMaximumNameCharacters = 64;
inline constexpr int kMaximumDisplayNameCharacters = 200;

/// The result of each password rule, for a form that reports while a person types.
struct PasswordCheck {
    bool longEnough = false; ///< kMinimumPasswordCharacters
    bool varied = false;     ///< kMinimumDifferentCharacters
    bool notTheName = false;
    bool storable = false; ///< valid UTF-8 of at most kMaximumPasswordBytes
    bool ok() const noexcept { return longEnough && varied && notTheName && storable; }
};
PasswordCheck examinePassword(const std::string& name, const std::string& password);

/// Checks the password rules and states all of them in the error: at least 10 characters, at most 1024 bytes,
/// valid UTF-8, not the login name, at least 4 different characters. There is no rule about types of
/// characters (NIST SP 800-63B §5.1.1.2).
/// Errors: badInput.
core::Result<void> checkPassword(const std::string& name, const std::string& password);

/// Checks a login name: 1..64 characters, valid UTF-8, no control characters, no leading or trailing space,
/// not "simulated", no comma. Anything else is allowed: names are bound, never pasted into SQL.
core::Result<void> checkName(const std::string& name);

/// Checks login name and display name.
core::Result<void> checkNames(const std::string& name, const std::string& displayName);

/// Checks free text: valid UTF-8 without NUL, at most the given number of characters.
core::Result<void> checkText(const std::string& field, const std::string& text, int maximumCharacters);

/// Returns the form in which two login names count as the same: NFKC, case folded.
std::string nameKey(const std::string& name);

} // namespace chiron::database
