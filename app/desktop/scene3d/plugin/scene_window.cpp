// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/scene_window.h"

#include "desktop/scene3d/scene_plugin.h"

#include <QCoreApplication>
#include <QEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <Qt3DCore/QAspectEngine>
#include <Qt3DCore/QCoreAspect>
#include <Qt3DRender/QRenderAspect>

namespace chiron::scene3d {

namespace {

constexpr std::uint64_t kWholeFrame = 3;
constexpr int kSettling = 2;
constexpr int kSettle_ms = 60; // longer than the interval between two frames

QSurfaceFormat sceneFormat() {
    QSurfaceFormat format;
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0); // four samples would halve the frame rate of a software rasteriser
    format.setSwapInterval(1);
    return format;
}

} // namespace

SceneWindow::SceneWindow() {
    setSurfaceType(QSurface::OpenGLSurface);
    setFormat(sceneFormat());
    setObjectName(QStringLiteral("scene.window"));
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettle_ms);
    m_settle.callOnTimeout(this, &SceneWindow::settle);
}

SceneWindow::~SceneWindow() {
    if (m_engine)
        m_engine->setRootEntity({}); // while the window and its context still exist
    m_root.reset();                  // and the nodes, while the engine's table of them still exists
    m_engine.reset();
}

void SceneWindow::setRoot(Qt3DCore::QEntity* root) {
    m_root = Qt3DCore::QEntityPtr(root);
    setProperty(kSceneRootProperty, QVariant::fromValue<QObject*>(root));
}

void SceneWindow::start() {
    // The renderer creates its context from the default format. The rest of the program keeps its own format.
    const QSurfaceFormat before = QSurfaceFormat::defaultFormat();
    QSurfaceFormat::setDefaultFormat(sceneFormat());
    m_engine = std::make_unique<Qt3DCore::QAspectEngine>();
    m_engine->setRunMode(Qt3DCore::QAspectEngine::Manual);
    m_engine->registerAspect(new Qt3DCore::QCoreAspect);
    m_engine->registerAspect(new Qt3DRender::QRenderAspect(Qt3DRender::QRenderAspect::Automatic));
    m_engine->setRootEntity(m_root);
    draw();
    QSurfaceFormat::setDefaultFormat(before);
}

void SceneWindow::requestFrame() {
    m_settling = kSettling;
    m_settle.stop();
    post();
}

void SceneWindow::post() {
    // requestUpdate() is not used, because it waits some milliseconds to collect requests, and callers come
    // at most once per frame.
    if (isExposed() && !std::exchange(m_asked, true))
        QCoreApplication::postEvent(this, new QEvent(QEvent::UpdateRequest));
}

void SceneWindow::settle() {
    if (m_settling <= 0)
        return;
    --m_settling;
    post();
}

void SceneWindow::onFirstFrame(std::function<void()> call) {
    m_firstFrame = std::move(call);
    if (m_whole)
        tellFirstFrame();
}

void SceneWindow::tellFirstFrame() {
    if (m_firstFrame)
        QTimer::singleShot(0, this, std::exchange(m_firstFrame, nullptr));
}

void SceneWindow::exposeEvent(QExposeEvent*) {
    if (!isExposed() || !m_root)
        return;
    if (!m_engine)
        start();
    requestFrame();
}

void SceneWindow::resizeEvent(QResizeEvent*) {
    if (m_resized)
        m_resized();
    requestFrame();
}

bool SceneWindow::event(QEvent* event) {
    if (event->type() == QEvent::UpdateRequest) {
        draw();
        return true;
    }
    return QWindow::event(event);
}

void SceneWindow::draw() {
    m_asked = false;
    if (!m_engine || !isExposed() || m_drawing)
        return;
    m_drawing = true;
    m_engine->processFrame();
    m_drawing = false;
    ++m_frames;
    if (m_settling > 0)
        m_settle.start();
    if (m_whole)
        return;
    // Qt3D loads over the first frames: it starts in the first, learns about shaders and buffers in the
    // second, and draws everything in the third. Its programs never report "ready" to an engine that is
    // stepped by hand, so the frames are counted.
    if (m_frames >= kWholeFrame) {
        m_whole = true;
        if (m_becameWhole)
            m_becameWhole();
        tellFirstFrame();
    }
    requestFrame();
}

} // namespace chiron::scene3d
