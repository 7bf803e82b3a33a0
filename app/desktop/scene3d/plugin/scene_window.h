// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWindow>
#include <Qt3DCore/QEntity>
#include <cstdint>
#include <functional>
#include <memory>

namespace Qt3DCore {
class QAspectEngine;
}

namespace chiron::scene3d {

/// The native window into which Qt3D draws, with an engine that is stepped by hand: one frame a request and
/// none between, so that an idle scene costs nothing and every frame is counted. Only the render aspect is
/// loaded (Qt3DWindow brings input and logic too). GUI thread.
class SceneWindow final : public QWindow {
public:
    SceneWindow();
    ~SceneWindow() override;

    /// The scene; once, before the window is shown. Its frame graph draws into this window.
    void setRoot(Qt3DCore::QEntity* root);
    /// Draws soon; calls before that are one frame.
    void requestFrame();
    std::uint64_t framesDrawn() const { return m_frames; }
    void onFirstFrame(std::function<void()> call);
    /// Called when the size has changed, before the frame is drawn.
    void onResize(std::function<void()> call) { m_resized = std::move(call); }

protected:
    void exposeEvent(QExposeEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    void start();
    void draw();
    void tellFirstFrame();

    Qt3DCore::QEntityPtr m_root;
    std::unique_ptr<Qt3DCore::QAspectEngine> m_engine;
    std::function<void()> m_firstFrame;
    std::function<void()> m_resized;
    std::uint64_t m_frames = 0;
    bool m_asked = false;
    bool m_whole = false;
    bool m_drawing = false;
};

} // namespace chiron::scene3d
