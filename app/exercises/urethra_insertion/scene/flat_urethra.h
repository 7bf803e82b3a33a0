// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"

namespace chiron::scene3d {

/// The endoscope's view without OpenGL: its round picture as outlines of the canal one behind the other, and
/// the canal from the side if the level has an overview. It shows the same cues and marks as the 3D view.
class FlatUrethra final : public IFlatContent {
public:
    explicit FlatUrethra(const simulation::UrethraInsertionParameters& parameters) : m_drawing(parameters) {}
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::UrethraInsertionParameters& parameters,
                                          const MarkedScene& scene);

    bool paintWhole(QPainter& painter, const QRectF& room, const SceneSetup& setup,
                    const SceneState& state) const override;
    QString name() const override;
    FlatFrame frame() const override { return {}; } ///< it has no panels
    void paint(QPainter&, const FlatPanel&, const SceneSetup&, const SceneState&) const override {}
    double groundHeight_m(const SceneState&, double, double) const override { return 0.0; }

private:
    UrethraDrawing m_drawing;
};

} // namespace chiron::scene3d
