// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/desktop/sphere_apex_face.h"

#include "app/exercises/sphere_apex/desktop/apex_picture.h"
#include "app/exercises/sphere_apex/session_report/apex_errors.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/debrief/part_widgets.h"
#include "desktop/plots/responsive_row.h"
#include "scoring/prepared_trial.h"

#include <cmath>

namespace chiron::desktop {

namespace {

class ApexDebrief final : public DebriefPart {
public:
    explicit ApexDebrief(std::vector<report::ApexError> errors) : m_errors(std::move(errors)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (m_errors.empty())
            return nullptr;
        const report::PlotTheme look = plotThemeOf(theme, locale);
        auto row = std::make_unique<ResponsiveRow>(theme.px(640), theme.px(12));
        row->add(partPlot(theme, report::apexScatterPlot(m_errors, look), "debrief.scatter", 280), 2);
        row->add(partPlot(theme, report::apexTrialPlot(m_errors, look), "debrief.trials", 280), 3);
        return row;
    }

private:
    std::vector<report::ApexError> m_errors;
};

/// How far a mark lies beside the top of the ball. Both are drawn, the ball too where it is hidden.
class MarkBesideApex final : public MarkAnswer {
public:
    // Uses the same error as the scores: the lateral distance from the axis through the ball's centre, for
    // marks in contact only.
    QString markWords(const session::TrialObject& truth, const session::LiveSample& at,
                      const QLocale& locale) const override {
        const double beside_m = std::hypot(static_cast<double>(at.p_WT_m[0]) - truth.p_WObject.x(),
                                           static_cast<double>(at.p_WT_m[1]) - truth.p_WObject.y());
        const QString mm = locale.toString(1e3 * beside_m, 'f', 1);
        if (beside_m > truth.radius_m)
            return AnswerTexts::tr("%1 mm from the top: not on the sphere").arg(mm);
        if (static_cast<double>(at.tissueNorm_N) <= scoring::kContactForce_N)
            return AnswerTexts::tr("Not counted: mark while you touch the sphere");
        return AnswerTexts::tr("%1 mm from the top").arg(mm);
    }
    bool keep(const session::TrialObject& truth, const std::optional<core::Vec3>& p_WMark) override {
        m_truth = truth;
        m_p_WMark = p_WMark;
        return true;
    }
    void show(scene3d::SceneState& drawn) const override {
        drawn.objectShown = true;
        drawn.p_WObject = m_truth.p_WObject;
        drawn.exercise.own<core::LaparoscopyCues>().body[0].q_W = {std::cos(0.5 * m_truth.turn_rad), 0.0, 0.0,
                                                                   std::sin(0.5 * m_truth.turn_rad)};
        drawn.answered = true;
        drawn.p_WAnswer = m_truth.p_WObject + m_truth.radius_m * core::Vec3::UnitZ();
        drawn.marked = m_p_WMark.has_value();
        drawn.p_WMark = m_p_WMark.value_or(core::Vec3::Zero());
    }

private:
    session::TrialObject m_truth;
    std::optional<core::Vec3> m_p_WMark;
};

class ApexLayer final : public PlaybackLayer {
public:
    QString readout(const session::PlaybackTrack&, const session::PlaybackView& view, double,
                    const QLocale& locale) const override {
        return trialReadout(view, locale);
    }
};

} // namespace

std::unique_ptr<LevelPicture> SphereApexFace::picture(const catalogue::ExerciseLevel& level,
                                                      const PictureFrame& frame) const {
    return std::make_unique<ApexPicture>(level.parameters.as<simulation::SphereApexParameters>(), frame);
}

QStringList SphereApexFace::levelFacts(const catalogue::ExerciseLevel&, const QLocale&) const {
    return {};
}

std::unique_ptr<LivePart> SphereApexFace::livePart(const catalogue::ExerciseLevel& level,
                                                   LiveSurroundings around) const {
    return std::make_unique<PointPart>(level, std::move(around));
}

std::unique_ptr<TrialAnswer> SphereApexFace::trialAnswer() const {
    return std::make_unique<MarkBesideApex>();
}

QString SphereApexFace::debriefTitle() const {
    return DebriefPartTexts::tr("The answers, seen from above");
}

QString SphereApexFace::debriefEmpty() const {
    return DebriefPartTexts::tr("There is no answer to show. The session is kept and listed.");
}

DebriefReading SphereApexFace::readDebrief(const catalogue::ExerciseLevel&,
                                           const scoring::SessionTrace& trace) const {
    return std::make_unique<ApexDebrief>(session_report::apexErrorsOf(trace));
}

std::unique_ptr<PlaybackLayer> SphereApexFace::playbackLayer(const session::SessionSetup&,
                                                             const scoring::SessionTrace&) const {
    return std::make_unique<ApexLayer>();
}

} // namespace chiron::desktop
