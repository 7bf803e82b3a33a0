// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_canvas.h"

#include "desktop/scene2d/flat_tools.h"
#include "desktop/scene3d/gauge_painter.h"
#include "desktop/scene3d/scene_note_painter.h"

#include <QPainter>
#include <QTimer>
#include <algorithm>

namespace chiron::scene3d {

namespace {
constexpr double kGap = 12.0;         // logical pixels at scale 1
constexpr double kLeast_px = 0.02;    // per mm: however small the picture, the titles are within it
constexpr double kReasonShare = 0.25; // of the height; what takes more leaves the room to the picture
} // namespace

FlatCanvas::FlatCanvas(const SceneSetup& setup, const QString& why, QWidget* parent)
    : QWidget(parent), m_setup(setup), m_why(why), m_content(makeFlatContent(setup)) {
    setObjectName(QStringLiteral("scene.flat"));
    nameIt();
    setAccessibleDescription(why);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
}

FlatCanvas::~FlatCanvas() = default;

void FlatCanvas::nameIt() {
    const QString own = m_content ? m_content->name() : QString();
    setAccessibleName(own.isEmpty() ? tr("Operating field from above and from the side") : own);
}

void FlatCanvas::setState(const SceneState& state) {
    m_state = state;
    update();
}

void FlatCanvas::setSetup(const SceneSetup& setup) {
    m_setup = setup;
    m_content = makeFlatContent(setup);
    nameIt(); // the language may have changed
    updateGeometry();
    update();
}

void FlatCanvas::onFirstFrame(std::function<void()> call) {
    m_firstFrame = std::move(call);
    if (m_frames > 0)
        QTimer::singleShot(0, this, std::exchange(m_firstFrame, nullptr));
}

QSize FlatCanvas::minimumSizeHint() const {
    return {320, 240};
}

QSize FlatCanvas::sizeHint() const {
    return QSize(800, 600) * m_setup.scale;
}

QRectF FlatCanvas::paintReason(QPainter& painter) const {
    const double gap = kGap * m_setup.scale;
    QRectF room = QRectF(rect()).adjusted(gap, gap, -gap, -gap);
    if (m_why.isEmpty())
        return room;
    QFont font(m_setup.family);
    font.setPixelSize(std::max(1, int(13.0 * m_setup.scale)));
    painter.setFont(font);
    painter.setPen(m_setup.colours.ink);
    constexpr int kFlags = Qt::AlignHCenter | Qt::AlignBottom | Qt::TextWordWrap;
    const QRectF line = painter.boundingRect(room, kFlags, m_why);
    if (line.height() > kReasonShare * room.height())
        return room; // the accessible description still says it
    painter.drawText(room, kFlags, m_why);
    room.setBottom(line.top() - 0.7 * gap);
    return room;
}

QRectF FlatCanvas::paintBars(QPainter& painter, QRectF room) const {
    const auto paint = [&](const GaugeDial& dial, double value_N) {
        const double unit = std::min(m_setup.scale, room.height() / GaugePainter::kHeight);
        // A bar that is lower than it should be keeps texts that can be read.
        const GaugePainter painted(m_setup, dial,
                                   std::clamp(m_setup.scale / unit, 1.0, GaugePainter::kLargestText));
        const bool over = dial.limit_N > 0.0 && value_N > dial.limit_N;
        const QRectF hollow = GaugePainter::hollow();
        painter.save();
        painter.translate(room.right() - painted.width() * unit,
                          room.center().y() - 0.5 * GaugePainter::kHeight * unit);
        painter.scale(unit, unit);
        painter.fillRect(hollow, m_setup.colours.background);
        QRectF liquid = hollow;
        liquid.setTop(hollow.bottom() - hollow.height() * std::clamp(value_N / dial.range_N, 0.0, 1.0));
        painter.fillRect(liquid, over ? m_setup.colours.over : m_setup.colours.arrow);
        if (over)
            painter.fillRect(liquid, QBrush(m_setup.colours.background, Qt::BDiagPattern));
        painted.paint(painter);
        painter.restore();
        room.setRight(room.right() - (painted.width() * unit + kGap * m_setup.scale));
    };
    const ForceBars bars = m_content ? m_content->bars(m_setup, m_state) : ForceBars{forceDial(m_setup)};
    if (m_setup.cues.arrow)
        paint(bars.force, largestForce_N(m_state));
    if (bars.second && bars.second->shown)
        paint(bars.second->dial, bars.second->value_N);
    return room;
}

void FlatCanvas::placePanels(FlatPanel& above, FlatPanel& side, const QRectF& room) const {
    const double gap = kGap * m_setup.scale;
    const QSizeF frameAbove = above.cardSize(0.0);
    const QSizeF frameSide = side.cardSize(0.0);
    const QRectF a = above.range_mm();
    const QRectF s = side.range_mm();
    // Stacked, the views share the x axis; side by side they suit a wide widget. The arrangement with the
    // larger picture wins.
    const double stacked =
        std::min((room.height() - gap - frameAbove.height() - frameSide.height()) / (a.height() + s.height()),
                 (room.width() - frameAbove.width()) / std::max(a.width(), s.width()));
    const double beside =
        std::min((room.width() - gap - frameAbove.width() - frameSide.width()) / (a.width() + s.width()),
                 (room.height() - frameAbove.height()) / std::max(a.height(), s.height()));
    const double scale = std::max(kLeast_px, std::max(stacked, beside));
    const QSizeF sizeAbove = above.cardSize(scale);
    if (beside > stacked)
        side.extendUp(sizeAbove.height(), scale);
    const QSizeF sizeSide = side.cardSize(scale);
    if (stacked >= beside) {
        const double left = room.center().x() - 0.5 * sizeAbove.width();
        const double top = room.center().y() - 0.5 * (sizeAbove.height() + gap + sizeSide.height());
        above.place({left, top}, scale);
        side.place({left, top + sizeAbove.height() + gap}, scale);
        return;
    }
    const double left = room.center().x() - 0.5 * (sizeAbove.width() + gap + sizeSide.width());
    const double top = room.center().y() - 0.5 * sizeAbove.height();
    above.place({left, top}, scale);
    side.place({left + sizeAbove.width() + gap, top}, scale);
}

void FlatCanvas::paintPanel(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                            bool paintsTools) {
    const bool fromAbove = panel.side() == FlatPanel::Side::above;
    panel.paintCard(painter, fromAbove ? tr("From above") : tr("From the side"), tr("x (mm)"),
                    fromAbove ? tr("y (mm)") : tr("z (mm)"));
    painter.save();
    painter.setClipRect(panel.plot());
    m_content->paint(painter, panel, setup, m_state);
    FlatTools tools(painter, panel, setup);
    if (m_state.answered)
        tools.paintAnswer(m_state.p_WAnswer);
    if (m_state.marked) {
        core::Vec3 p = m_state.p_WMark;
        p.z() = std::max(p.z(), m_content->groundHeight_m(m_state, p.x(), p.y()));
        tools.paintPin(p);
    }
    const bool several = toolsOf(m_state) > 1;
    if (m_state.ghost.present && paintsTools)
        tools.paintTool(m_state.ghost,
                        m_ghostHeld.of(m_state.ghost, entersLeft(0, several, m_setup.leftHanded)), true);
    for (std::size_t i = 0; i < m_state.tool.size(); ++i) {
        const ToolView& tool = m_state.tool[i];
        if (!tool.present)
            continue;
        if (m_setup.cues.tool) {
            const core::Vec3 from = setDownBy(m_state, i);
            tools.paintDropLine(from, m_content->groundHeight_m(m_state, from.x(), from.y()));
        }
        if (m_setup.cues.tool && paintsTools) {
            const core::Quat held =
                m_held[i].of(tool, entersLeft(static_cast<int>(i), several, m_setup.leftHanded));
            tools.paintTool(tool, held, false);
            if (several)
                tools.paintRings(tool, held, static_cast<int>(i), m_state.activeTool == static_cast<int>(i));
        }
        if (m_setup.cues.arrow)
            tools.paintArrow(tool);
    }
    tools.paintYields(m_state);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(setup.colours.ink, setup.scale));
    painter.drawRect(panel.plot());
}

void FlatCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), m_setup.colours.background);
    const QRectF room = paintBars(painter, paintReason(painter));
    if (m_content && !m_content->paintWhole(painter, room, m_setup, m_state)) {
        SceneSetup fitted = m_setup; // the text shrinks in favour of the picture
        fitted.scale = FlatPanel::scaleIn(room.height(), m_setup.scale);
        const FlatFrame frame = m_content->frame();
        FlatPanel above(FlatPanel::Side::above, frame.above_mm, fitted);
        FlatPanel side(FlatPanel::Side::side, frame.side_mm, fitted);
        placePanels(above, side, room);
        paintPanel(painter, above, fitted, !frame.ownTools);
        paintPanel(painter, side, fitted, !frame.ownTools);
    }
    SceneNotePainter(m_setup).paint(painter, QRectF(rect()), 1.0, m_state.note);
    ++m_frames;
    if (m_firstFrame)
        QTimer::singleShot(0, this, std::exchange(m_firstFrame, nullptr));
}

} // namespace chiron::scene3d
