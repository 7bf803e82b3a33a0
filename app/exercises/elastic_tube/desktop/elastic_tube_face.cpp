// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/elastic_tube_face.h"

#include "app/exercises/elastic_tube/desktop/tube_layer.h"
#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "desktop/debrief/part_widgets.h"

#include <QVBoxLayout>

namespace chiron::desktop {

namespace {

class TubeDebrief final : public DebriefPart {
public:
    explicit TubeDebrief(report::TubeReport tube) : m_tube(std::move(tube)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (m_tube.rows.empty())
            return nullptr;
        const report::PlotTheme look = plotThemeOf(theme, locale);
        PartColumn column(theme);
        column.layout->addWidget(partPlot(theme, report::tensionPlot(m_tube, look), "debrief.tension", 230));
        if (auto retraction = report::retractionPlot(m_tube, look))
            column.layout->addWidget(partPlot(theme, std::move(retraction), "debrief.retraction", 230));
        column.layout->addWidget(partPlot(theme, report::stretchPlot(m_tube, look), "debrief.stretch", 230));
        column.layout->addWidget(trialTable(theme, report::tubeTable(m_tube, locale), "debrief.tube_trials"));
        return std::move(column.holder);
    }

private:
    report::TubeReport m_tube;
};

} // namespace

QString ElasticTubeFace::debriefTitle() const { return DebriefPartTexts::tr("How the tube was held and stretched"); }

QString ElasticTubeFace::debriefEmpty() const { return DebriefPartTexts::tr("There is no tension to show. The session is kept and listed."); }

DebriefReading ElasticTubeFace::readDebrief(const catalogue::ExerciseLevel& level, const scoring::SessionTrace& trace) const {
    return std::make_unique<TubeDebrief>(session_report::tubeReportOf(trace, level));
}

std::unique_ptr<PlaybackLayer> ElasticTubeFace::playbackLayer(const session::SessionSetup& setup, const scoring::SessionTrace&) const {
    return std::make_unique<TubeLayer>(std::get<simulation::ElasticTubeParameters>(setup.level.parameters), setup.seed);
}

} // namespace chiron::desktop
