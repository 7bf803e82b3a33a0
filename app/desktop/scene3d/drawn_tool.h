// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/scene_state.h"

#include <QColor>

namespace chiron::scene3d {

/// The position at which the tip is drawn: at the surface if the device renders no force, otherwise where the
/// hand is.
inline core::Vec3 drawnTip(const ToolView& tool) {
    return tool.drawnAtSurface ? tool.p_WProxy : tool.p_WT;
}

/// The point that this tool would set down: the centre of an object that it holds, if the object is shown,
/// otherwise the tool's tip.
inline core::Vec3 setDownBy(const SceneState& state, std::size_t tool) {
    const core::LaparoscopyCues& scene = state.exercise.of<core::LaparoscopyCues>();
    for (int i = 0; scene.objectShown && i < scene.bodies; ++i)
        if (const core::BodyCue& body = scene.body[static_cast<std::size_t>(i)];
            (body.heldBy & (1U << tool)) != 0)
            return {body.p_W[0], body.p_W[1], body.p_W[2]};
    return drawnTip(state.tool[tool]);
}

inline int toolsOf(const SceneState& state) {
    int tools = 0;
    for (const ToolView& tool : state.tool)
        tools += tool.present ? 1 : 0;
    return tools;
}

/// The side from which the shaft of a tool without orientation enters. With several tools the first, third
/// ... enter from the right.
inline bool entersLeft(int tool, bool several, bool leftHanded) {
    return several ? tool % 2 == 1 : leftHanded;
}

/// Colour of an instrument's rings, distinguishable from the others and from tissue in every theme. The
/// number of rings carries the same information.
inline QColor ringColour(int tool) {
    static constexpr QRgb kColours[core::kMaxTools] = {0xff2fd0a8, 0xfff5b81e, 0xff8fb4ff, 0xffe48bff};
    return QColor(kColours[static_cast<std::size_t>(tool) % core::kMaxTools]);
}

/// Determines the drawn orientation of one tool. A tool that has only ever reported the identity has no
/// orientation to show; its shaft then passes through a fixed entry point, as through a trocar.
class DrawnOrientation {
public:
    /// Call once per frame. The shaft leaves the tip along +z of the returned orientation.
    core::Quat of(const ToolView& tool, bool leftHanded) {
        // 1e-9, because a quaternion from a recording may have lost its last bits
        m_turned = m_turned || tool.q_WT.vec().norm() > 1e-9;
        if (m_turned && tool.q_WT.norm() > 0.5)
            return tool.q_WT.normalized();
        return throughEntry(drawnTip(tool), leftHanded);
    }

    /// Entry point: 0.16 m to the working hand's side and 0.17 m above the middle of the field.
    static core::Quat throughEntry(const core::Vec3& p_WTip, bool leftHanded) {
        const core::Vec3 entry(leftHanded ? -0.16 : 0.16, 0.00, 0.17);
        core::Vec3 z = entry - p_WTip;
        if (!(z.norm() > 1e-6))
            z = core::Vec3::UnitZ();
        z.normalize();
        // The jaws open across the line of sight, which comes from −y and above.
        const core::Vec3 y = z.cross(core::Vec3(0.0, -0.75, 0.66)).normalized();
        core::Mat3 axes;
        axes << y.cross(z), y, z;
        return core::Quat(axes);
    }

private:
    bool m_turned = false;
};

} // namespace chiron::scene3d
