// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/findings_box.h"

#include "app/exercises/palpation/desktop/palpation_words.h"
#include "app/exercises/palpation/desktop/rating_row.h"
#include "app/exercises/palpation/desktop/size_row.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <QHBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr std::array<int, 13> kKeys{Qt::Key_1,      Qt::Key_2,         Qt::Key_3,     Qt::Key_4, Qt::Key_5,
                                    Qt::Key_Plus,   Qt::Key_Equal,     Qt::Key_Minus, Qt::Key_V, Qt::Key_N,
                                    Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_D};

bool same(const simulation::PalpationCues& a, const simulation::PalpationCues& b) {
    for (std::size_t i = 0; i < a.finding.size(); ++i) {
        const simulation::Finding &x = a.finding[i], &y = b.finding[i];
        if (x.present != y.present || x.radius_m != y.radius_m || x.hardness != y.hardness ||
            x.confidence != y.confidence)
            return false;
    }
    return a.selected == b.selected;
}

} // namespace

std::span<const int> FindingsBox::keys() {
    return kKeys;
}

FindingsBox::FindingsBox(const Theme& theme, const QLocale& locale, const simulation::PalpationCues& asks,
                         double padRadius_m, QWidget* parent)
    : QWidget(parent), m_locale(locale), m_cues(asks) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    addFindings(theme);
    addRatings(theme, padRadius_m);
    addEnd(theme);
    keysTo(asks.asksHardness);
    simulation::PalpationCues none = asks;
    none.selected = -1;
    m_cues.selected = 0; // differs from `none`, so that the first show() updates everything
    show(none);
    setRunning(false);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setFocusPolicy(Qt::TabFocus); // after a click, the Enter key still sets the mark
}

void FindingsBox::addFindings(const Theme& theme) {
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addWidget(kit::label(theme, tr("Findings"), TextStyle::strong));
    m_none = kit::label(theme, tr("None yet. Press where the tissue is firmer, then mark the place (Enter)."),
                        TextStyle::small, "muted");
    m_none->setObjectName(QStringLiteral("training.no_findings"));
    column->addWidget(m_none);
    auto* chips = new FlowLayout(theme.px(4));
    for (std::size_t i = 0; i < m_chips.size(); ++i) {
        auto* chip = kit::button(theme, m_locale.toString(static_cast<int>(i) + 1));
        chip->setObjectName(QStringLiteral("training.finding_%1").arg(i));
        chip->setCheckable(true);
        connect(chip, &QPushButton::clicked, this, [this, chip, i] {
            chip->setChecked(m_cues.selected == static_cast<int>(i));
            emit reported(simulation::ReportField::select, static_cast<unsigned>(i));
        });
        m_chips[i] = chip;
        chips->addWidget(chip);
    }
    column->addLayout(chips);
    auto* row = new QHBoxLayout;
    m_about = kit::label(theme, {}, TextStyle::body);
    m_about->setObjectName(QStringLiteral("training.finding"));
    row->addWidget(m_about, 1);
    m_takeBack = kit::button(theme, tr("Take back"));
    m_takeBack->setObjectName(QStringLiteral("training.take_back"));
    m_takeBack->setToolTip(tr("Take the selected finding back (Delete)"));
    connect(m_takeBack, &QPushButton::clicked, this, &FindingsBox::takeBack);
    row->addWidget(m_takeBack, 0, Qt::AlignTop);
    column->addLayout(row);
}

void FindingsBox::addRatings(const Theme& theme, double padRadius_m) {
    if (m_cues.asksSize) {
        m_size = new SizeRow(theme, m_locale, padRadius_m);
        m_size->setObjectName(QStringLiteral("training.size"));
        connect(m_size, &SizeRow::sized, this,
                [this](unsigned tenths_mm) { emit reported(simulation::ReportField::size, tenths_mm); });
        layout()->addWidget(m_size);
    }
    const auto add = [&](bool asked, const QString& name, RatingRow::Word word, const char* id,
                         simulation::ReportField field) -> RatingRow* {
        if (!asked)
            return nullptr;
        auto* row = new RatingRow(theme, name, word);
        row->setObjectName(QLatin1String(id));
        connect(row, &RatingRow::rated, this, [this, field](int rating) {
            keysTo(field == simulation::ReportField::hardness);
            emit reported(field, static_cast<unsigned>(rating));
        });
        layout()->addWidget(row);
        return row;
    };
    m_hardness = add(m_cues.asksHardness, tr("Hardness"), &hardnessWord, "training.hardness",
                     simulation::ReportField::hardness);
    m_confidence = add(m_cues.asksConfidence, tr("Confidence"), &confidenceWord, "training.confidence",
                       simulation::ReportField::confidence);
}

void FindingsBox::addEnd(const Theme& theme) {
    m_missingText = kit::label(theme, {}, TextStyle::small);
    m_missingText->setObjectName(QStringLiteral("training.missing_text"));
    const kit::Box box = kit::box(theme, "warning");
    m_missing = box.frame;
    m_missing->setObjectName(QStringLiteral("training.missing"));
    box.layout->addWidget(m_missingText);
    m_missing->hide();
    layout()->addWidget(m_missing);
    m_done = kit::button(theme, {}, "primary");
    m_done->setObjectName(QStringLiteral("training.done"));
    connect(m_done, &QPushButton::clicked, this, &FindingsBox::done);
    layout()->addWidget(m_done);
}

void FindingsBox::show(const simulation::PalpationCues& cues) {
    if (same(cues, m_cues))
        return;
    const int before = findingCount(m_cues);
    m_cues = cues;
    m_asked = false;
    m_missing->hide();
    const int count = findingCount(cues);
    if (count > before)
        keysTo(true); // a new finding is rated in the order of the rows
    m_none->setVisible(count == 0);
    m_done->setText(count == 0 ? tr("Nothing found: end the trial (D)") : tr("Nothing more to report (D)"));
    for (std::size_t i = 0; i < m_chips.size(); ++i) {
        m_chips[i]->setVisible(cues.finding[i].present);
        m_chips[i]->setChecked(cues.selected == static_cast<int>(i));
        m_chips[i]->setAccessibleName(findingText(static_cast<int>(i), cues, m_locale));
    }
    showSelected();
    setRunning(m_running);
}

void FindingsBox::showSelected() {
    const bool any = anySelected();
    const simulation::Finding said =
        any ? m_cues.finding[static_cast<std::size_t>(m_cues.selected)] : simulation::Finding{};
    m_about->setText(any                        ? findingText(m_cues.selected, m_cues, m_locale)
                     : findingCount(m_cues) > 0 ? tr("No finding is selected.")
                                                : QString());
    m_takeBack->setVisible(any);
    if (m_size)
        m_size->setRadius(said.radius_m);
    if (m_hardness)
        m_hardness->setRating(said.hardness);
    if (m_confidence)
        m_confidence->setRating(said.confidence);
}

void FindingsBox::setRunning(bool running) {
    m_running = running;
    for (QPushButton* chip : m_chips)
        chip->setEnabled(running);
    m_takeBack->setEnabled(running && anySelected());
    m_done->setEnabled(running);
    for (QWidget* row : {static_cast<QWidget*>(m_size), static_cast<QWidget*>(m_hardness),
                         static_cast<QWidget*>(m_confidence)})
        if (row)
            row->setEnabled(running && anySelected());
}

bool FindingsBox::key(int key) {
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
        return false;
    if (!m_running)
        return true;
    if (key >= Qt::Key_1 && key <= Qt::Key_5)
        rate(key - Qt::Key_0);
    else if (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus) {
        if (m_size && anySelected())
            m_size->step(key == Qt::Key_Minus ? -1 : 1);
    } else if (key == Qt::Key_V)
        keysTo(!m_digitsRateHardness);
    else if (key == Qt::Key_N)
        selectNext();
    else if (key == Qt::Key_D)
        done();
    else
        takeBack();
    return true;
}

void FindingsBox::rate(int rating) {
    if (!anySelected() || (!m_hardness && !m_confidence))
        return;
    const bool hardness = m_digitsRateHardness;
    emit reported(hardness ? simulation::ReportField::hardness : simulation::ReportField::confidence,
                  static_cast<unsigned>(rating));
    if (hardness)
        keysTo(false); // the digits then set the next row
}

void FindingsBox::keysTo(bool hardness) {
    m_digitsRateHardness = m_hardness && (hardness || !m_confidence);
    if (m_hardness)
        m_hardness->setKeysHere(m_digitsRateHardness);
    if (m_confidence)
        m_confidence->setKeysHere(!m_digitsRateHardness);
}

void FindingsBox::selectNext() {
    const int all = static_cast<int>(simulation::kMaxFindings);
    for (int i = 1; i <= all; ++i) {
        const int next = (m_cues.selected + i + all) % all;
        if (!m_cues.finding[static_cast<std::size_t>(next)].present)
            continue;
        emit reported(simulation::ReportField::select, static_cast<unsigned>(next));
        return;
    }
}

void FindingsBox::takeBack() {
    if (anySelected())
        emit reported(simulation::ReportField::remove, static_cast<unsigned>(m_cues.selected));
}

void FindingsBox::done() {
    const QStringList missing = missingRatings(m_cues, m_locale);
    if (missing.isEmpty() || m_asked) {
        m_asked = false;
        emit reported(simulation::ReportField::done, 0);
        return;
    }
    m_asked = true;
    m_missingText->setText(tr("Still missing:\n%1\nPress again to end the trial without it.")
                               .arg(missing.join(QLatin1Char('\n'))));
    m_missing->show();
}

} // namespace chiron::desktop
