// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace chiron::psychophysics {

/// P2's attributes, and the apex. Files contain the token.
enum class Attribute : std::uint8_t { stiffness, mass, deformation, roughness, friction, viscosity, apex };
inline constexpr int kAttributes = 7;
std::string_view token(Attribute attribute) noexcept; ///< "stiffness", "mass", "deformation", "roughness",
                                                      ///< "friction", "viscosity", "apex"
std::optional<Attribute> attributeFromToken(std::string_view word) noexcept;
/// Returns the SI unit of the attribute's value: N/m, kg, s (recovery time of deformation), m (rms roughness
/// height), 1, N·s/m, m.
std::string_view unitOf(Attribute attribute) noexcept;

} // namespace chiron::psychophysics
