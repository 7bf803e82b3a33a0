// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/instrument_catalogue.h"
#include "desktop/studies/study_page.h"

#include <QWidget>

class QPushButton;

namespace chiron::desktop {

/// Edits the questionnaires of a design and their questions.
/// Thread: GUI.
class QuestionnairesPage final : public QWidget {
    Q_OBJECT
public:
    explicit QuestionnairesPage(const DesignPage& page, QWidget* parent = nullptr);

private:
    QWidget* questionnaireBox(std::size_t index);
    QWidget* itemPart(std::size_t index, std::size_t item);
    void addQuestionnaire();
    QWidget* addButtons(bool first);
    void chooseInstrument();
    void addInstrument(const catalogue::Instrument& instrument);
    QPushButton* action(const QString& text, const char* icon, const QString& name,
                        const std::function<void(psychophysics::StudyDesign&)>& edit);
    /// The same for removing a part, which is told with Undo.
    QPushButton* removal(const QString& text, const QString& name, const std::function<QString()>& told,
                         const std::function<void(psychophysics::StudyDesign&)>& edit);

    DesignPage m_page;
};

} // namespace chiron::desktop
