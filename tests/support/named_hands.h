// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/hand_parameters.h"

#include <optional>
#include <string>
#include <vector>

namespace chiron::tests {

/// The three hands of models.md §4 by name.
inline std::vector<std::string> namedHands() {
    return {"usual", "light", "firm"};
}
/// Nothing for another name.
inline std::optional<mechanisms::HandParameters> handNamed(const std::string& name) {
    if (name == "usual")
        return mechanisms::HandParameters{};
    if (name == "light")
        return mechanisms::HandParameters::light();
    if (name == "firm")
        return mechanisms::HandParameters::firm();
    return std::nullopt;
}

} // namespace chiron::tests
