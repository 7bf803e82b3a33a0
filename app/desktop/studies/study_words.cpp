// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_words.h"

#include "session_report/procedure_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <map>

namespace chiron::desktop::study_words {

using psychophysics::Attribute;
using psychophysics::Task;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyWords)
};

/// The text of one token, or the token itself with spaces.
QString oneOf(const std::map<std::string_view, QString>& words, std::string_view token) {
    const auto found = words.find(token);
    if (found != words.end())
        return found->second;
    return QString::fromUtf8(token.data(), static_cast<qsizetype>(token.size()))
        .replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString procedureKind(std::string_view kind) {
    if (kind.substr(0, kind.find('@')) == "limit") // for a run that ended at a limit
        return Words::tr("limited by the device");
    return session_report::procedureTitle(kind);
}

} // namespace

QString attribute(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return Words::tr("Stiffness");
    case Attribute::mass:
        return Words::tr("Mass");
    case Attribute::deformation:
        return Words::tr("Deformation");
    case Attribute::roughness:
        return Words::tr("Roughness");
    case Attribute::friction:
        return Words::tr("Friction");
    case Attribute::viscosity:
        return Words::tr("Viscosity");
    case Attribute::apex:
        return Words::tr("Apex");
    }
    return {};
}

QString task(Task task) {
    switch (task) {
    case Task::rank3:
        return Words::tr("Ranking of three");
    case Task::rank3Ties:
        return Words::tr("Ranking of three, with ties");
    case Task::twoAfc:
        return Words::tr("Two alternatives (2AFC)");
    case Task::threeAfc:
        return Words::tr("Three alternatives (3AFC)");
    case Task::oddity:
        return Words::tr("Odd one out of three");
    case Task::sameDifferent:
        return Words::tr("Same or different");
    case Task::yesNo:
        return Words::tr("Yes or no");
    case Task::adjustment:
        return Words::tr("Adjustment");
    case Task::magnitude:
        return Words::tr("Magnitude estimation");
    }
    return {};
}

QString taskInWords(Task task) {
    switch (task) {
    case Task::rank3:
        return Words::tr("Three objects that differ by equal ratios are put in order.");
    case Task::rank3Ties:
        return Words::tr("Three objects that differ by equal ratios are put in order; those that feel the "
                         "same may be marked as equal.");
    case Task::twoAfc:
        return Words::tr("Which of two objects has more of the attribute?");
    case Task::threeAfc:
        return Words::tr("Which of three objects has more of the attribute? Two are the reference.");
    case Task::oddity:
        return Words::tr("Which of three objects is unlike the other two?");
    case Task::sameDifferent:
        return Words::tr("Are two objects the same or different?");
    case Task::yesNo:
        return Words::tr("Does an object have more of the attribute than the reference? Trials present the "
                         "object alone: show participants the reference before they begin.");
    case Task::adjustment:
        return Words::tr("One object is adjusted until it feels like the other.");
    case Task::magnitude:
        return Words::tr("Each object is given a number.");
    }
    return {};
}

namespace {

/// "stiffer", "heavier" ...: the comparative of the felt attribute.
QString more(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return Words::tr("stiffer");
    case Attribute::mass:
        return Words::tr("heavier");
    case Attribute::deformation:
        return Words::tr("slower to spring back");
    case Attribute::roughness:
        return Words::tr("rougher");
    case Attribute::friction:
        return Words::tr("stickier");
    case Attribute::viscosity:
        return Words::tr("more viscous");
    case Attribute::apex:
        return Words::tr("higher");
    }
    return {};
}

} // namespace

QString question(Task task, Attribute attribute) {
    const QString word = more(attribute);
    switch (task) {
    case Task::rank3:
        return Words::tr("Put the three in order: each one %1 than the one before.").arg(word);
    case Task::rank3Ties:
        return Words::tr("Put the three in order: each one %1 than the one before. You may mark those that "
                         "seem the same as equal.")
            .arg(word);
    case Task::twoAfc:
        return Words::tr("Which one is %1?").arg(word);
    case Task::threeAfc:
        return Words::tr("Which of the three is %1?").arg(word);
    case Task::oddity:
        return Words::tr("Which one is unlike the other two?");
    case Task::sameDifferent:
        return Words::tr("Are the two the same or different?");
    case Task::yesNo:
        return Words::tr("Is it %1 than the reference?").arg(word);
    case Task::adjustment:
        return Words::tr("Change object 2 until both seem the same.");
    case Task::magnitude:
        return Words::tr("Give a number to what you perceive. Any positive number is allowed.");
    }
    return {};
}

QString procedure(std::string_view id) {
    QStringList names;
    while (!id.empty()) {
        const std::size_t comma = id.find(',');
        names << procedureKind(id.substr(0, comma));
        id = comma == std::string_view::npos ? std::string_view() : id.substr(comma + 1);
    }
    names.removeDuplicates();
    return names.join(QStringLiteral(", "));
}

QString procedureInWords(std::string_view kind) {
    return session_report::procedureMeaning(kind);
}

QString scale(psychophysics::ProcedureScale scale) {
    return scale == psychophysics::ProcedureScale::difference ? Words::tr("Differences")
                                                              : Words::tr("Ratios of differences");
}

QString studyName(const database::StudySummary& study) {
    return QStringLiteral("%1 · %2").arg(QString::fromStdString(study.title),
                                         QString::fromStdString(study.key));
}

QString order(psychophysics::OrderDesign order) {
    switch (order) {
    case psychophysics::OrderDesign::fixed:
        return Words::tr("As listed");
    case psychophysics::OrderDesign::random:
        return Words::tr("Random");
    case psychophysics::OrderDesign::latinSquare:
        return Words::tr("Latin square");
    case psychophysics::OrderDesign::williams:
        return Words::tr("Williams design");
    }
    return {};
}

QString state(database::StudyState state) {
    switch (state) {
    case database::StudyState::draft:
        return Words::tr("Draft");
    case database::StudyState::frozen:
        return Words::tr("Frozen");
    case database::StudyState::closed:
        return Words::tr("Closed");
    case database::StudyState::archived:
        return Words::tr("Archived");
    }
    return {};
}

QString participantState(database::ParticipantState state) {
    switch (state) {
    case database::ParticipantState::enrolled:
        return Words::tr("Consent missing");
    case database::ParticipantState::consented:
        return Words::tr("Takes part");
    case database::ParticipantState::completed:
        return Words::tr("Completed");
    case database::ParticipantState::withdrawn:
        return Words::tr("Withdrawn");
    }
    return {};
}

QString runState(database::StudyRunState state) {
    switch (state) {
    case database::StudyRunState::open:
        return Words::tr("Open");
    case database::StudyRunState::completed:
        return Words::tr("Completed");
    case database::StudyRunState::stopped:
        return Words::tr("Stopped");
    }
    return {};
}

QString spoiled(std::string_view token) {
    const std::map<std::string_view, QString> words{
        {"force_error", Words::tr("Force not as commanded")},
        {"stiffness_error", Words::tr("Felt value off")},
        {"late_ticks", Words::tr("Late ticks")},
        {"saturation", Words::tr("Device at its limit")},
        {"speed", Words::tr("Moved too fast")},
        {"peak_force", Words::tr("Pressed too hard")},
        {"time", Words::tr("Time was up")},
        {"untouched", Words::tr("Not all touched")},
        {"taken_back", Words::tr("Taken back")},
        {"experimenter", Words::tr("Discarded by the experimenter")},
        {"stopped", Words::tr("Interrupted")},
        {"withheld", Words::tr("Sealed reason")}};
    return oneOf(words, token);
}

} // namespace chiron::desktop::study_words
