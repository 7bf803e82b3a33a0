// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/flat_palpation.h"

#include "app/exercises/palpation/scene/finding_flag.h"
#include "app/exercises/palpation/scene/flat_fingers.h"
#include "app/exercises/palpation/scene/map_legend.h"
#include "app/exercises/palpation/scene/map_picture.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "app/exercises/palpation/scene/tissue_mesh.h"
#include "desktop/scene3d/drawn_tool.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kBeside_mm = 14.0; // margin beside the search area
constexpr double kBelow_mm = 24.0;
constexpr double kAbove_mm = 50.0;
constexpr double kStep_m = 0.0005;
constexpr QColor kDeepEdge(92, 40, 40);

QColor lit(const QColor& colour, double share) {
    return {std::clamp(int(colour.red() * share), 0, 255), std::clamp(int(colour.green() * share), 0, 255),
            std::clamp(int(colour.blue() * share), 0, 255)};
}

} // namespace

FlatPalpation::FlatPalpation(const simulation::PalpationParameters& parameters)
    : m_parameters(parameters), m_surface(parameters.tissue.shape) {
    paintRelief();
    findHeightLines();
}

FlatFrame FlatPalpation::frame() const {
    return {.above_mm = above_mm(), .side_mm = side_mm(), .ownTools = true};
}

QRectF FlatPalpation::above_mm() const {
    const core::Vec2 reach = 1e3 * m_parameters.areaHalf_m + core::Vec2::Constant(kBeside_mm);
    return {-reach.x(), -reach.y(), 2.0 * reach.x(), 2.0 * reach.y()};
}

QRectF FlatPalpation::side_mm() const {
    const double reach = 1e3 * m_parameters.areaHalf_m.x() + kBeside_mm;
    const double low = 1e3 * m_parameters.tissue.shape.planeHeight_m - kBelow_mm;
    return {-reach, low, 2.0 * reach, 1e3 * m_surface.highest_m() + kAbove_mm - low};
}

double FlatPalpation::groundHeight_m(const SceneState&, double x_m, double y_m) const {
    return m_surface.heightAt({x_m, y_m}).z_m;
}

/// Shades the relief with light from the upper left, once per level.
void FlatPalpation::paintRelief() {
    const QRectF range = above_mm();
    const QColor bare = tissueColour(tissueLookOf(m_parameters.tissue));
    const Areola areola = areolaOf(m_parameters.tissue);
    const core::Vec3 lamp = core::Vec3(-0.5, 0.6, 0.9).normalized();
    m_relief = QImage(int(2.0 * range.width()), int(2.0 * range.height()), QImage::Format_RGB32);
    for (int y = 0; y < m_relief.height(); ++y)
        for (int x = 0; x < m_relief.width(); ++x) {
            const core::Vec2 xy =
                1e-3 * core::Vec2(range.left() + (x + 0.5) / m_relief.width() * range.width(),
                                  range.bottom() - (y + 0.5) / m_relief.height() * range.height());
            const bool ring = areola.radius_m > 0.0 && (xy - areola.centre_m).norm() < areola.radius_m;
            const double light = 0.40 + 0.75 * std::max(0.0, m_surface.normalAt(xy).dot(lamp));
            m_relief.setPixelColor(x, y, lit(ring ? QColor(188, 118, 102) : bare, light));
        }
}

/// Finds the contour lines by marching squares on a grid of 1 mm.
void FlatPalpation::findHeightLines() {
    const QRectF range = above_mm();
    const double rise_mm = 1e3 * (m_surface.highest_m() - m_parameters.tissue.shape.planeHeight_m);
    m_lineStep_mm = rise_mm > 20.0 ? 5.0 : 2.0;
    if (m_surface.flat())
        return;
    const auto height = [&](double x, double y) {
        return 1e3 * m_surface.heightAt({1e-3 * x, 1e-3 * y}).z_m;
    };
    const double low = 1e3 * m_parameters.tissue.shape.planeHeight_m - rise_mm;
    for (double x = range.left(); x < range.right(); x += 1.0)
        for (double y = range.top(); y < range.bottom(); y += 1.0) {
            const std::array<QPointF, 4> corner{
                QPointF(x, y), {x + 1.0, y}, {x + 1.0, y + 1.0}, {x, y + 1.0}};
            std::array<double, 4> z{};
            for (std::size_t i = 0; i < 4; ++i)
                z[i] = height(corner[i].x(), corner[i].y());
            const auto [least, most] = std::minmax_element(z.begin(), z.end());
            for (double level = low + (std::floor((*least - low) / m_lineStep_mm) + 0.5) * m_lineStep_mm;
                 level < *most; level += m_lineStep_mm) {
                std::vector<QPointF> met;
                for (std::size_t i = 0; i < 4; ++i) {
                    const std::size_t j = (i + 1) % 4;
                    if ((z[i] < level) != (z[j] < level))
                        met.push_back(corner[i] + (level - z[i]) / (z[j] - z[i]) * (corner[j] - corner[i]));
                }
                for (std::size_t i = 0; i + 1 < met.size(); i += 2)
                    m_lines.emplace_back(met[i], met[i + 1]);
            }
        }
}

double FlatPalpation::cut_m(const SceneState& state, const simulation::TissueSurface& surface) {
    double y_m = 0.0;
    double deepest_m = -1.0;
    for (const ToolView& tool : state.tool) {
        if (!tool.present || !tool.p_WT.allFinite())
            continue;
        const simulation::SurfaceFoot foot = surface.nearest(tool.p_WT, tool.p_WT.head<2>());
        const double depth_m = std::max(0.0, foot.depth_m);
        if (depth_m <= deepest_m)
            continue;
        deepest_m = depth_m;
        y_m = foot.p_W.y();
    }
    return y_m;
}

std::vector<core::Vec2> FlatPalpation::profile(const SceneState& state) const {
    std::vector<Dent> dents;
    for (const ToolView& tool : state.tool)
        if (const Dent dent = fingerDent(m_surface, m_parameters.tissue.contactRadius_m, tool);
            dent.depth_m > 0.0)
            dents.push_back(dent);
    const double y_m = cut_m(state, m_surface);
    const double reach_m = 1e-3 * side_mm().right();
    std::vector<double> across;
    for (double x = -reach_m; x <= reach_m; x += kStep_m)
        across.push_back(x);
    for (const Dent& dent : dents) // add the touched points themselves
        across.insert(std::upper_bound(across.begin(), across.end(), dent.p_WSurface.x()),
                      dent.p_WSurface.x());
    std::vector<core::Vec2> points;
    for (const double x : across) {
        core::Vec3 p = m_surface.pointAt({x, y_m});
        for (const Dent& dent : dents)
            p = dent.displaced(p);
        points.emplace_back(p.x(), p.z());
    }
    return points;
}

void FlatPalpation::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                          const SceneState& state) const {
    SceneState seen = state; // a level that hides the hand hides its dents too
    for (ToolView& tool : seen.tool)
        tool.present = tool.present && setup.cues.tool;
    if (panel.side() == FlatPanel::Side::above)
        paintAbove(painter, panel, setup, seen);
    else
        paintSide(painter, panel, setup, seen);
    const FlatFingers fingers(painter, panel, setup, m_surface);
    fingers.paintGhost(seen.ghost);
    fingers.paint(seen);
    paintFindings(painter, panel, setup, seen);
    if (panel.side() != FlatPanel::Side::above)
        paintLegend(painter, panel, setup, seen);
}

void FlatPalpation::paintAbove(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                               const SceneState& state) const {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(panel.plot(), m_relief);
    paintLines(painter, panel, setup);
    paintMap(painter, panel, setup, state);
    paintLumps(painter, panel, setup, state);
    const core::Vec2 half = 1e3 * m_parameters.areaHalf_m;
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kDeepEdge.darker(160), (setup.colours.highContrast ? 3.0 : 2.0) * panel.unit()));
    painter.drawRect(QRectF(panel.at(-half.x(), half.y()), panel.at(half.x(), -half.y())));
}

QString FlatPalpation::lineWords(double step_mm, double room_px, const QFontMetricsF& font) {
    const QString step = QLocale().toString(step_mm, 'f', 0);
    for (const QString& words : {tr("Contour lines every %1 mm").arg(step), tr("Lines: %1 mm").arg(step)})
        if (font.horizontalAdvance(words) <= room_px)
            return words;
    return {};
}

void FlatPalpation::paintLines(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup) const {
    QColor ink = kDeepEdge;
    ink.setAlphaF(setup.colours.highContrast ? 1.0F : 0.55F);
    painter.setPen(QPen(ink, (setup.colours.highContrast ? 1.6 : 1.0) * panel.unit()));
    for (const QLineF& line : m_lines)
        painter.drawLine(panel.at(line.x1(), line.y1()), panel.at(line.x2(), line.y2()));
    if (m_lines.empty())
        return;
    painter.setFont(panel.font(11, false));
    painter.setPen(QColor(30, 14, 14));
    const QRectF room = QRectF(panel.plot()).adjusted(6, 4, -6, -4);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignTop,
                     lineWords(m_lineStep_mm, room.width(), painter.fontMetrics()));
}

void FlatPalpation::paintMap(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                             const SceneState& state) const {
    const auto& overlay = state.overlay.of<PalpationOverlay>();
    if (!overlay.map)
        return;
    const core::Vec2 half = 1e3 * m_parameters.areaHalf_m;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(panel.at(-half.x(), half.y()), panel.at(half.x(), -half.y())),
                      mapPicture(*overlay.map, setup, overlay.mapKind));
}

/// Draws the lumps, which are below the surface, as translucent; a missed one has stripes and a dashed edge.
void FlatPalpation::paintLumps(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                               const SceneState& state) const {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    for (int i = 0; cues.present && i < cues.lumps; ++i) {
        const simulation::LumpCue& lump = cues.lump[std::size_t(i)];
        const QPointF at = panel.project({lump.p_W[0], lump.p_W[1], lump.p_W[2]});
        const double radius = panel.pixels(1e3 * lump.radius_m);
        const bool missed = (state.overlay.of<PalpationOverlay>().lumpsMissed >> i & 1) != 0;
        painter.setPen(Qt::NoPen);
        painter.setBrush(QColor(110, 34, 52, 150));
        painter.drawEllipse(at, radius, radius);
        if (missed) {
            painter.setBrush(QBrush(QColor(255, 246, 236), Qt::DiagCrossPattern));
            painter.drawEllipse(at, radius, radius);
        }
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(48, 6, 18), (setup.colours.highContrast ? 3.0 : 2.0) * panel.unit(),
                            missed ? Qt::DashLine : Qt::SolidLine));
        painter.drawEllipse(at, radius, radius);
    }
}

void FlatPalpation::paintFindings(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                                  const SceneState& state) const {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    const double u = panel.unit();
    for (std::size_t i = 0; cues.present && i < simulation::kMaxFindings; ++i) {
        const simulation::Finding& finding = cues.finding[i];
        if (!finding.present)
            continue;
        const QPointF foot = panel.project({finding.p_W[0], finding.p_W[1], finding.p_W[2]});
        const bool above = panel.side() == FlatPanel::Side::above;
        if (above) { // a lump within this circle counts as found
            const double reach = panel.pixels(1e3 * m_parameters.hitRadius_m);
            painter.setBrush(Qt::NoBrush);
            for (const auto& [colour, wide] :
                 {std::pair{setup.colours.background, 4.0}, {setup.colours.ink, 1.8}}) {
                painter.setPen(QPen(colour, wide * u));
                painter.drawEllipse(foot, reach, reach);
            }
        }
        if (above && finding.radius_m > 0.0) { // in the reported size
            painter.setBrush(Qt::NoBrush);
            painter.setPen(QPen(QColor(20, 12, 14), 1.5 * u, Qt::DotLine));
            painter.drawEllipse(foot, panel.pixels(1e3 * finding.radius_m),
                                panel.pixels(1e3 * finding.radius_m));
        }
        const QPointF head = above ? foot : foot - QPointF(0.0, 26.0 * u);
        if (!above) {
            painter.setPen(QPen(setup.colours.ink, 2.0 * u));
            painter.drawLine(foot, head);
        }
        const double side = 34.0 * u;
        paintFindingFlag(painter, QRectF(head - QPointF(0.5 * side, 0.5 * side), QSizeF(side, side)),
                         {static_cast<int>(i) + 1, state.overlay.of<PalpationOverlay>().outcome[i],
                          cues.selected == static_cast<int>(i)},
                         setup);
    }
}

void FlatPalpation::paintSide(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                              const SceneState& state) const {
    QPolygonF edge;
    for (const core::Vec2& p : profile(state))
        edge << panel.at(1e3 * p.x(), 1e3 * p.y());
    QPainterPath body;
    body.addPolygon(edge);
    body.lineTo(edge.last().x(), panel.plot().bottom());
    body.lineTo(edge.first().x(), panel.plot().bottom());
    body.closeSubpath();
    const QColor bare = tissueColour(tissueLookOf(m_parameters.tissue));
    QLinearGradient depth(panel.at(0.0, 1e3 * m_surface.highest_m()),
                          QPointF(panel.at(0.0, 0.0).x(), panel.plot().bottom()));
    depth.setColorAt(0.0, bare.lighter(106));
    depth.setColorAt(1.0, bare.darker(150));
    painter.fillPath(body, depth);
    paintLumps(painter, panel, setup, state);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kDeepEdge, (setup.colours.highContrast ? 3.0 : 2.0) * panel.unit()));
    painter.drawPolyline(edge);
}

void FlatPalpation::paintLegend(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                                const SceneState& state) const {
    if (!state.overlay.of<PalpationOverlay>().map)
        return;
    const MapLegend legend = MapLegend::of(setup, state);
    const QRectF plot = panel.plot();
    const double unit = std::min(panel.unit(), 0.55 * plot.height() / legend.size().height());
    // In the corner away from the finger.
    const bool right = state.tool[0].present && drawnTip(state.tool[0]).x() < 0.0;
    painter.save();
    painter.translate(right ? plot.right() - legend.size().width() * unit - 6.0 : plot.left() + 6.0,
                      plot.top() + 6.0);
    painter.scale(unit, unit);
    legend.paint(painter);
    painter.restore();
}

std::vector<std::string> FlatPalpation::marks(const simulation::PalpationParameters& parameters,
                                              const MarkedScene& scene) {
    std::vector<std::string> marks = stageMarks(scene.setup, parameters.tools());
    marks.insert(marks.end(), {"search_area", "finding"});
    if (scene.setup.cues.tool)
        marks.push_back("finger_ring");
    if (scene.setup.cues.object)
        marks.push_back("lump");
    if (scene.coverage)
        marks.push_back("hatching");
    if (scene.feedback)
        marks.push_back("lump_answer");
    return marks;
}

} // namespace chiron::scene3d
