// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_layer.h"

#include "app/exercises/palpation/desktop/palpation_plots.h"
#include "app/exercises/palpation/desktop/palpation_words.h"
#include "report/report_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {

constexpr char kTruth[] = "truth", kWholeTrial[] = "whole_trial", kForceMap[] = "force_map";

} // namespace

QString PalpationLayer::lost() const {
    return m_why ? PlaybackTexts::tr("Findings and maps could not be read from the recording: %1")
                       .arg(QString::fromStdString(m_why->message))
                 : QString();
}

std::vector<PlaybackSwitch> PalpationLayer::switches() const {
    if (!m_replay)
        return {};
    return {{kTruth, PlaybackTexts::tr("Show the lumps"),
             PlaybackTexts::tr("Where the lumps were, and how the findings were scored"), true},
            {kWholeTrial, PlaybackTexts::tr("Map of the whole trial"),
             PlaybackTexts::tr("Off: the map up to this moment"), false},
            {kForceMap, PlaybackTexts::tr("Force map"),
             PlaybackTexts::tr("On: how hard the tissue was pressed. Off: where it was searched."), false}};
}

void PalpationLayer::turn(std::string_view key, bool on) {
    if (key == kTruth)
        m_look.truth = on;
    else if (key == kWholeTrial)
        m_look.wholeTrial = on;
    else if (key == kForceMap)
        m_look.map = on ? simulation::SurfaceMapKind::force : simulation::SurfaceMapKind::coverage;
}

void PalpationLayer::showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                            const session::PlaybackView&, double t_s) {
    if (m_replay)
        m_replay->showIn(state, track, t_s, m_look);
}

void PalpationLayer::addPlots(PlaybackPlots& plots) const {
    addPalpationPlots(plots);
}

QString PalpationLayer::readout(const session::PlaybackTrack& track, const session::PlaybackView& view,
                                double t_s, const QLocale& locale) const {
    if (!m_replay)
        return trialReadout(view, locale);
    const simulation::PalpationCues cues = m_replay->cuesAt(track, t_s, false);
    std::size_t hardest = 0; // of several fingers, the one that presses hardest
    for (std::size_t i = 1; i < view.tools.size(); ++i)
        if (view.tools[i].tissue_N.norm() > view.tools[hardest].tissue_N.norm())
            hardest = i;
    const QString trial = locale.toString(view.moment.trial + 1);
    const QString force =
        report::formatValue(view.tools[hardest].tissue_N.norm(), QStringLiteral("N"), locale);
    const QString lean = locale.toString(qRound(cues.lean_rad[hardest] * 180.0 / std::numbers::pi));
    const QString depth = report::formatValue(1e3 * cues.depth_m[hardest], QStringLiteral("mm"), locale);
    const QString searched = locale.toString(static_cast<int>(100.0 * cues.coverage));
    const QString findings = locale.toString(findingCount(cues));
    const double squeeze_N = std::max(cues.squeeze_N[0], cues.squeeze_N[1]);
    const QString squeeze =
        squeeze_N > 0.0
            ? QStringLiteral(" · ") + PlaybackTexts::tr("squeeze %1")
                                          .arg(report::formatValue(squeeze_N, QStringLiteral("N"), locale))
            : QString();
    return (view.moment.paused
                ? PlaybackTexts::tr(
                      "Trial %1 · %7 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6")
                      .arg(trial, force, lean, depth, searched, findings, stillWords(view.moment))
                : PlaybackTexts::tr("Trial %1 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6")
                      .arg(trial, force, lean, depth, searched, findings)) +
           squeeze;
}

} // namespace chiron::desktop
