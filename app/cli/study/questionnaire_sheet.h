// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "core/result.h"
#include "psychophysics/study/study_design.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace chiron::cli {

/// Faults of a file, a line each, all told at once so that a sheet can be put right in one go.
class SheetFaults {
public:
    void add(const QString& place, const QString& what, const QString& expected);
    bool none() const { return m_lines.isEmpty(); }
    core::Error error() const; ///< badInput: the first 20, and how many more

private:
    QStringList m_lines;
};

/// A question as files ask it: of a questionnaire that is asked after each condition once for each of them. The design must outlive it.
struct AskedQuestion {
    const psychophysics::Questionnaire* questionnaire = nullptr;
    const psychophysics::QuestionnaireItem* item = nullptr;
    std::string label; ///< of the condition that it is about: its id, while the study is blinded its sealed code; empty: asked once

    QString group() const; ///< "face_validity", "nasa_tlx@soft"
    QString name() const;  ///< "face_validity.stiffness_real", "nasa_tlx@soft.mental": a question in files and messages
};
/// All of these questionnaires, condition by condition where they are asked after each. `labels`: of the study's conditions.
std::vector<AskedQuestion> askedQuestions(const std::vector<const psychophysics::Questionnaire*>& questionnaires, const std::vector<std::string>& labels);

/// An answer as a sheet gives it, its form and scale checked. Neither number nor text: an empty cell.
struct SheetAnswer {
    QString place; ///< FILE:LINE: column NAME, or FILE: $.path
    AskedQuestion asked;
    std::optional<double> number;
    QString text;
    bool faulty = false; ///< something is there that is no answer

    bool given() const { return number || !text.isEmpty(); }
};

/// What a sheet says of one participant.
struct SheetRow {
    QString place;
    QString code;
    std::vector<SheetAnswer> answers;
};

/// What an answer may be, in words: "a whole number from 1 (Not at all) to 5 (Completely)".
QString expectedAnswer(const psychophysics::QuestionnaireItem& item, const std::string& language);

/// The questionnaires that --questionnaire names, or all. Failure: wrongUse.
core::Result<std::vector<const psychophysics::Questionnaire*>> chosenQuestionnaires(const Arguments& arguments, const psychophysics::StudyDesign& design);

/// The rows of a filled template, CSV or JSON by how it begins ("{"). Adds to `faults`: encoding, columns and keys that the study has not,
/// columns that are missing (unless `incomplete`), answers outside their scale. `asked`: every question of the study. Failure: badInput for
/// what is no table or no JSON at all.
core::Result<std::vector<SheetRow>> readSheet(const QByteArray& bytes, const QString& name, const std::vector<AskedQuestion>& asked,
                                              const QString& sha256, bool incomplete, SheetFaults& faults);

} // namespace chiron::cli
