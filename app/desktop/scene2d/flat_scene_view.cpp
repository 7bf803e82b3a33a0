// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_scene_view.h"

#include "desktop/scene2d/flat_canvas.h"

namespace chiron::scene3d {

FlatSceneView::FlatSceneView(const SceneSetup& setup, const QString& why, QWidget* parent)
    : m_canvas(new FlatCanvas(setup, why, parent)) {}

FlatSceneView::~FlatSceneView() {
    delete m_canvas.data();
}

QWidget* FlatSceneView::widget() {
    return m_canvas;
}

QObject* FlatSceneView::inputSource() {
    return m_canvas;
}

void FlatSceneView::show(const SceneState& state) {
    if (m_canvas)
        m_canvas->setState(state);
}

void FlatSceneView::change(const SceneSetup& setup) {
    if (m_canvas)
        m_canvas->setSetup(setup);
}

std::uint64_t FlatSceneView::framesDrawn() const {
    return m_canvas ? m_canvas->framesDrawn() : 0;
}

void FlatSceneView::onFirstFrame(std::function<void()> call) {
    if (m_canvas)
        m_canvas->onFirstFrame(std::move(call));
}

} // namespace chiron::scene3d
