// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QWidget>

namespace chiron::desktop {

/// What a study is about and what participants read. GUI thread.
class GeneralPage final : public QWidget {
    Q_OBJECT
public:
    explicit GeneralPage(const DesignPage& page, QWidget* parent = nullptr);
};

/// Rules of a trial, breaks, order, blinding and the limits beyond which a trial is repeated. GUI thread.
class TrialsPage final : public QWidget {
    Q_OBJECT
public:
    explicit TrialsPage(const DesignPage& page, QWidget* parent = nullptr);

private:
    QWidget* orderBox(const DesignPage& page);
    QWidget* rulesBox(const DesignPage& page);
    QWidget* fidelityBox(const DesignPage& page);
};

} // namespace chiron::desktop
