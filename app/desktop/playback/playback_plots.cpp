// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_plots.h"

#include "desktop/plots/plot_theme_of.h"
#include "report/session_plots.h"
#include "session_report/track_series.h"

#include <QVBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kLeftMargin = 64.0;
constexpr int kForceHeight_px = 170;
constexpr int kSpeedHeight_px = 134;
} // namespace

PlaybackPlots::PlaybackPlots(const Theme& theme, const QLocale& locale, const session::PlaybackTrack& track, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_series(session_report::seriesOf(track)),
      m_limit_N(track.forceLimit_N), m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(theme.px(4));
    setGhost({}, {});
}

void PlaybackPlots::put(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name, int height_px) {
    delete member;
    member = view.release(); // the layout's widget owns it
    member->setObjectName(QLatin1String(name));
    member->setMinimumHeight(m_theme.px(height_px));
    member->setLeftMargin(kLeftMargin);
    member->onSeek([this](double t_s) { emit seekAsked(t_s); });
    m_column->addWidget(member);
    member->showCursor(m_cursor_s);
}

void PlaybackPlots::setGhost(const std::optional<session::GhostSeries>& ghost, const QString& name) {
    const report::PlotTheme look = plotThemeOf(m_theme, m_locale);
    auto force = report::forcePlot(m_series, m_limit_N, look);
    auto speed = report::speedPlot(m_series, look);
    if (ghost) {
        std::vector<double> speed_mm_per_s;
        for (const double v : ghost->speed_m_per_s)
            speed_mm_per_s.push_back(1e3 * v);
        force->addLine(name, ghost->t_s, ghost->tissue_N, report::PlotStyle::dashDotD);
        speed->addLine(name, ghost->t_s, speed_mm_per_s, report::PlotStyle::dashDotD);
    }
    // Axis labels name what is drawn, and the lower plot has the time of both: room for the lines instead.
    const auto slim = [this](report::PlotView& view, const QString& time) {
        const QString spoken = view.accessibleName();
        view.setTitle({});
        view.setAccessibleName(spoken);
        if (!m_series.t_s.empty())
            view.setXAxis({time, 0.0, std::max(m_series.t_s.back(), 1e-3)});
    };
    slim(*force, {});
    slim(*speed, tr("Time (s)"));
    speed->setLegendShown(false); // the same lines as above
    speed->setYAxis({QString(), 0.0, {}}); // across the top instead: no language's word for it fits up the side of a low plot
    speed->setTitle(tr("Speed (mm/s)"));
    put(std::move(force), m_force, "playback.force", kForceHeight_px);
    put(std::move(speed), m_speed, "playback.speed_plot", kSpeedHeight_px);
}

void PlaybackPlots::showCursor(double t_s) {
    m_cursor_s = t_s;
    m_force->showCursor(t_s);
    m_speed->showCursor(t_s);
}

} // namespace chiron::desktop
