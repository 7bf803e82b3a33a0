// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_draft.h"

namespace chiron::desktop {

/// Where a procedure lies in a design.
struct ProcedurePlace {
    std::size_t condition = 0;
    std::size_t procedure = 0;
};

/// A new procedure of a kind ("staircase" ...) that suits a condition: levels, grids and guess rate from its table and task. x is in the
/// condition's scale.
psychophysics::ProcedureSpec usualProcedure(const std::string& kind, const psychophysics::Condition& condition);
/// The kinds that suit a task, the best one first.
std::vector<std::string> kindsFor(psychophysics::Task task);

/// The main options of one procedure. GUI thread; the draft outlives it.
class ProcedureForm final : public FieldGrid {
    Q_OBJECT
public:
    ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft, ProcedurePlace place, QWidget* parent = nullptr);

private:
    template <class Spec> const Spec* spec() const;
    template <class Spec> void edit(const QString& key, const std::function<void(Spec&)>& change);
    template <class Spec> void numberOf(const QString& label, const char* key, double Spec::*member, const NumberRange& range);
    template <class Spec> void wholeOf(const QString& label, const char* key, int Spec::*member, int minimum, int maximum);
    template <class Spec> void checkOf(const QString& label, const char* key, bool Spec::*member);
    template <class Spec> void listOfLevels(const QString& label, const char* key, std::vector<double> Spec::*member);
    template <class Spec> void stopFields();
    void staircaseFields();
    void pestFields();
    void constantFields();
    void descendingFields();
    void questFields();
    void questPlusFields();
    void rank3Fields();
    QString nameOf(const char* key) const;

    StudyDraft& m_draft;
    ProcedurePlace m_place;
};

} // namespace chiron::desktop
