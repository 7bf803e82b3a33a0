// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/elastic_tube/scene/tension_bar.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/scene3d/scene_setup.h"

#include <QCoreApplication>

namespace chiron::scene3d {

/// The elastic tube from above and from the side: the same curve as in 3D.
class FlatTube final : public IFlatContent {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatTube)

public:
    explicit FlatTube(const simulation::ElasticTubeParameters& parameters) : m_parameters(parameters) {}
    /// Names of the marks that it draws in addition to the objects (marksOf), the same in 3D and flat. Pure
    /// function.
    static std::vector<std::string> marks(const simulation::ElasticTubeParameters& parameters,
                                          const MarkedScene& scene);

    QString name() const override { return tr("Elastic tube and instruments, from above and from the side"); }
    FlatFrame frame() const override;
    void paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const SceneState& state) const override;
    ForceBars bars(const SceneSetup& setup, const SceneState& state) const override {
        return {forceDial(setup), tensionBar(m_parameters, state.exercise.of<core::LaparoscopyCues>())};
    }
    double groundHeight_m(const SceneState&, double, double) const override { return 0.0; }

private:
    simulation::ElasticTubeParameters m_parameters;
};

} // namespace chiron::scene3d
