// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/finding_flag.h"

#include <QFont>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>

namespace chiron::scene3d {

using simulation::FindingOutcome;

void paintFindingFlag(QPainter& painter, const QRectF& box, const FindingFlag& flag,
                      const SceneSetup& setup) {
    const QPointF middle = box.center();
    const double unit = box.width() / 32.0;
    const bool wrong = flag.outcome == FindingOutcome::falseAlarm;
    const bool hit = flag.outcome == FindingOutcome::hit;
    const QColor edge = wrong ? setup.colours.over : hit ? setup.colours.arrow : setup.colours.ink;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(setup.colours.background);
    painter.setPen(QPen(edge, 2.0 * unit));
    if (wrong) {
        const double arm = 12.0 * unit;
        painter.drawPolygon(QPolygonF{middle + QPointF(0, -arm), middle + QPointF(arm, 0),
                                      middle + QPointF(0, arm), middle + QPointF(-arm, 0)});
    } else if (hit) {
        painter.drawEllipse(middle, 12.0 * unit, 12.0 * unit);
        painter.drawEllipse(middle, 8.5 * unit, 8.5 * unit);
    } else {
        painter.drawRoundedRect(QRectF(middle - QPointF(9.0, 9.0) * unit, QSizeF(18.0, 18.0) * unit),
                                2.5 * unit, 2.5 * unit);
    }
    if (flag.selected)
        for (const auto& [colour, wide] :
             {std::pair{setup.colours.background, 5.0}, {setup.colours.ink, 2.6}}) {
            painter.setPen(QPen(colour, wide * unit, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0}) {
                    const QPointF corner = middle + 13.2 * unit * QPointF(x, y);
                    painter.drawPolyline(QPolygonF{corner - QPointF(5.0 * unit * x, 0), corner,
                                                   corner - QPointF(0, 5.0 * unit * y)});
                }
        }
    QFont font(setup.family);
    font.setPixelSize(std::max(1, int(12.5 * unit)));
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(setup.colours.ink);
    painter.drawText(QRectF(middle - QPointF(11, 11) * unit, QSizeF(22, 22) * unit), Qt::AlignCenter,
                     QLocale().toString(flag.number));
    painter.restore();
}

} // namespace chiron::scene3d
