// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/scene/palpation_dial.h"
#include "app/exercises/palpation/scene/tissue_look.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/parts/dent.h"
#include "desktop/scene3d/scene_marks.h"
#include "simulation/palpation/tissue_surface.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QImage>
#include <QLineF>
#include <vector>

namespace chiron::scene3d {

/// A tissue from above, with its contour lines, map, findings and lumps, and the section through the pressing
/// finger, with its depth.
class FlatPalpation final : public IFlatContent {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatPalpation)

public:
    explicit FlatPalpation(const simulation::PalpationParameters& parameters);
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::PalpationParameters& parameters,
                                          const MarkedScene& scene);

    QString name() const override { return tr("Tissue, fingers and findings, from above and from the side"); }
    FlatFrame frame() const override;
    void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const SceneState& state) const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup, state.exercise.of<simulation::PalpationCues>())};
    }
    double groundHeight_m(const SceneState& state, double x_m, double y_m) const override;

    /// The position of the section, m: through the finger that presses deepest, else through the first
    /// finger, else through the middle.
    static double cut_m(const SceneState& state, const simulation::TissueSurface& surface);
    /// The outline of that section, left to right, with its dents: x and z, metres.
    std::vector<core::Vec2> profile(const SceneState& state) const;
    /// Contour lines as pairs of points, mm.
    const std::vector<QLineF>& heightLines() const { return m_lines; }
    double lineStep_mm() const { return m_lineStep_mm; }

private:
    QRectF above_mm() const;
    QRectF side_mm() const;
    void paintRelief();
    void findHeightLines();
    void paintAbove(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                    const SceneState& state) const;
    void paintSide(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                   const SceneState& state) const;
    /// What the contour lines mean, in as many words as fit the room; empty if none do.
    static QString lineWords(double step_mm, double room_px, const QFontMetricsF& font);
    void paintLines(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup) const;
    void paintMap(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                  const SceneState& state) const;
    void paintLumps(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                    const SceneState& state) const;
    void paintFindings(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                       const SceneState& state) const;
    void paintLegend(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                     const SceneState& state) const;

    simulation::PalpationParameters m_parameters;
    simulation::TissueSurface m_surface;
    QImage m_relief; ///< relief of the area seen from above
    std::vector<QLineF> m_lines;
    double m_lineStep_mm = 2.0;
};

} // namespace chiron::scene3d
