// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/desktop/object_handling_face.h"

#include "app/exercises/object_handling/desktop/handling_grasping.h"
#include "app/exercises/object_handling/desktop/handling_layer.h"
#include "app/exercises/object_handling/desktop/handling_picture.h"
#include "app/exercises/object_handling/session_report/handling_report_of.h"
#include "core/units.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/debrief/part_widgets.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/training/grasp_part.h"

#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace chiron::desktop {

namespace {

class HandlingDebrief final : public DebriefPart {
public:
    explicit HandlingDebrief(report::HandlingReport handling) : m_handling(std::move(handling)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (m_handling.rows.empty())
            return nullptr;
        const report::PlotTheme look = plotThemeOf(theme, locale);
        PartColumn column(theme);
        auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
        row->add(partPlot(theme, report::squeezePlot(m_handling, look), "debrief.squeeze", 280), 3);
        row->add(partPlot(theme, report::placePlot(m_handling, look), "debrief.place", 280), 2);
        column.layout->addWidget(row);
        column.layout->addWidget(
            trialTable(theme, report::handlingTable(m_handling, locale), "debrief.handling_trials"));
        return std::move(column.holder);
    }

private:
    report::HandlingReport m_handling;
};

/// How far from the middle of the ring the object lies that was held last, as it is scored.
class PlacedBesideTarget final : public MarkAnswer {
public:
    void follow(const haptics::DisplayState& state) override {
        const auto& cues = state.exercise.of<core::LaparoscopyCues>();
        if (state.phase == core::TrialPhase::ready || state.trial != m_trial)
            m_last.reset();
        m_trial = state.trial;
        const int bodies =
            cues.present ? std::min(cues.bodies, static_cast<int>(core::LaparoscopyCues::kMaxBodies)) : 0;
        for (int i = 0; i < bodies; ++i)
            if (cues.body[static_cast<std::size_t>(i)].heldBy != 0)
                m_last = i;
        if (m_last && *m_last < bodies)
            m_p_W = cues.body[static_cast<std::size_t>(*m_last)].p_W;
    }
    QString endWords(const session::TrialObject& target, const QLocale& locale) const override {
        if (!m_last)
            return {};
        const double beside_m = std::hypot(m_p_W[0] - target.p_WObject.x(), m_p_W[1] - target.p_WObject.y());
        return AnswerTexts::tr("%1 mm from the middle of the ring")
            .arg(locale.toString(core::mmFromM(beside_m), 'f', 1));
    }

private:
    int m_trial = -1;
    std::optional<int> m_last; ///< the object that was held last; empty: none was held yet
    std::array<double, 3> m_p_W{};
};

QStringList handlingFacts(const simulation::ObjectHandlingParameters& p, const QLocale& locale) {
    QStringList facts;
    if (p.task == simulation::HandlingTask::weigh)
        facts << LevelFactTexts::tr("Goal: put the heaviest of %1 identical-looking objects inside the ring")
                     .arg(locale.toString(p.objects));
    else
        facts << LevelFactTexts::tr("Goal: lift the object by %1 mm and put it inside the ring")
                     .arg(locale.toString(qRound(p.liftHeight_m * 1e3)));
    if (p.organBed)
        facts << LevelFactTexts::tr("Surface: a soft organ that deforms");
    return facts << trialsFact(p.trials, p.trialLimit_s, locale);
}

} // namespace

std::unique_ptr<LevelPicture> ObjectHandlingFace::picture(const catalogue::ExerciseLevel& level,
                                                          const PictureFrame& frame) const {
    return std::make_unique<HandlingPicture>(level.parameters.as<simulation::ObjectHandlingParameters>(),
                                             frame);
}

QStringList ObjectHandlingFace::levelFacts(const catalogue::ExerciseLevel& level,
                                           const QLocale& locale) const {
    return handlingFacts(level.parameters.as<simulation::ObjectHandlingParameters>(), locale);
}

QStringList ObjectHandlingFace::limitWords(const session::LevelLimits& limits, const QLocale& locale) const {
    QStringList words;
    if (const auto squeeze_N = limits.of("squeeze_max"))
        words << GateTexts::tr("Squeeze: %1 N at most").arg(factNumber(*squeeze_N, locale));
    if (const auto placement_mm = limits.of("placement_error"))
        words << GateTexts::tr("At the end: %1 mm from the middle of the ring at most, on average")
                     .arg(factNumber(*placement_mm, locale));
    return words;
}

std::unique_ptr<LivePart> ObjectHandlingFace::livePart(const catalogue::ExerciseLevel& level,
                                                       LiveSurroundings around) const {
    const auto& p = level.parameters.as<simulation::ObjectHandlingParameters>();
    return std::make_unique<GraspPart>(handlingGrasping(p, session::levelLimits(level)), level.feedback,
                                       std::move(around));
}

std::unique_ptr<TrialAnswer> ObjectHandlingFace::trialAnswer() const {
    return std::make_unique<PlacedBesideTarget>();
}

QString ObjectHandlingFace::debriefTitle() const {
    return DebriefPartTexts::tr("How each object was held and set down");
}

QString ObjectHandlingFace::debriefEmpty() const {
    return DebriefPartTexts::tr("There is no object to show. The session is kept and listed.");
}

DebriefReading ObjectHandlingFace::readDebrief(const catalogue::ExerciseLevel& level,
                                               const scoring::SessionTrace& trace) const {
    return std::make_unique<HandlingDebrief>(session_report::handlingReportOf(trace, level));
}

std::unique_ptr<PlaybackLayer> ObjectHandlingFace::playbackLayer(const session::SessionSetup& setup,
                                                                 const scoring::SessionTrace&) const {
    return std::make_unique<HandlingLayer>(setup.level.parameters.as<simulation::ObjectHandlingParameters>(),
                                           setup.seed);
}

} // namespace chiron::desktop
