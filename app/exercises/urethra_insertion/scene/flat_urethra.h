// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"

namespace chiron::scene3d {

/// The endoscope's view without OpenGL: its round picture as outlines of the canal one behind the other, and, where the level
/// has an overview, the canal from the side. Same cues and marks as in 3D.
class FlatUrethra final : public IFlatContent {
public:
    explicit FlatUrethra(const simulation::UrethraInsertionParameters& parameters) : m_drawing(parameters) {}
    /// Names of what it draws beside the things themselves (marksOf), 3D and flat alike. Pure.
    static std::vector<std::string> marks(const simulation::UrethraInsertionParameters& parameters, const MarkedScene& scene);

    bool paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup,
                    const SceneState& state) const override;
    QString name() const override;
    QRectF rangeAbove_mm() const override { return {-1.0, -1.0, 2.0, 2.0}; }
    QRectF rangeSide_mm() const override { return {-1.0, -1.0, 2.0, 2.0}; }
    void paint(QPainter&, const FlatPanel&, const SceneSetup&, const SceneState&) const override {}
    double groundHeight_m(const SceneState&, double, double) const override { return 0.0; }

private:
    UrethraDrawing m_drawing;
};

} // namespace chiron::scene3d
