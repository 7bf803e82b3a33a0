// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_canvas.h"

#include <QPainter>
#include <QTimer>

namespace chiron::scene3d {

FlatCanvas::FlatCanvas(const SceneSetup& setup, const QString& why, QWidget* parent)
    : QWidget(parent), m_setup(setup), m_why(why) {
    setObjectName(QStringLiteral("scene.flat"));
    setAccessibleName(tr("Operating field from above and from the side"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void FlatCanvas::setState(const SceneState& state) {
    m_state = state;
    update();
}

void FlatCanvas::setSetup(const SceneSetup& setup) {
    m_setup = setup;
    update();
}

void FlatCanvas::onFirstFrame(std::function<void()> call) {
    m_firstFrame = std::move(call);
    if (m_frames > 0)
        update();
}

QSize FlatCanvas::minimumSizeHint() const {
    return QSize(320, 240) * m_setup.scale;
}

void FlatCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), m_setup.colours.background);
    painter.setPen(m_setup.colours.ink);
    painter.drawText(rect().adjusted(8, 8, -8, -8), Qt::AlignBottom | Qt::AlignHCenter | Qt::TextWordWrap, m_why);
    ++m_frames;
    if (m_firstFrame)
        QTimer::singleShot(0, this, std::exchange(m_firstFrame, nullptr));
}

} // namespace chiron::scene3d
