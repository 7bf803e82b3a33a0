// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/object_handling/scene/squeeze_bar.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/scene3d/scene_setup.h"

#include <QCoreApplication>

namespace chiron::scene3d {

/// Ovaries and their dish from above and from the side.
class FlatHandling final : public IFlatContent {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatHandling)

public:
    explicit FlatHandling(const simulation::ObjectHandlingParameters& parameters)
        : m_parameters(parameters) {}
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::ObjectHandlingParameters& parameters,
                                          const MarkedScene& scene);

    QString name() const override {
        return tr("Objects, target and instrument, from above and from the side");
    }
    FlatFrame frame() const override;
    void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const SceneState& state) const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup), squeezeBar(m_parameters, state.exercise.of<core::LaparoscopyCues>())};
    }
    double groundHeight_m(const SceneState&, double, double) const override { return 0.0; }

private:
    simulation::ObjectHandlingParameters m_parameters;
};

} // namespace chiron::scene3d
