// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>

namespace chiron::core {

inline constexpr int kMaxTools = 4;       ///< instruments at once (P2: two hands, a third and a fourth
                                          ///< mounting)
inline constexpr int kMaxCoordinates = 8; ///< generalised coordinates per tool

inline constexpr std::uint32_t kButtonMark = 1u << 0;    ///< "here it is" (trace files: buttons bit 0)
inline constexpr std::uint32_t kButtonStop = 1u << 1;    ///< stop force immediately
inline constexpr std::uint32_t kButtonDeadMan = 1u << 2; ///< held by the person: permits force while arming
                                                         ///< by confirmation
inline constexpr std::uint32_t kButtonReport = 1u << 3;  ///< a report: its word, whose meaning the exercise
                                                         ///< defines, is in the upper 16 bits

/// Returns the button state that sends the report `word` (a device with a keypad, a scripted hand, a trace
/// file). A scene takes it at the rising edge of kButtonReport.
constexpr std::uint32_t reportButtons(std::uint16_t word) noexcept {
    return kButtonReport | (static_cast<std::uint32_t>(word) << 16);
}

/// Pose and motion of a tool as a scene sees it. The velocity comes from the program's single estimator in
/// simulation (models.md §0), never from a driver.
/// Frame: W.
struct ToolState {
    Vec3 p_WT = Vec3::Zero();     ///< m
    Quat q_WT = Quat::Identity(); ///< unit quaternion
    Vec3 v_WT = Vec3::Zero();     ///< m/s
    Vec3 w_WT = Vec3::Zero();     ///< rad/s
    double jaw_rad = 0.0;
    std::uint32_t buttons = 0;
};

struct ToolStates {
    int count = 0; ///< 0..kMaxTools
    std::array<ToolState, kMaxTools> tools{};
};

struct ToolWrenches {
    int count = 0;
    std::array<Wrench, kMaxTools> tools{};
};

/// Pose of the fingertip platform's display (P3): normal force (N), pitch and roll (rad). Zero for other
/// devices.
struct DisplayPose {
    double normalForce_N = 0.0;
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
};

} // namespace chiron::core
