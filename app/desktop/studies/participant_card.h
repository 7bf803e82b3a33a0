// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QFrame>
#include <QLocale>
#include <utility>
#include <vector>

class QLabel;

namespace chiron::desktop {

/// What a participant will meet, beside whatever page of the design is open: made anew from the design at every change, so that it is always true.
/// GUI thread.
class ParticipantCard final : public QFrame {
    Q_OBJECT
public:
    explicit ParticipantCard(const DesignPage& page, QWidget* parent = nullptr);

private:
    void renew();

    DesignPage m_page;
    std::vector<std::pair<QString, QLabel*>> m_lines; ///< by object name
};

/// The lines of the card: object name's end ("trials") and words. Of an empty design only what can be said.
std::vector<std::pair<QString, QString>> participantFacts(const psychophysics::StudyDesign& design, const QLocale& locale, const QString& language);

} // namespace chiron::desktop
