// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/plugin/note_card.h"

#include "desktop/scene3d/parts/flat_shapes.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"
#include "desktop/scene3d/scene_note_painter.h"

#include <QPainter>
#include <QVariant>

namespace chiron::scene3d {

namespace {
constexpr double kInFront = -0.9996; // in front of the bar and of every mark
}

NoteCard::NoteCard(SharedLight& light, Qt3DCore::QNode* parent)
    : QEntity(parent), m_face(new PaintedFace(this)) {
    auto* face = new Qt3DRender::QParameter(
        QStringLiteral("face"), QVariant::fromValue<Qt3DRender::QAbstractTexture*>(m_face->texture()), this);
    new Part(flatSquare(kInFront),
             light.effects.material("screen.vert", "face.frag", {face}, Blend::premultiplied, this), this);
    setEnabled(false);
}

void NoteCard::change(const SceneSetup& setup) {
    m_setup = setup;
    repaint();
}

void NoteCard::setPicture(const QSize& size_px, double ratio) {
    m_picture_px = size_px;
    m_ratio = ratio;
    repaint();
}

void NoteCard::show(const SceneNote& note) {
    if (note == m_note)
        return;
    m_note = note;
    setEnabled(note.kind != SceneNote::Kind::none);
    repaint();
}

void NoteCard::repaint() {
    if (m_note.kind == SceneNote::Kind::none)
        return;
    const QSize size_px = m_picture_px.expandedTo({8, 8});
    m_face->change(size_px, [setup = m_setup, note = m_note, size_px, ratio = m_ratio](QPainter& painter) {
        SceneNotePainter(setup).paint(painter, QRectF(QPointF(0, 0), QSizeF(size_px)), ratio, note);
    });
}

} // namespace chiron::scene3d
