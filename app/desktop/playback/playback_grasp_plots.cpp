// SPDX-License-Identifier: GPL-3.0-or-later
// Tension or squeeze over time with what was asked for, and the books of energy: what was put in and what is held.
#include "desktop/playback/playback_plots.h"
#include "desktop/plots/plot_theme_of.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::desktop {

namespace {

constexpr int kGraspHeight_px = 134;
constexpr double kNoise_J = 1e-5; // below, recorded energies differ by their rounding

struct Stepped {
    std::vector<double> t_s;
    std::vector<double> low;
    std::vector<double> high;
};

/// The band of each trial over its time, with gaps between.
Stepped bands(const session::PlaybackTrack& track, const GraspReplay& grasp) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    Stepped steps;
    for (const session::PlaybackTrial& trial : track.trials) {
        const GraspReplay::Band band = grasp.bandOf(trial.index);
        if (!(band.high_N > 0.0))
            continue;
        for (const double t : {trial.start_s, trial.end_s}) {
            steps.t_s.push_back(t);
            steps.low.push_back(band.low_N);
            steps.high.push_back(band.high_N);
        }
        steps.t_s.push_back(trial.end_s);
        steps.low.push_back(kGap);
        steps.high.push_back(kGap);
    }
    return steps;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> out;
    out.reserve(values.size());
    for (const double value : values)
        out.push_back(factor * value);
    return out;
}

/// Where more is held than was put in.
std::vector<report::TimeSpan> made(const std::vector<double>& t_s, const std::vector<double>& in, const std::vector<double>& held) {
    std::vector<report::TimeSpan> spans;
    bool open = false;
    for (std::size_t i = 0; i < t_s.size(); ++i) {
        const bool more = held[i] > in[i] + kNoise_J;
        if (more && !open)
            spans.push_back({t_s[i], t_s[i]});
        if (more)
            spans.back().end_s = t_s[i];
        open = more;
    }
    return spans;
}

} // namespace

std::unique_ptr<report::PlotView> PlaybackPlots::empty(const QString& title) const {
    auto view = std::make_unique<report::PlotView>(plotThemeOf(m_theme, m_locale));
    view->setTitle(title);
    view->setAccessibleName(title);
    return view;
}

void PlaybackPlots::putGrasp() {
    const bool tension = m_track.quantity("tension_N") != nullptr;
    const session::PlaybackQuantity* quantity = tension ? m_track.quantity("tension_N") : m_track.quantity("squeeze_N");
    if (!m_grasp || !quantity || quantity->values.empty())
        return;
    auto view = empty(tension ? tr("Tension of the tube") : tr("Squeeze of the jaws"));
    if (tension) {
        const Stepped steps = bands(m_track, *m_grasp);
        if (!steps.t_s.empty()) {
            view->addLine(tr("band, from"), steps.t_s, steps.low, report::PlotStyle::dashedB);
            view->addLine(tr("band, to"), steps.t_s, steps.high, report::PlotStyle::dashedB);
        }
    } else {
        view->shadeAbove(tr("over the limit"), m_series.t_s, quantity->values, m_grasp->squeezeLimit_N());
        view->addLimit(tr("limit"), m_grasp->squeezeLimit_N());
    }
    view->addLine(tension ? tr("tension") : tr("squeeze"), m_series.t_s, quantity->values, report::PlotStyle::solidA);
    view->addHatchedSpans(tr("paused"), m_series.paused);
    slim(*view, {});
    view->setYAxis({QString(), 0.0, {}});
    view->setTitle(tension ? tr("Tension (N), dashed: target band") : tr("Squeeze (N)"));
    view->setLegendShown(false);
    put(std::move(view), m_held, "playback.grasp_plot", kGraspHeight_px);
}

void PlaybackPlots::putRetraction() {
    const session::PlaybackQuantity* pull = m_track.quantity("retraction_N");
    if (!m_grasp || !pull || pull->values.empty())
        return;
    auto view = empty(tr("Pull on the fold of tissue"));
    const GraspReplay::Band band = m_grasp->retractionBand();
    const std::vector<double> ends{m_series.t_s.empty() ? 0.0 : m_series.t_s.front(), m_series.t_s.empty() ? 0.0 : m_series.t_s.back()};
    view->addLine(tr("band, from"), ends, std::vector<double>(2, band.low_N), report::PlotStyle::dashedB);
    view->addLine(tr("band, to"), ends, std::vector<double>(2, band.high_N), report::PlotStyle::dashedB);
    view->addLine(tr("pull"), m_series.t_s, pull->values, report::PlotStyle::solidA);
    view->addHatchedSpans(tr("paused"), m_series.paused);
    slim(*view, {});
    view->setYAxis({QString(), 0.0, {}});
    view->setTitle(tr("Pull on the fold (N), dashed: target band"));
    view->setLegendShown(false);
    put(std::move(view), m_retraction, "playback.retraction_plot", kGraspHeight_px);
}

void PlaybackPlots::putEnergy() {
    const session::PlaybackQuantity* in = m_track.quantity("energy_supplied_J");
    const session::PlaybackQuantity* held = m_track.quantity("energy_stored_J");
    if (!m_books || !m_grasp || !in || !held || in->values.empty() || held->values.size() != in->values.size())
        return;
    auto view = empty(tr("Energy supplied by the hand and stored in the object"));
    const std::vector<report::TimeSpan> excess = made(m_series.t_s, in->values, held->values);
    if (!excess.empty())
        view->addHatchedSpans(tr("more stored than supplied"), excess);
    view->addLine(tr("supplied"), m_series.t_s, scaled(in->values, 1e3), report::PlotStyle::dashedB);
    view->addLine(tr("stored"), m_series.t_s, scaled(held->values, 1e3), report::PlotStyle::solidA);
    slim(*view, {});
    view->setYAxis({QString(), {}, {}});
    view->setTitle(tr("Energy (mJ)"));
    put(std::move(view), m_energy, "playback.energy_plot", kGraspHeight_px);
}

} // namespace chiron::desktop
