// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/playback_plots.h"

#include "desktop/plots/plot_theme_of.h"
#include "desktop/widgets/kit.h"
#include "report/session_plots.h"
#include "session_report/track_series.h"

#include <QVBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kLeftMargin = 64.0;
constexpr int kForceHeight_px = 170;
constexpr int kLowHeight_px = 134;
constexpr double kZoomStep = 0.5;
constexpr double kLeast_s = 0.5;   // some hundred samples; a further zoom shows nothing more
constexpr double kPageLead = 0.05; // share of the page before the cursor after a page turn
} // namespace

PlaybackPlots::PlaybackPlots(const Theme& theme, const QLocale& locale, const session::PlaybackTrack& track,
                             const catalogue::ExerciseLevel& level, const PlaybackLayer* layer, bool books,
                             QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_track(track), m_layer(layer),
      m_series(session_report::seriesOf(track, level, locale)), m_limit_N(track.forceLimit_N), m_books(books),
      m_column(new QVBoxLayout(this)) {
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(theme.px(4));
    m_to_s = end_s();
    m_column->addWidget(zoomRow());
    setGhost({}, {});
}

double PlaybackPlots::end_s() const {
    return m_series.t_s.empty() ? 1e-3 : std::max(m_series.t_s.back(), 1e-3);
}

QWidget* PlaybackPlots::zoomRow() {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addStretch(1);
    const auto add = [&](const char* name, const char* icon, const QString& text, auto act) {
        QPushButton* button = kit::iconButton(m_theme, QLatin1String(icon), text);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        line->addWidget(button);
        return button;
    };
    m_zoomIn =
        add("playback.zoom_in", "zoom-in", tr("Zoom in: show less time (+)"), [this] { zoom(kZoomStep); });
    m_zoomOut = add("playback.zoom_out", "zoom-out", tr("Zoom out: show more time (-)"),
                    [this] { zoom(1.0 / kZoomStep); });
    m_zoomWhole = add("playback.zoom_whole", "zoom-fit-width", tr("Show the whole session (0)"),
                      [this] { zoomWhole(); });
    showButtons();
    return row;
}

void PlaybackPlots::zoom(double factor) {
    const double whole_s = end_s();
    const double wide_s = std::clamp((m_to_s - m_from_s) * factor, std::min(kLeast_s, whole_s), whole_s);
    const double share = (m_cursor_s - m_from_s) / (m_to_s - m_from_s);
    const double from_s =
        std::clamp(m_cursor_s - std::clamp(share, 0.0, 1.0) * wide_s, 0.0, whole_s - wide_s);
    showWindow(from_s, from_s + wide_s);
}

/// Disables buttons that would do nothing.
void PlaybackPlots::showButtons() {
    const double wide_s = m_to_s - m_from_s;
    m_zoomIn->setEnabled(wide_s > std::min(kLeast_s, end_s()));
    m_zoomOut->setEnabled(wide_s < end_s());
    m_zoomWhole->setEnabled(wide_s < end_s());
}

void PlaybackPlots::zoomWhole() {
    showWindow(0.0, end_s());
}

void PlaybackPlots::showWindow(double from_s, double to_s) {
    m_from_s = from_s;
    m_to_s = to_s;
    showButtons();
    for (report::PlotView* view : views())
        view->setXWindow(from_s, to_s);
}

report::PlotView* PlaybackPlots::laidOut(std::unique_ptr<report::PlotView> plot, const char* name,
                                         int height_px) {
    report::PlotView* view = plot.release(); // the layout's widget owns it
    view->setObjectName(QLatin1String(name));
    view->setMinimumHeight(m_theme.px(height_px));
    view->setLeftMargin(kLeftMargin);
    view->onSeek([this](double t_s) { emit seekAsked(t_s); });
    m_column->addWidget(view);
    view->showCursor(m_cursor_s);
    return view;
}

void PlaybackPlots::put(std::unique_ptr<report::PlotView> view, report::PlotView*& member, const char* name,
                        int height_px) {
    delete member;
    member = laidOut(std::move(view), name, height_px);
}

std::unique_ptr<report::PlotView> PlaybackPlots::empty(const QString& title) const {
    auto view = std::make_unique<report::PlotView>(plotThemeOf(m_theme, m_locale));
    view->setTitle(title);
    view->setAccessibleName(title);
    return view;
}

void PlaybackPlots::add(std::unique_ptr<report::PlotView> view, const char* name, const LayerPlotLook& look) {
    slim(*view, {});
    view->setLegendShown(look.legend);
    view->setYAxis({QString(), look.minimum, look.maximum});
    view->setTitle(look.quantity);
    m_ofLayer.push_back(laidOut(std::move(view), name, kLowHeight_px));
}

void PlaybackPlots::addSecond(report::PlotView& view, std::string_view derived, double factor) const {
    if (!m_ghost)
        return;
    for (const session::PlaybackQuantity& series : m_ghost->derived)
        if (series.id == derived)
            addSecondLine(view, series.values, factor);
}

void PlaybackPlots::addSecondLine(report::PlotView& view, std::span<const double> values,
                                  double factor) const {
    if (values.empty())
        return;
    std::vector<double> scaled;
    for (const double value : values)
        scaled.push_back(factor * value);
    const bool several = m_series.tools.size() > 1; // a ghost shows its first tool
    view.addLine(several ? tr("%1: %2").arg(m_ghostName, m_series.tools.front().name) : m_ghostName,
                 m_ghost->t_s, scaled, report::PlotStyle::dashDotD);
}

std::vector<report::PlotView*> PlaybackPlots::views() const {
    std::vector<report::PlotView*> views(m_ofLayer);
    for (report::PlotView* view : {m_force, m_felt, m_speed})
        if (view)
            views.push_back(view);
    return views;
}

void PlaybackPlots::setGhost(const std::optional<session::GhostSeries>& ghost, const QString& name) {
    const report::PlotTheme look = plotThemeOf(m_theme, m_locale);
    m_ghost = ghost ? &*ghost : nullptr;
    m_ghostName = name;
    auto force = report::forcePlot(m_series, m_limit_N, look);
    if (m_ghost)
        addSecondLine(*force, m_ghost->tissue_N, 1.0);
    slim(*force, {});
    if (m_series.tools.size() > 1)
        force->setYAxis({tr("Tissue force (N)"), 0.0, {}}); // the felt force has a plot of its own
    put(std::move(force), m_force, "playback.force", kForceHeight_px);
    if (auto felt = report::feltForcePlot(m_series, m_limit_N, look))
        putLow(std::move(felt), m_felt, "playback.felt_plot", tr("Force felt (N)"), false);
    for (report::PlotView* view : m_ofLayer)
        delete view;
    m_ofLayer.clear();
    if (m_layer)
        m_layer->addPlots(*this);
    auto speed = report::speedPlot(m_series, look);
    if (m_ghost)
        addSecondLine(*speed, m_ghost->speed_m_per_s, 1e3);
    putLow(std::move(speed), m_speed, "playback.speed_plot", tr("Speed (mm/s)"), true);
    m_ghost = nullptr;
}

// Removes axis labels: the title names the quantity, and the lowest plot shows the time for all. The space
// goes to the lines.
void PlaybackPlots::slim(report::PlotView& view, const QString& time) {
    const QString spoken = view.accessibleName();
    view.setTitle({});
    view.setAccessibleName(spoken);
    if (!m_series.t_s.empty())
        view.setXAxis({time, m_from_s, m_to_s});
}

void PlaybackPlots::putLow(std::unique_ptr<report::PlotView> view, report::PlotView*& member,
                           const char* name, const QString& quantity, bool last) {
    slim(*view, last ? tr("Time in the recording (s)") : QString());
    view->setLegendShown(false); // same lines as above
    view->setYAxis({QString(), 0.0, {}});
    view->setTitle(quantity);
    put(std::move(view), member, name, kLowHeight_px);
}

void PlaybackPlots::showCursor(double t_s) {
    m_cursor_s = t_s;
    if (t_s < m_from_s || t_s > m_to_s) { // turns the page, like a chart recorder
        const double wide_s = m_to_s - m_from_s;
        const double from_s = std::clamp(t_s - kPageLead * wide_s, 0.0, std::max(0.0, end_s() - wide_s));
        showWindow(from_s, from_s + wide_s);
    }
    for (report::PlotView* view : views())
        view->showCursor(t_s);
}

} // namespace chiron::desktop
