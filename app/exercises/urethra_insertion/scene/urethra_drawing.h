// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_state.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

namespace chiron::scene3d {

/// The positions of everything in the pictures of the urethra, from the same anatomy as the forces
/// (models.md §1). Pure after construction.
/// Unit: m.
/// Frame: A.
/// Thread: any.
class UrethraDrawing {
public:
    explicit UrethraDrawing(const simulation::UrethraInsertionParameters& parameters);

    const simulation::UrethraInsertionParameters& parameters() const { return m_parameters; }
    const simulation::UrethraCentreline& centreline() const { return m_centreline; }

    /// The deformation of the wall under the drawn tip; at rest while there is no tool or its beak is
    /// outside.
    simulation::UrethraDeformation deformationOf(const ToolView& tool) const;
    core::Vec3 tip_A(const ToolView& tool) const;
    /// Axes of T in A as columns: x to the right of the picture, y up, looking along −z.
    core::Mat3 axes_A(const ToolView& tool) const;
    /// The distance at which the camera's gain and focus are set: kNear_m in the canal, the distance of the
    /// bladder's wall along the axis inside the bladder, with a smooth transition over kBlend_m past the
    /// neck.
    double meteredDistance_m(const ToolView& tool) const;

    core::Vec3 bladderCentre_A() const { return m_bladderCentre_A; }
    /// A point of the bladder's wall: polar angle from t(C) (0 = dome, π = neck), azimuth about it from x̂
    /// towards n.
    core::Vec3 bladderWall_A(double polar_rad, double azimuth_rad) const;
    core::Vec3 bladderDirection_A(double polar_rad, double azimuth_rad) const;
    /// The position of a landmark; whether anything hides it is up to the picture.
    core::Vec3 landmark_A(const simulation::BladderLandmark& landmark) const {
        return bladderWall_A(landmark.polar_rad, landmark.azimuth_rad);
    }

    static constexpr double kNear_m = 0.012;  ///< working distance in the canal
    static constexpr double kBlend_m = 0.008; ///< length of the transition past the neck

private:
    simulation::UrethraInsertionParameters m_parameters;
    simulation::UrethraCentreline m_centreline;
    simulation::CentrelinePoint m_neck;
    core::Vec3 m_bladderCentre_A;
};

} // namespace chiron::scene3d
