// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/study/attribute.h"

#include <array>

namespace chiron::psychophysics {

namespace {

struct Row {
    Attribute attribute;
    std::string_view token;
    std::string_view unit;
};

constexpr std::array<Row, kAttributes> kRows{{
    {Attribute::stiffness, "stiffness", "N/m"},
    {Attribute::mass, "mass", "kg"},
    {Attribute::deformation, "deformation", "s"},
    {Attribute::roughness, "roughness", "m"},
    {Attribute::friction, "friction", "1"},
    {Attribute::viscosity, "viscosity", "N·s/m"},
    {Attribute::apex, "apex", "m"},
}};

const Row& attributeRow(Attribute attribute) noexcept {
    return kRows[static_cast<std::size_t>(attribute)];
}

} // namespace

std::string_view token(Attribute attribute) noexcept {
    return attributeRow(attribute).token;
}

std::string_view unitOf(Attribute attribute) noexcept {
    return attributeRow(attribute).unit;
}

std::optional<Attribute> attributeFromToken(std::string_view word) noexcept {
    for (const Row& row : kRows)
        if (row.token == word)
            return row.attribute;
    return std::nullopt;
}

} // namespace chiron::psychophysics
