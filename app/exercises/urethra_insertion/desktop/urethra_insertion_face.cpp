// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/urethra_insertion_face.h"

#include "app/exercises/urethra_insertion/desktop/endoscopy.h"
#include "app/exercises/urethra_insertion/desktop/insertion_layer.h"
#include "app/exercises/urethra_insertion/desktop/insertion_panel.h"
#include "app/exercises/urethra_insertion/desktop/insertion_values.h"
#include "app/exercises/urethra_insertion/desktop/urethra_picture.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "desktop/debrief/part_widgets.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/widgets/kit.h"
#include "simulation/scene_parameters.h"

#include <QLabel>
#include <QVBoxLayout>
#include <optional>

namespace chiron::desktop {

namespace {

class InsertionPart final : public LivePart {
public:
    InsertionPart(const simulation::UrethraInsertionParameters& level, LiveSurroundings around)
        : LivePart(std::move(around)), m_level(level) {}

    InfoView* makePanel() override {
        return new InsertionPanel(around().theme, around().locale, around().cues, m_level);
    }
    double panelWidth_px() const override { return kWidePanel_px; }
    void show(const haptics::DisplayState& state, std::span<const session::LiveSample>,
              scene3d::SceneState& drawn) override {
        // The object of an endoscope is its picture.
        drawn.objectShown = state.exercise.of<simulation::EndoscopeCues>().present && around().cues.object;
    }

private:
    const simulation::UrethraInsertionParameters& m_level;
};

class InsertionDebrief final : public DebriefPart {
public:
    explicit InsertionDebrief(std::optional<report::InsertionProfile> profile)
        : m_profile(std::move(profile)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (!m_profile)
            return nullptr;
        PartColumn column(theme);
        if (m_profile->landmarks > 0) {
            auto* seen =
                kit::label(theme, DebriefPartTexts::tr("%1 of %2 landmarks of the bladder were seen.")
                                      .arg(locale.toString(m_profile->landmarksSeen),
                                           locale.toString(m_profile->landmarks)));
            seen->setObjectName(QStringLiteral("debrief.landmarks"));
            column.layout->addWidget(seen);
        }
        const report::PlotTheme look = plotThemeOf(theme, locale);
        auto* row = new ResponsiveRow(theme.px(640), theme.px(12));
        row->add(partPlot(theme, report::offsetDepthPlot(*m_profile, look), "debrief.offset", 250));
        row->add(partPlot(theme, report::alignmentDepthPlot(*m_profile, look), "debrief.alignment", 250));
        column.layout->addWidget(row);
        return std::move(column.holder);
    }

private:
    std::optional<report::InsertionProfile> m_profile;
};

QString tissueText(const std::string& tissue) {
    if (tissue == "normal")
        return LevelFactTexts::tr("Tissue: normal");
    if (tissue == "tight")
        return LevelFactTexts::tr("Tissue: tight urethra");
    if (tissue == "stricture")
        return LevelFactTexts::tr("Tissue: with a stricture, a narrow and stiff ring");
    return LevelFactTexts::tr("Tissue: %1").arg(QString::fromStdString(tissue));
}

QString depthOfFieldText(const simulation::UrethraInsertionParameters& p) {
    if (p.depthOfFieldFixed)
        return p.depthOfField ? LevelFactTexts::tr("Depth of field: on, fixed")
                              : LevelFactTexts::tr("Depth of field: off, fixed");
    return p.depthOfField ? LevelFactTexts::tr("Depth of field: on, can be switched off")
                          : LevelFactTexts::tr("Depth of field: off, can be switched on");
}

QString wayText(const simulation::UrethraInsertionParameters& p, const QLocale& locale) {
    const QString goal_mm = locale.toString(qRound(InsertionGauge(p).goal_m() * 1e3));
    return p.withdraws ? LevelFactTexts::tr("Distance: %1 mm in, then back out").arg(goal_mm)
                       : LevelFactTexts::tr("Distance: %1 mm in").arg(goal_mm);
}

QString viewText(const std::vector<std::string>& cues) {
    const bool overview = simulation::hasCue(cues, "overview");
    if (simulation::hasCue(cues, "guidance"))
        return overview ? LevelFactTexts::tr("Help: the path is marked in the picture, and a second picture "
                                             "shows it from outside")
                        : LevelFactTexts::tr("Help: the path is marked in the picture");
    return overview ? LevelFactTexts::tr("Help: a second picture shows the endoscope from outside")
                    : LevelFactTexts::tr("Help: none, only the endoscope's picture");
}

} // namespace

std::unique_ptr<LevelPicture> UrethraInsertionFace::picture(const catalogue::ExerciseLevel& level,
                                                            const PictureFrame& frame) const {
    return std::make_unique<UrethraPicture>(*endoscopyOf(level), frame);
}

QStringList UrethraInsertionFace::levelFacts(const catalogue::ExerciseLevel& level,
                                             const QLocale& locale) const {
    const simulation::UrethraInsertionParameters& p = *endoscopyOf(level);
    QStringList facts{wayText(p, locale), tissueText(p.tissue)};
    if (!p.landmarks.empty())
        facts << LevelFactTexts::tr("Landmarks of the bladder to inspect: %1")
                     .arg(locale.toString(static_cast<int>(p.landmarks.size())));
    facts << viewText(level.cues) << depthOfFieldText(p);
    facts << LevelFactTexts::tr("The trial ends after %1 s at the latest")
                 .arg(locale.toString(qRound(p.trialLimit_s)));
    return facts;
}

QStringList UrethraInsertionFace::limitWords(const session::LevelLimits& limits,
                                             const QLocale& locale) const {
    QStringList words;
    if (const auto lateral_N = limits.of("lateral_max"))
        words << GateTexts::tr("Force across the canal: %1 N at most; pressing harder is a trauma event")
                     .arg(factNumber(*lateral_N, locale));
    return words;
}

std::optional<DepthOfField> UrethraInsertionFace::depthOfField(const catalogue::ExerciseLevel& level) const {
    const simulation::UrethraInsertionParameters& p = *endoscopyOf(level);
    return DepthOfField{p.depthOfField, p.depthOfFieldFixed};
}

std::unique_ptr<LivePart> UrethraInsertionFace::livePart(const catalogue::ExerciseLevel& level,
                                                         LiveSurroundings around) const {
    return std::make_unique<InsertionPart>(*endoscopyOf(level), std::move(around));
}

QString UrethraInsertionFace::debriefTitle() const {
    return DebriefPartTexts::tr("How the endoscope followed the urethra");
}

QString UrethraInsertionFace::debriefEmpty() const {
    return DebriefPartTexts::tr("There is nothing of the procedure to show. The session is kept and listed.");
}

DebriefReading UrethraInsertionFace::readDebrief(const catalogue::ExerciseLevel&,
                                                 const scoring::SessionTrace& trace) const {
    return std::make_unique<InsertionDebrief>(session_report::insertionProfileOf(trace));
}

std::unique_ptr<PlaybackLayer> UrethraInsertionFace::playbackLayer(const session::SessionSetup& setup,
                                                                   const scoring::SessionTrace&) const {
    return std::make_unique<InsertionLayer>(endoscopyOf(setup.level)->depthOfField);
}

} // namespace chiron::desktop
