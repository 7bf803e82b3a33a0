// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_view.h"

#include <QPointer>
#include <QString>

namespace chiron::scene3d {

class FlatCanvas;

/// Draws the scene from above and from the side with QPainter, for computers without OpenGL. It uses the same
/// geometry and shows the same cues as the 3D scene.
class FlatSceneView final : public ISceneView {
public:
    FlatSceneView(const SceneSetup& setup, const QString& why, QWidget* parent);
    ~FlatSceneView() override;

    QWidget* widget() override;
    QObject* inputSource() override;
    void show(const SceneState& state) override;
    void change(const SceneSetup& setup) override;
    std::uint64_t framesDrawn() const override;
    void onFirstFrame(std::function<void()> call) override;

private:
    QPointer<FlatCanvas> m_canvas;
};

} // namespace chiron::scene3d
