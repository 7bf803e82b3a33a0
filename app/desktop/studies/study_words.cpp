// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_words.h"

#include "session_report/procedure_words.h"

#include <QCoreApplication>
#include <QStringList>
#include <map>
#include <set>

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

QString otherNames(Attribute attribute) {
    switch (attribute) {
    case Attribute::stiffness:
        return Words::tr("softness, hardness, compliance, elasticity, spring");
    case Attribute::mass:
        return Words::tr("weight, heaviness, lifting");
    case Attribute::deformation:
        return Words::tr("recovery, relaxation, softness");
    case Attribute::roughness:
        return Words::tr("texture, smoothness");
    case Attribute::friction:
        return Words::tr("slipperiness, stickiness, sliding");
    case Attribute::viscosity:
        return Words::tr("damping, resistance");
    case Attribute::apex:
        return Words::tr("localisation, position, highest point, shape");
    }
    return {};
}

QString otherNames(Task task) {
    switch (task) {
    case Task::rank3:
    case Task::rank3Ties:
        return Words::tr("ordering, sorting");
    case Task::twoAfc:
        return Words::tr("2AFC, 2IFC, two-alternative forced choice, comparison, discrimination");
    case Task::threeAfc:
        return Words::tr("3AFC, three-alternative forced choice, discrimination");
    case Task::oddity:
        return Words::tr("oddity, triangle test, discrimination");
    case Task::sameDifferent:
        return Words::tr("same-different, AX, discrimination");
    case Task::yesNo:
        return Words::tr("yes-no, single stimulus");
    case Task::adjustment:
        return Words::tr("matching, point of subjective equality, PSE");
    case Task::magnitude:
        return Words::tr("scaling, rating, power law");
    }
    return {};
}

QString otherNames(const std::vector<psychophysics::Condition>& conditions) {
    std::set<Attribute> attributes;
    for (const psychophysics::Condition& condition : conditions)
        attributes.insert(condition.stimulus.attribute);
    const auto several = [](std::size_t count, const QString& one, const QString& two, const QString& three,
                            const QString& many) {
        const QString number = QString::number(count);
        return count == 1 ? one : many.arg(number) + QStringLiteral(", ") + (count == 2 ? two : three);
    };
    // Each in figures and in words, as people type it.
    return several(conditions.size(), Words::tr("1 condition, one condition"),
                   Words::tr("two conditions, comparison of conditions"),
                   Words::tr("three conditions, comparison of conditions"), Words::tr("%1 conditions")) +
           QStringLiteral(", ") +
           several(attributes.size(), Words::tr("1 attribute, one attribute"),
                   Words::tr("two attributes, comparison of attributes"),
                   Words::tr("three attributes, comparison of attributes"), Words::tr("%1 attributes"));
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

namespace {

/// "1, 3, 2": from least to most; "1, 2 = 3" where two are equal.
QString rankingText(int answer) {
    if (answer < 0 || answer >= psychophysics::kRankings)
        return {};
    const psychophysics::Ranking& ranks = psychophysics::rankings()[static_cast<std::size_t>(answer)];
    QStringList steps;
    for (int rank = 0; rank < 3; ++rank) {
        QStringList alike;
        for (std::size_t place = 0; place < ranks.size(); ++place)
            if (ranks[place] == rank)
                alike << QString::number(place + 1);
        if (!alike.isEmpty())
            steps << alike.join(QStringLiteral(" = "));
    }
    return steps.join(QStringLiteral(", "));
}

} // namespace

QString answer(Task task, Attribute attribute, int answer, std::optional<double> value,
               const QLocale& locale) {
    if (answer < 0 || answer >= psychophysics::answers(task))
        return {};
    switch (task) {
    case Task::rank3:
    case Task::rank3Ties:
        return rankingText(answer);
    case Task::twoAfc:
    case Task::threeAfc:
        return Words::tr("%1 is %2").arg(QString::number(answer + 1), more(attribute));
    case Task::oddity:
        return Words::tr("%1 is unlike the others").arg(answer + 1);
    case Task::sameDifferent:
        return answer == 0 ? Words::tr("the same") : Words::tr("different");
    case Task::yesNo:
        return answer == 0 ? Words::tr("no") : Words::tr("yes");
    case Task::adjustment:
        return Words::tr("both are the same");
    case Task::magnitude:
        return value ? plainNumber(*value, locale) : QString();
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
