// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/plugin/scene_window.h"
#include "desktop/scene3d/plugin/stage.h"
#include "desktop/scene3d/scene_view.h"

#include <QPointer>
#include <QWidget>

namespace chiron::scene3d {

/// Implements the screens' scene interface with Qt3D.
class Qt3DSceneView final : public ISceneView {
public:
    Qt3DSceneView(const SceneSetup& setup, QWidget* parent);
    ~Qt3DSceneView() override;

    QWidget* widget() override { return m_container; }
    QObject* inputSource() override { return m_window; }
    void show(const SceneState& state) override;
    void change(const SceneSetup& setup) override;
    std::uint64_t framesDrawn() const override;
    void onFirstFrame(std::function<void()> call) override;

private:
    void takeSize();

    QPointer<SceneWindow> m_window; ///< owned by the container
    QPointer<QWidget> m_container;
    std::unique_ptr<IStage> m_stage;
};

} // namespace chiron::scene3d
