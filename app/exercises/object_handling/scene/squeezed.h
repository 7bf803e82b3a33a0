// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

/// The linear map from a unit body to a squeezed one: thinner by `squeeze_m` along `jaws` (unit vector across
/// the blades) and wider perpendicular to it, so that its volume is constant. Pure function.
inline core::Mat3 squeezed(const core::BodyCue& body, const core::Vec3& jaws) {
    const double thin = std::clamp(1.0 - 0.5 * body.squeeze_m / std::max(1e-6, body.radius_m), 0.4, 1.0);
    const double wide = 1.0 / std::sqrt(thin);
    const core::Mat3 across = jaws * jaws.transpose();
    const core::Mat3 flat = wide * core::Mat3::Identity() + (thin - wide) * across;
    const core::Quat q(body.q_W[0], body.q_W[1], body.q_W[2], body.q_W[3]);
    return body.radius_m * flat *
           (q.norm() > 0.5 ? q.normalized() : core::Quat::Identity()).toRotationMatrix();
}

} // namespace chiron::scene3d
