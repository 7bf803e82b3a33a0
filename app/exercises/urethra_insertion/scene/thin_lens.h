// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace chiron::scene3d {

/// The depth of field of an endoscope. With aperture A, focus distance s and an object at distance d (along
/// the axis), a thin lens makes a circle of confusion of A·f·s/(s−f)·|1/s − 1/d| on its sensor, where f is
/// the focal length. The sensor is at v = f·s/(s−f) behind the lens, and a picture of angle φ is 2·v·tan(φ/2)
/// wide, so that in a picture P pixels wide
///     c = P·A·|1/s − 1/d| / (2·tan(φ/2)),
/// independently of f. The aperture is an assumption: about that of a rod-lens cystoscope.
struct ThinLens {
    double aperture_mm = 0.30;

    /// The factor of |1/s − 1/d| (1/mm): pixels · mm.
    double strength_px_mm(double picture_px, double fieldOfView_rad) const {
        return picture_px * aperture_mm / (2.0 * std::tan(0.5 * fieldOfView_rad));
    }
    /// Diameter of the circle of confusion in the picture.
    double confusion_px(double distance_mm, double focus_mm, double picture_px,
                        double fieldOfView_rad) const {
        return strength_px_mm(picture_px, fieldOfView_rad) * std::abs(1.0 / focus_mm - 1.0 / distance_mm);
    }

    /// Largest diameter, in a picture 700 pixels wide; larger ones are limited to it.
    static constexpr double kLargest_px = 18.0;
};

} // namespace chiron::scene3d
