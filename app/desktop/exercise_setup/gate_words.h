// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// A pass mark in words with its unit: "Misses: at most 0".
QString gateInWords(const scoring::Gate& gate, const QLocale& locale);

} // namespace chiron::desktop
