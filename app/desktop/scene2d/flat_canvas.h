// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/drawn_tool.h"

#include <QCoreApplication>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>

namespace chiron::scene3d {

/// The widget of FlatSceneView. It lays out the two panels, the force bar, and the line that explains why the
/// scene is flat.
class FlatCanvas final : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatCanvas)

public:
    FlatCanvas(const SceneSetup& setup, const QString& why, QWidget* parent);
    ~FlatCanvas() override;

    void setState(const SceneState& state);
    void setSetup(const SceneSetup& setup);
    std::uint64_t framesDrawn() const { return m_frames; }
    void onFirstFrame(std::function<void()> call);
    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void nameIt();
    QRectF paintReason(QPainter& painter) const;            ///< returns the remaining area of the widget
    QRectF paintBars(QPainter& painter, QRectF room) const; ///< returns the remaining area, too
    void placePanels(FlatPanel& above, FlatPanel& side, const QRectF& room) const;
    /// `paintsTools`: the content leaves the tools and the ghost to the canvas.
    void paintPanel(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup, bool paintsTools);

    SceneSetup m_setup;
    SceneState m_state;
    QString m_why;
    std::unique_ptr<IFlatContent> m_content;
    std::array<DrawnOrientation, core::kMaxTools> m_held;
    DrawnOrientation m_ghostHeld;
    std::uint64_t m_frames = 0;
    std::function<void()> m_firstFrame;
};

} // namespace chiron::scene3d
