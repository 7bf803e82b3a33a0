// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/scene/apex_surface.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

namespace chiron::scene3d {

/// The hemisphere from above, and from the side the section through the touched point.
class FlatApex final : public IFlatContent {
public:
    explicit FlatApex(const simulation::SphereApexParameters& parameters) : m_parameters(parameters) {}
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::SphereApexParameters& parameters,
                                          const MarkedScene& scene);

    FlatFrame frame() const override;
    void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const SceneState& state) const override;
    double groundHeight_m(const SceneState& state, double x_m, double y_m) const override;

    /// The drawn outline of the section, left to right: x, z in metres. It passes through the tip while the
    /// tip presses.
    static std::vector<core::Vec2> profile(const ApexSurface& surface, const ToolView& tool);

private:
    void paintAbove(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                    const SceneState& state, const ApexSurface& surface) const;
    void paintSide(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                   const SceneState& state, const ApexSurface& surface) const;

    simulation::SphereApexParameters m_parameters;
};

} // namespace chiron::scene3d
