// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/field_grid.h"
#include "desktop/studies/level_units.h"
#include "desktop/studies/study_draft.h"
#include "psychophysics/procedures/parameter.h"

#include <string_view>

namespace chiron::desktop {

/// The position of a procedure in a design.
struct ProcedurePlace {
    std::size_t condition = 0;
    std::size_t procedure = 0;
};

/// Edits the options of one procedure, with one control per applicable row of its parameter table
/// (psychophysics/procedures/parameter.h). Values are shown as differences in per cent of the reference.
/// Thread: GUI; the draft outlives it.
class ProcedureForm final : public FieldGrid {
    Q_OBJECT
public:
    ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft,
                  ProcedurePlace place, QWidget* parent = nullptr);

private:
    struct ControlOf; ///< creates the control for a row, by the type of its value
    /// The conversion of a stored number for display: shown = to(stored), stored = from(shown).
    struct Shown {
        std::function<double(double)> to, from;
    };

    void kindField();
    void apexField();
    void numberField(const psychophysics::Parameter& row, double value);
    void wholeField(const psychophysics::Parameter& row, int value);
    void wordField(const psychophysics::Parameter& row, const std::string& now);
    void listField(const psychophysics::Parameter& row, const std::vector<double>& values);
    void levelsField(const psychophysics::Parameter& row, const std::vector<double>& levels);
    /// Distances on x, shown as factors of the difference or as differences.
    void stepsField(const psychophysics::Parameter& row, const std::vector<double>& steps);
    void parameterField(const psychophysics::Parameter& row,
                        const std::vector<psychophysics::ParameterGrid>& grids, std::size_t index);
    void sharesField(const QString& label, const QString& key, const std::vector<double>& shares,
                     const NumberRange& range, const QString& meaning,
                     const std::function<void(std::vector<double>)>& taken);
    /// Start, end and number of points of a grid that is evenly spaced on the procedure's own scale.
    void gridFields(const QString& what, const QString& key, const std::vector<double>& values,
                    const NumberRange& range, const Shown& shown, const QString& meaning,
                    const std::function<void(std::vector<double>)>& taken);

    void put(const psychophysics::Parameter& row, const psychophysics::ParameterValue& value);
    void put(const psychophysics::Parameter& row, const QString& key,
             const std::function<void(psychophysics::ProcedureSpec&)>& change);
    void explainRow(const psychophysics::Parameter& row);
    const psychophysics::Condition& condition() const;
    const psychophysics::ProcedureSpec& procedure() const;
    LevelUnits unitsOf(const psychophysics::Parameter& row) const;
    Shown shownAs(const psychophysics::Parameter& row) const;
    NumberRange rangeOf(const psychophysics::Parameter& row) const;
    QString nameOf(std::string_view key) const;

    StudyDraft& m_draft;
    ProcedurePlace m_place;
    LevelUnits m_units;
};

} // namespace chiron::desktop
