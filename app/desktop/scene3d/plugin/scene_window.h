// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWindow>
#include <Qt3DCore/QEntity>
#include <cstdint>
#include <functional>
#include <memory>

namespace Qt3DCore {
class QAspectEngine;
}

namespace chiron::scene3d {

/// The native window into which Qt3D draws. The engine is stepped by hand, with one frame per request and
/// none in between, so that an idle scene costs nothing and every frame is counted. Only the render aspect is
/// loaded (Qt3DWindow would also bring input and logic).
/// Thread: GUI.
class SceneWindow final : public QWindow {
public:
    SceneWindow();
    ~SceneWindow() override;

    /// Sets the scene, once, before the window is shown. The scene's frame graph draws into this window.
    void setRoot(Qt3DCore::QEntity* root);
    /// Draws soon; several calls before that give one frame. Two more frames follow if no other call comes,
    /// because Qt3D loads something new in one frame and draws it in the next.
    void requestFrame();
    std::uint64_t framesDrawn() const { return m_frames; }
    void onFirstFrame(std::function<void()> call);
    /// `call` runs after the first complete frame and before the first-frame callback; it may load what is
    /// not visible yet.
    void onWhole(std::function<void()> call) { m_becameWhole = std::move(call); }
    /// `call` runs when the size has changed, before the frame is drawn.
    void onResize(std::function<void()> call) { m_resized = std::move(call); }

protected:
    void exposeEvent(QExposeEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void start();
    void draw();
    void post();
    void settle();
    void tellFirstFrame();

    Qt3DCore::QEntityPtr m_root;
    std::unique_ptr<Qt3DCore::QAspectEngine> m_engine;
    std::function<void()> m_firstFrame;
    std::function<void()> m_resized;
    std::function<void()> m_becameWhole;
    std::uint64_t m_frames = 0;
    bool m_asked = false;
    int m_settling = 0; ///< frames still to follow
    QTimer m_settle;
    bool m_whole = false;
    bool m_drawing = false;
};

} // namespace chiron::scene3d
