// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_face.h"

#include "app/exercises/palpation/desktop/palpation_layer.h"
#include "app/exercises/palpation/desktop/palpating.h"
#include "app/exercises/palpation/desktop/palpation_box.h"
#include "app/exercises/palpation/session/palpation_record.h"

namespace chiron::desktop {

namespace {

class PalpationDebrief final : public DebriefPart {
public:
    PalpationDebrief(const simulation::PalpationParameters& level, std::vector<session::PalpationTrialRecord> records)
        : m_level(level), m_records(std::move(records)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        return m_records.empty() ? nullptr : std::make_unique<PalpationBox>(theme, locale, m_level, m_records);
    }

private:
    simulation::PalpationParameters m_level;
    std::vector<session::PalpationTrialRecord> m_records; ///< one a trial that was begun
};

} // namespace

QString PalpationFace::debriefTitle() const { return DebriefPartTexts::tr("What was searched and what was found"); }

QString PalpationFace::debriefEmpty() const { return DebriefPartTexts::tr("There is no search to show. The session is kept and listed."); }

DebriefReading PalpationFace::readDebrief(const catalogue::ExerciseLevel& level, const scoring::SessionTrace& trace) const {
    const simulation::PalpationParameters& parameters = *palpationOf(level);
    auto records = session::palpationRecord(trace, parameters);
    if (!records)
        return tl::unexpected(DebriefPartLost{
            QCoreApplication::translate("chiron::desktop::DebriefScreen",
                                        "Findings and maps could not be read from the recording. The scores above are as they were stored."),
            std::move(records.error())});
    return std::make_unique<PalpationDebrief>(parameters, std::move(*records));
}

std::unique_ptr<PlaybackLayer> PalpationFace::playbackLayer(const session::SessionSetup& setup, const scoring::SessionTrace& trace) const {
    const simulation::PalpationParameters& level = *palpationOf(setup.level);
    auto records = session::palpationRecord(trace, level);
    if (!records)
        return std::make_unique<PalpationLayer>(std::move(records.error()));
    return std::make_unique<PalpationLayer>(PalpationReplay(level, std::move(*records)));
}

} // namespace chiron::desktop
