// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/urethra_insertion_face.h"

#include "app/exercises/urethra_insertion/desktop/endoscopy.h"
#include "app/exercises/urethra_insertion/desktop/insertion_layer.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "desktop/debrief/part_widgets.h"
#include "desktop/plots/responsive_row.h"
#include "desktop/widgets/kit.h"

#include <QLabel>
#include <QVBoxLayout>
#include <optional>

namespace chiron::desktop {

namespace {

class InsertionDebrief final : public DebriefPart {
public:
    explicit InsertionDebrief(std::optional<report::InsertionProfile> profile) : m_profile(std::move(profile)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (!m_profile)
            return nullptr;
        PartColumn column(theme);
        if (m_profile->landmarks > 0) {
            auto* seen = kit::label(theme, DebriefPartTexts::tr("%1 of %2 landmarks of the bladder were seen.")
                                               .arg(locale.toString(m_profile->landmarksSeen), locale.toString(m_profile->landmarks)));
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

} // namespace

QString UrethraInsertionFace::debriefTitle() const { return DebriefPartTexts::tr("How the endoscope followed the urethra"); }

QString UrethraInsertionFace::debriefEmpty() const { return DebriefPartTexts::tr("There is nothing of the procedure to show. The session is kept and listed."); }

DebriefReading UrethraInsertionFace::readDebrief(const catalogue::ExerciseLevel&, const scoring::SessionTrace& trace) const {
    return std::make_unique<InsertionDebrief>(session_report::insertionProfileOf(trace));
}

std::unique_ptr<PlaybackLayer> UrethraInsertionFace::playbackLayer(const session::SessionSetup& setup, const scoring::SessionTrace&) const {
    return std::make_unique<InsertionLayer>(endoscopyOf(setup.level)->depthOfField);
}

} // namespace chiron::desktop
