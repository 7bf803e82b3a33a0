// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_setup.h"
#include "desktop/scene3d/scene_state.h"

#include <QCoreApplication>
#include <QWidget>
#include <functional>

namespace chiron::scene3d {

/// The widget of FlatSceneView: lays out the two panels and the line that says why it is flat.
class FlatCanvas final : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatCanvas)

public:
    FlatCanvas(const SceneSetup& setup, const QString& why, QWidget* parent);

    void setState(const SceneState& state);
    void setSetup(const SceneSetup& setup);
    std::uint64_t framesDrawn() const { return m_frames; }
    void onFirstFrame(std::function<void()> call);
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    SceneSetup m_setup;
    SceneState m_state;
    QString m_why;
    std::uint64_t m_frames = 0;
    std::function<void()> m_firstFrame;
};

} // namespace chiron::scene3d
