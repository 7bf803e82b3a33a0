// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QFrame>
#include <QLocale>
#include <utility>
#include <vector>

class QLabel;

namespace chiron::desktop {

/// Summarises what a participant will experience, beside every page of the design. It is rebuilt from the
/// design at every change, so that it is always up to date.
/// Thread: GUI.
class ParticipantCard final : public QFrame {
    Q_OBJECT
public:
    explicit ParticipantCard(const DesignPage& page, QWidget* parent = nullptr);

private:
    void renew();

    DesignPage m_page;
    std::vector<std::pair<QString, QLabel*>> m_lines; ///< keyed by object name
};

/// The lines of the card as pairs of the object name's end ("trials") and text. For an incomplete design,
/// only what is already known.
std::vector<std::pair<QString, QString>> participantFacts(const psychophysics::StudyDesign& design,
                                                          const QLocale& locale, const QString& language);

/// How long the trials of a participant are expected to take, and what that depends on.
QString durationWords(const psychophysics::StudyDesign& design, const QLocale& locale);

/// What happens in each condition, in its order: from the instructions to the trials that count. Empty for a
/// design without conditions.
QString sequenceWords(const psychophysics::StudyDesign& design, const QLocale& locale);

} // namespace chiron::desktop
