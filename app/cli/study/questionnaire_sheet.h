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

/// Collects the faults of a file, one line each, and reports them all at once so that the user can correct
/// the sheet in one go.
class SheetFaults {
public:
    void add(const QString& place, const QString& what, const QString& expected);
    bool none() const { return m_lines.isEmpty(); }
    core::Error error() const; ///< badInput with the first 20 faults and the number of the others

private:
    QStringList m_lines;
};

/// A question in the form in which files ask it. A question of a questionnaire that is asked after each
/// condition occurs once per condition. The design must outlive this object.
struct AskedQuestion {
    const psychophysics::Questionnaire* questionnaire = nullptr;
    const psychophysics::QuestionnaireItem* item = nullptr;
    /// Label of the condition that the question is about: its id, or its sealed code while the study is
    /// blinded; empty if the question is asked once
    std::string label;

    QString group() const; ///< "face_validity", "nasa_tlx@soft"
    /// "face_validity.stiffness_real", "nasa_tlx@soft.mental": the name of the question in files and
    /// messages.
    QString name() const;
};
/// All questions of these questionnaires, condition by condition if they are asked after each condition.
/// `labels` are those of the study's conditions.
std::vector<AskedQuestion>
askedQuestions(const std::vector<const psychophysics::Questionnaire*>& questionnaires,
               const std::vector<std::string>& labels);

/// An answer from a sheet, after a check of its form and scale. An answer without number and text is an empty
/// cell.
struct SheetAnswer {
    QString place; ///< FILE:LINE: column NAME, or FILE: $.path
    AskedQuestion asked;
    std::optional<double> number;
    QString text;
    bool faulty = false; ///< the cell holds something that is not a valid answer

    bool given() const { return number || !text.isEmpty(); }
};

/// The answers of one participant in a sheet.
struct SheetRow {
    QString place;
    QString code;
    std::vector<SheetAnswer> answers;
};

/// The valid answers in words, for example "a whole number from 1 (Not at all) to 5 (Completely)".
QString expectedAnswer(const psychophysics::QuestionnaireItem& item, const std::string& language);

/// The questionnaires that --questionnaire names, or all of them.
/// Errors: wrongUse.
core::Result<std::vector<const psychophysics::Questionnaire*>>
chosenQuestionnaires(const Arguments& arguments, const psychophysics::StudyDesign& design);

/// Reads the rows of a filled-in template; a file that begins with "{" is JSON, any other is CSV. Adds to
/// `faults`: wrong encoding, columns and keys that the study does not have, missing columns (unless
/// `incomplete`), and answers outside their scale. `asked` holds every question of the study.
/// Errors: badInput if the bytes are neither a table nor JSON.
core::Result<std::vector<SheetRow>> readSheet(const QByteArray& bytes, const QString& name,
                                              const std::vector<AskedQuestion>& asked, const QString& sha256,
                                              bool incomplete, SheetFaults& faults);

} // namespace chiron::cli
