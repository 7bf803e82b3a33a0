// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export_tables.h"

#include "core/languages.h"
#include "core/units.h"
#include "session/study/trial_fidelity.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session {

namespace {

using database::StudyTrial;

const std::vector<std::pair<QString, QString>> kYesNo{{"1", "yes"}, {"0", "no"}};
constexpr int kPlaces = 3;
constexpr double kTicksPerSecond = 1.0 / core::kTickSeconds;

std::vector<ExportColumn> stimulusColumns() {
    return {{"ordinal", "1", "presentation within the run, from 0, every one counted"},
            {"practice", "", "at the largest difference, with feedback, never scored", kYesNo},
            {"scored", "", "counts for the procedure and the estimate", kYesNo},
            {"spoiled",
             "",
             "why it does not count; n/a where it does",
             {{"force_error", "force was not what was asked"},
              {"stiffness_error", "the attribute was rendered wrongly"},
              {"late_ticks", "the loop was late too often"},
              {"saturation", "force at its limit too long"},
              {"speed", "explored too fast"},
              {"peak_force", "pressed too hard"},
              {"time", "time limit"},
              {"untouched", "a place was not touched, or with less force than the design asks for"},
              {"taken_back", "practice: the participant took the answer back"},
              {"experimenter", "by the experimenter"},
              {"stopped", "the run was stopped"},
              {"withheld", "for a reason that would tell conditions apart while blinded"}}},
            {"procedure", "1", "which of the condition's interleaved procedures, from 0; n/a while blinded"},
            {"candidate", "1", "row of the design's table of differences, from 0; n/a while blinded"},
            {"arrangement", "1",
             "how the multiples of the difference lay on the places, counted as the task's arrangements; n/a "
             "while blinded where conditions differ in the task"},
            {"places", "",
             "multiples of the difference from left to right, separated by |: 0 the reference; n/a as "
             "arrangement"},
            {"difference", "log10",
             "difference D presented: a place with multiple m held reference * 10^(m D); n/a while blinded "
             "where conditions differ in the table"},
            {"value_1", "SI", "the attribute's value at the first place; n/a while blinded"},
            {"value_2", "SI", "at the second place"},
            {"value_3", "SI", "at the third place"},
            {"entropy_margin", "nat",
             "by how much the second best stimulus was worse for the procedure; n/a where it weighs none, "
             "and while blinded"}};
}

std::vector<ExportColumn> answerColumns() {
    return {
        {"response", "1",
         "answer: rank3 the order said (counted as arrangements), rank3_ties the same from 0 to 5 and with "
         "ties 6 1=2<3, 7 1=3<2, 8 2=3<1, 9 1<2=3, 10 2<1=3, 11 3<1=2, 12 1=2=3 (places from left), 2afc, "
         "3afc, oddity the place from 0, same_different 0 same 1 different, yes_no 0 no 1 yes"},
        {"correct", "",
         "the answer was right; n/a where none is, and while blinded where conditions differ in the task",
         kYesNo},
        {"outcome", "1",
         "what the procedure was told: rank3 0..5, 0 all correct; rank3_ties 0..12, as the responses with "
         "objects in true order for places; others 1 right (yes), 0 wrong (no)"},
        {"value", "", "a number said (magnitude), or the value set in SI (adjustment; n/a while blinded)"},
        {"exploration_time", "s",
         "until the answer, without pauses; n/a where nothing was explored (simulated without rendering); "
         "trials whose paused_s is n/a were stored before pauses were measured, and hold them"},
        {"response_time", "s", "from the last contact to the answer, without pauses; as exploration_time"},
        {"paused_s", "s", "pauses of the trial, until force was back in full"}};
}

/// The times that event files need, and the circumstances of the trial.
std::vector<ExportColumn> timeColumns() {
    return {
        {"sitting", "1", "which sitting of the run, from 1; n/a without a recording (quick runs)"},
        {"onset", "s",
         "start of the presentation since the sitting's recording began, pauses included; n/a as sitting"},
        {"offset", "s",
         "its end, likewise: offset - onset is how long it took with its pauses, `duration` without them"},
        {"response_onset", "s",
         "the first key or click of the answer, likewise; n/a without an answer, in simulated runs and where "
         "it was not recorded yet"},
        {"response_duration", "s", "from there to the answer; 0 where it is one key or click"},
        {"language", "",
         QStringLiteral(
             "that the participant read (%1); n/a in simulated runs and where it was not recorded yet")
             .arg(QString::fromStdString(core::listOfLanguages()))},
        {"masking_sound",
         "",
         "what was heard meanwhile; n/a as language",
         {{"pink_noise", "pink noise"},
          {"off", "none: the design has none, or it was switched off"},
          {"no_output", "none: there is no sound output"},
          {"changed", "switched on or off in the trial"}}}};
}

std::vector<ExportColumn> fidelityColumns() {
    std::vector<ExportColumn> columns{
        {"force_measured", "",
         "the device measures force; n/a, as all that follows, where nothing was rendered (quick runs)",
         kYesNo},
        {"force_error_rms", "N",
         "commanded against measured force in contact, RMS; n/a where no force is measured"},
        {"late_ticks", "1", "share of ticks that were late"},
        {"worst_lateness", "us", "of a tick"},
        {"saturated", "1", "share of contact ticks with the force at its limit"},
        {"duration", "s", "of the presentation, without pauses"},
        {"peak_force", "N", "largest force; of a shown trial the tissue's; n/a while blinded"},
        {"mean_speed", "m/s", "of the tool over the whole presentation, in contact or not"},
        {"contacts", "1", "number of contacts"},
        {"rendering_error", "1",
         "largest |rendered/asked - 1| of places with a usable estimate; a limit for stiffness, mass, "
         "viscosity and friction, n/a for the others"}};
    for (int place = 1; place <= kPlaces; ++place) {
        const QString end = QStringLiteral("_%1").arg(place);
        columns.push_back(
            {"rendered" + end, "SI",
             QStringLiteral(
                 "the attribute as rendered at place %1, by regression of force on motion; n/a while blinded")
                 .arg(place)});
        columns.push_back({"contacts" + end, "1", QStringLiteral("contacts at place %1").arg(place)});
        columns.push_back({"peak_force" + end, "N",
                           QStringLiteral("largest force at place %1; n/a while blinded").arg(place)});
        columns.push_back(
            {"terminal_force" + end, "N",
             QStringLiteral("largest force of each contact at place %1, averaged; n/a while blinded")
                 .arg(place)});
    }
    return columns;
}

QString word(const std::string& text) {
    return text.empty() ? kNotAvailable : QString::fromStdString(text);
}

void addTimes(QStringList& cells, const ExportedRun& run, const StudyTrial& trial) {
    if (trial.session <= 0) {
        for (int i = 0; i < 5; ++i)
            cells << kNotAvailable;
    } else {
        std::vector<database::SessionId> sittings;
        for (const StudyTrial& each : run.trials)
            if (each.session > 0 &&
                std::find(sittings.begin(), sittings.end(), each.session) == sittings.end())
                sittings.push_back(each.session);
        const auto seconds = [](std::uint64_t ticks) {
            return exportNumber(static_cast<double>(ticks) / kTicksPerSecond);
        };
        const auto began = circumstancesOf(trial.fidelityJson).answerTick;
        const bool answered =
            began && trial.answer >= 0 && *began >= trial.firstTick && *began <= trial.lastTick;
        cells << QString::number(std::find(sittings.begin(), sittings.end(), trial.session) -
                                 sittings.begin() + 1)
              << seconds(trial.firstTick) << seconds(trial.lastTick)
              << (answered ? seconds(*began) : kNotAvailable)
              << (answered ? seconds(trial.lastTick - *began) : kNotAvailable);
    }
    const TrialCircumstances told = circumstancesOf(trial.fidelityJson);
    cells << word(told.language) << word(told.masking);
}

/// Only for a study of the apex; along x and y of the world, mark minus apex.
std::vector<ExportColumn> markColumns() {
    return {{"mark_error_x", "m",
             "where an apex was marked beside where it is, along x; n/a in other studies, without a mark, "
             "and while blinded"},
            {"mark_error_y", "m", "the same along y"},
            {"mark_error_x_percent", "%",
             "the same along x as a share of the sphere's radius; n/a in other studies and without a mark"},
            {"mark_error_y_percent", "%", "the same along y"},
            {"mark_in_contact", "", "something was touched when it was marked", kYesNo},
            {"mark_planned", "", "drawn by the simulated observer: nothing was rendered", kYesNo}};
}

/// True if values that depend on the task may be exported: while blinded, only if all conditions have the
/// same task.
bool tellsTask(const StudyExportData& data) {
    return !data.blinded || data.oneTask;
}

bool isScored(const StudyTrial& trial) {
    return !trial.practice && !trial.undone && trial.spoiled.empty() && (trial.answer >= 0 || trial.value);
}

void addStimulus(QStringList& cells, const StudyExportData& data, const ExportedRun& run,
                 const StudyTrial& trial) {
    const auto& all = psychophysics::arrangements(run.condition->task);
    const bool known = trial.arrangement >= 0 && static_cast<std::size_t>(trial.arrangement) < all.size();
    const psychophysics::Places places =
        known ? all[static_cast<std::size_t>(trial.arrangement)] : psychophysics::Places{};
    QStringList multiples;
    for (const int multiple : places)
        multiples << QString::number(multiple);
    cells << QString::number(trial.ordinal) << exportFlag(trial.practice) << exportFlag(isScored(trial))
          << (trial.spoiled.empty() ? kNotAvailable : QString::fromStdString(trial.spoiled));
    const bool tasks = tellsTask(data), tables = !data.blinded || data.oneTable;
    cells << (data.blinded ? kNotAvailable : QString::number(trial.procedure))
          << (data.blinded ? kNotAvailable : QString::number(trial.candidate))
          << (tasks && known ? QString::number(trial.arrangement) : kNotAvailable)
          << (tasks && known ? multiples.join(u'|') : kNotAvailable)
          << (tables ? exportNumber(trial.difference) : kNotAvailable);
    for (std::size_t place = 0; place < kPlaces; ++place)
        cells << (place < places.size() && !data.blinded
                      ? exportNumber(run.condition->stimulus.reference *
                                     std::pow(10.0, places[place] * trial.difference))
                      : kNotAvailable);
    cells << (data.blinded ? kNotAvailable : exportNumber(trial.entropyMargin));
}

void addAnswer(QStringList& cells, const StudyExportData& data, const ExportedRun& run,
               const StudyTrial& trial) {
    const int right =
        trial.arrangement < 0 ? -1 : psychophysics::correctAnswer(run.condition->task, trial.arrangement);
    const bool tells = tellsTask(data);
    const auto index = [tells](int value) {
        return value < 0 || !tells ? kNotAvailable : QString::number(value);
    };
    const bool physical = run.condition->task == psychophysics::Task::adjustment;
    // An observer who received the values directly explored nothing.
    const bool timed = trial.exploration_s > 0.0;
    cells << index(trial.answer)
          << (right < 0 || trial.answer < 0 || !tells ? kNotAvailable : exportFlag(trial.answer == right))
          << index(trial.outcome)
          << (trial.value && tells && !(data.blinded && physical) ? exportNumber(*trial.value)
                                                                  : kNotAvailable)
          << (timed ? exportNumber(trial.exploration_s) : kNotAvailable)
          << (timed ? exportNumber(trial.answer_s) : kNotAvailable)
          << exportNumber(pausedOf(trial.fidelityJson));
}

void addMark(QStringList& cells, const StudyExportData& data, const StudyTrial& trial) {
    const auto mark = apexMarkOf(trial.fidelityJson);
    if (!mark) {
        for (std::size_t i = 0; i < markColumns().size(); ++i)
            cells << kNotAvailable;
        return;
    }
    const double percent =
        mark->radius_m > 0.0 ? 100.0 / mark->radius_m : std::numeric_limits<double>::quiet_NaN();
    // Beside the per cent they would reveal the radius.
    for (const double error : {mark->errorX_m, mark->errorY_m})
        cells << (data.blinded ? kNotAvailable : exportNumber(error));
    for (const double error : {mark->errorX_m, mark->errorY_m})
        cells << exportNumber(error * percent);
    cells << exportFlag(mark->inContact) << exportFlag(mark->planned);
}

void addFidelity(QStringList& cells, const StudyExportData& data, const StudyTrial& trial) {
    const QJsonObject fidelity =
        QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson)).object();
    const auto number = [](const QJsonObject& json, const char* key) {
        return exportNumber(
            json.value(QLatin1String(key)).toDouble(std::numeric_limits<double>::quiet_NaN()));
    };
    cells << (fidelity["measured"].isBool() ? exportFlag(fidelity["measured"].toBool()) : kNotAvailable);
    for (const char* key : {"force_error_rms_N", "late_ticks", "worst_lateness_us", "saturated", "duration_s",
                            "peak_force_N", "mean_speed_m_per_s", "contacts", "stiffness_error"})
        cells << (data.blinded && QLatin1String(key) == QLatin1String("peak_force_N")
                      ? kNotAvailable
                      : number(fidelity, key));
    const QJsonArray places = fidelity["places"].toArray();
    for (int place = 0; place < kPlaces; ++place) {
        QJsonObject at;
        for (const QJsonValue& each : places)
            if (each["place"].toInt(-1) == place)
                at = each.toObject();
        cells << (data.blinded ? kNotAvailable : number(at, "rendered"));
        cells << number(at, "contacts");
        for (const char* key : {"peak_force_N", "terminal_force_N"})
            // Forces reveal which object is hard and which is soft.
            cells << (data.blinded ? kNotAvailable : number(at, key));
    }
}

} // namespace

std::vector<ExportColumn> trialColumns() {
    std::vector<ExportColumn> columns = stimulusColumns();
    for (auto part : {answerColumns(), timeColumns(), markColumns(), deviceColumns(), fidelityColumns()})
        columns.insert(columns.end(), part.begin(), part.end());
    return columns;
}

QStringList trialCells(const StudyExportData& data, const ExportedRun& run, const StudyTrial& trial) {
    QStringList cells;
    addStimulus(cells, data, run, trial);
    addAnswer(cells, data, run, trial);
    addTimes(cells, run, trial);
    addMark(cells, data, trial);
    cells << (trial.device.empty() ? kNotAvailable : QString::fromStdString(trial.device))
          << (!trial.felt   ? kNotAvailable
              : *trial.felt ? QStringLiteral("felt")
                            : QStringLiteral("shown"));
    addFidelity(cells, data, trial);
    return cells;
}

} // namespace chiron::session
