// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/scene3d/scene_setup.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QCoreApplication>

namespace chiron::scene3d {

/// The positions of the compared objects from above and from the side. All are drawn alike: nothing in the
/// picture depends on the object at a position.
class FlatComparison final : public IFlatContent {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatComparison)

public:
    explicit FlatComparison(const simulation::ComparisonParameters& parameters) : m_parameters(parameters) {}
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::ComparisonParameters& parameters,
                                          const MarkedScene& scene);

    QString name() const override {
        return tr("Objects side by side and instrument, from above and from the side");
    }
    FlatFrame frame() const override;
    void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const SceneState& state) const override;
    double groundHeight_m(const SceneState&, double, double) const override { return 0.0; }

private:
    simulation::ComparisonParameters m_parameters;
};

} // namespace chiron::scene3d
