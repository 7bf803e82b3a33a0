// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace chiron::desktop {

/// The page in front of a participant. When a focused control is disabled or hidden, Qt moves the focus to
/// the next control in the Tab order, which may be any button of the page. Here the page itself takes it, so
/// that the next Enter belongs to the task. Tab moves the focus as usual. Thread: GUI.
class ParticipantPage final : public QWidget {
public:
    using QWidget::QWidget;

protected:
    bool focusNextPrevChild(bool next) override;
};

} // namespace chiron::desktop
