// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/gimbal_plant.h"

#include <array>
#include <optional>

namespace chiron::mechanisms {

/// Friction of one axis in its own unit: N·m and N·m·s/rad, or N and N·s/m.
struct AxisFriction {
    double coulomb = 0.0;
    double viscous = 0.0;
};

/// How the axes are moved. The values are named assumptions: P2 states only "at low velocities".
struct FrictionSweep {
    /// rad/s; along depth a fifth of it in m/s, so that the tip is about as fast.
    double slow = 0.05;
    double fast = 0.15;       ///< the second speed, which separates viscous from Coulomb friction; > slow
    double halfTravel = 0.10; ///< rad either side of the middle; along depth a fifth of it in m
    /// Share of a sweep that is left out, half at either end, 0..0.9, so that bristles and servo settle.
    double settled = 0.3;
};

/// Identifies the friction of the gimbal's motor axes (heading, pitch, depth; roll has no motor and stays
/// empty) by Tholey's method, which P2 adopts: each axis is moved slowly while the others are held, and the
/// motor's effort at constant speed is what friction takes. Each axis moves forwards and backwards over the
/// same travel at two speeds v₁ < v₂:
///   F(v) = (mean effort forwards − mean effort backwards)/2, in which weight and spring cancel,
///   σ₂ = (F(v₂) − F(v₁))/(v₂ − v₁),  F_c = F(v₁) − σ₂ v₁.
/// The efforts are those requested of the motors beyond the gravity feed-forward; positions and speeds are
/// those that the encoders report. The plant is left at `middle`, at rest. Takes about 35 simulated seconds.
/// Deterministic; not for the tick. Source: P2, plant feed-forward, after Tholey et al. (its reference 11);
/// LuGre without Stribeck effect, devices.md §5.
/// Errors: badInput for a sweep out of range or travel that leaves the axes' limits; doesNotHold if a motor
/// ran at its limit.
core::Result<std::array<std::optional<AxisFriction>, 4>>
identifyFriction(GimbalPlant& plant, const GimbalCoordinates& middle, const FrictionSweep& sweep = {});

} // namespace chiron::mechanisms
