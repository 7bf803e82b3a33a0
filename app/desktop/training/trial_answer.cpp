// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/trial_answer.h"

namespace chiron::desktop {

QString markTaken() {
    return AnswerTexts::tr("Marked");
}

QString MarkAnswer::markWords(const session::TrialObject&, const session::LiveSample&, const QLocale&) const {
    return markTaken();
}

} // namespace chiron::desktop
