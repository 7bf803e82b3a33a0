// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/qt3d_scene_view.h"

#include <QCoreApplication>

namespace chiron::scene3d {

Qt3DSceneView::Qt3DSceneView(const SceneSetup& setup, QWidget* parent) : m_window(new SceneWindow) {
    m_stage = makeStage(setup, m_window);
    m_window->setRoot(m_stage->root());
    m_window->onResize([this] { takeSize(); });
    m_window->onWhole([this] { m_stage->warm(); });
    m_container = QWidget::createWindowContainer(m_window, parent);
    m_container->setObjectName(QStringLiteral("scene.container"));
    m_container->setAccessibleName(
        QCoreApplication::translate("chiron::scene3d::Qt3DSceneView", "Operating field in three dimensions"));
    m_container->setFocusPolicy(Qt::StrongFocus);
    m_container->setMinimumSize(QSize(320, 240));
    takeSize();
}

Qt3DSceneView::~Qt3DSceneView() {
    if (m_window)
        m_window->onResize({});
    delete m_container.data();
}

void Qt3DSceneView::takeSize() {
    const double ratio = m_window->devicePixelRatio();
    m_stage->setPicture(QSize(int(m_window->width() * ratio), int(m_window->height() * ratio)), ratio);
}

void Qt3DSceneView::show(const SceneState& state) {
    if (!m_window)
        return;
    m_stage->show(state);
    m_window->requestFrame();
}

void Qt3DSceneView::change(const SceneSetup& setup) {
    if (!m_window)
        return;
    m_stage->change(setup);
    m_window->requestFrame();
}

std::uint64_t Qt3DSceneView::framesDrawn() const {
    return m_window ? m_window->framesDrawn() : 0;
}

void Qt3DSceneView::onFirstFrame(std::function<void()> call) {
    if (m_window)
        m_window->onFirstFrame(std::move(call));
}

} // namespace chiron::scene3d
