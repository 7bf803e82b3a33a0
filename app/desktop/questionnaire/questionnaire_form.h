// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/theme/theme.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

class QLabel;

namespace chiron::desktop {

/// Shows a questionnaire on one page. All of it can be filled in by keyboard.
/// Thread: GUI.
class QuestionnaireForm final : public QWidget {
    Q_OBJECT
public:
    QuestionnaireForm(const Theme& theme, const QLocale& locale,
                      const psychophysics::Questionnaire& questionnaire, const QString& language,
                      QWidget* parent = nullptr);

    /// The answers so far, with the language in which each question is shown. Items without an answer are
    /// left out. `run`: the run of the condition that the questionnaire is about; 0 if it is asked only once.
    std::vector<database::QuestionnaireAnswer> answers(database::ParticipantNumber participant,
                                                       database::StudyRunNumber run = 0) const;
    /// Marks the items that must still be answered and scrolls to the first one. Returns false if none is
    /// missing.
    bool showMissing();
    int answered() const; ///< number of items with an answer
    int items() const { return static_cast<int>(m_items.size()); }

signals:
    void changed();

private:
    struct Item {
        const psychophysics::QuestionnaireItem* asked;
        QLabel* missing;
        QWidget* first;                                           ///< gets the focus
        std::function<bool(database::QuestionnaireAnswer&)> read; ///< returns false if there is no answer
    };
    void addItem(const psychophysics::QuestionnaireItem& item);
    QLayout* ends(const Item& item) const;
    void addLikert(QLayout& layout, Item& item, const QString& name);
    void addSlider(QLayout& layout, Item& item, const QString& name);
    void addChoice(QLayout& layout, Item& item, const QString& name);
    void addNumber(QLayout& layout, Item& item, const QString& name);
    void addText(QLayout& layout, Item& item, const QString& name);

    const Theme& m_theme;
    QLocale m_locale;
    psychophysics::Questionnaire m_questionnaire;
    QString m_language;
    std::vector<Item> m_items;
};

} // namespace chiron::desktop
