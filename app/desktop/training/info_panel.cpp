// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/info_panel.h"

#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/widgets/kit.h"

#include <QGridLayout>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr double kSpeedAxis_mm_per_s = 60.0;

template <class A> double norm3(const A& v, std::size_t at = 0) {
    return std::hypot(v[at], v[at + 1], v[at + 2]);
}

} // namespace

InfoPanel::InfoPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues, Limits limits,
                     QWidget* parent)
    : InfoView(theme, {.edge_px = 10.0, .gap_px = 8.0}, parent), m_theme(theme), m_locale(locale),
      m_cues(cues), m_limits(limits) {
    addElapsed(kit::label(theme, {}, TextStyle::strong));
    if (cues.bars)
        addBars();
    if (cues.numbers)
        addNumbers();
    if (cues.plots)
        addPlots();
    addFoot(cues, cues.bars || cues.numbers || cues.plots);
}

void InfoPanel::addBars() {
    m_force = new ForceBar(m_theme, m_locale, {tr("Force"), tr("N"), m_limits.force_N, 2}, m_cues.numbers);
    m_force->setObjectName(QStringLiteral("training.force_bar"));
    parts().addWidget(m_force);
    m_torque = new ForceBar(m_theme, m_locale, {tr("Torque"), tr("mN·m"), m_limits.torque_Nm * 1e3, 0},
                            m_cues.numbers);
    m_torque->setObjectName(QStringLiteral("training.torque_bar"));
    parts().addWidget(m_torque);
    addDetail(m_torque);
}

void InfoPanel::addNumbers() {
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(kit::label(m_theme, tr("Tip of the tool (mm)"), TextStyle::label));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(m_theme.px(8));
    grid->setVerticalSpacing(0);
    m_tip[0] = addNumber(tr("right"), QStringLiteral("training.tip_x"), *grid, 0);
    m_tip[1] = addNumber(tr("away"), QStringLiteral("training.tip_y"), *grid, 1);
    m_tip[2] = addNumber(tr("up"), QStringLiteral("training.tip_z"), *grid, 2);
    column->addLayout(grid);
    parts().addWidget(numbers);
    addDetail(numbers);
}

QLabel* InfoPanel::addNumber(const QString& name, const QString& objectName, QGridLayout& grid, int column) {
    grid.addWidget(kit::label(m_theme, name, TextStyle::small, "muted"), 0, column);
    auto* number = kit::line(m_theme, {}, TextStyle::mono);
    number->setObjectName(objectName);
    number->setAccessibleName(name);
    grid.addWidget(number, 1, column);
    grid.setColumnStretch(column, 1);
    return number;
}

void InfoPanel::addPlots() {
    m_forcePlot = new LivePlot(m_theme, m_locale, tr("Force (N)"), m_limits.force_N * 1.25, m_limits.force_N);
    m_forcePlot->setObjectName(QStringLiteral("training.force_plot"));
    parts().addWidget(m_forcePlot, 1);
    if (m_cues.bars)
        addSpare(m_forcePlot);
    m_speedPlot = new LivePlot(m_theme, m_locale, tr("Speed (mm/s)"), kSpeedAxis_mm_per_s);
    m_speedPlot->setObjectName(QStringLiteral("training.speed_plot"));
    parts().addWidget(m_speedPlot, 1);
    addDetail(m_speedPlot);
}

void InfoPanel::showMoving(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    const haptics::ToolDisplay& tool = state.tool[0];
    if (m_force) {
        m_force->setValue(norm3(tool.tissue));
        m_torque->setValue(norm3(tool.tissue, 3) * 1e3);
    }
    if (!m_forcePlot)
        return;
    for (const session::LiveSample& sample : samples) {
        m_forcePlot->add(sample.t_s, static_cast<double>(sample.tissueNorm_N));
        m_speedPlot->add(sample.t_s, static_cast<double>(sample.speed_m_per_s) * 1e3);
    }
    m_forcePlot->update();
    m_speedPlot->update();
}

void InfoPanel::showReadings(const haptics::DisplayState& state) {
    if (!m_cues.numbers)
        return;
    const haptics::ToolDisplay& tool = state.tool[0];
    // Shows the position where the tip is drawn: at the surface, if the device cannot keep the hand there.
    const std::array<double, 3>& tip_m = tool.rendersForce ? tool.p_WT_m : tool.p_WProxy_m;
    for (std::size_t i = 0; i < m_tip.size(); ++i)
        // Adding 0 avoids a minus sign before 0.0.
        m_tip[i]->setText(m_locale.toString(std::round(tip_m[i] * 1e4) / 10.0 + 0.0, 'f', 1));
}

} // namespace chiron::desktop
