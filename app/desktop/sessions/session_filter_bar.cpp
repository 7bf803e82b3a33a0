// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/session_filter_bar.h"

#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalBlocker>
#include <algorithm>
#include <map>
#include <tuple>

namespace chiron::desktop {

namespace {

enum Period { anyTime, today, lastWeek, lastMonth, chosen };

void select(QComboBox* box, const QVariant& value) {
    box->setCurrentIndex(std::max(box->findData(value), 0));
}

QDate firstDayOf(Period period) {
    const QDate now = QDate::currentDate();
    if (period == today)
        return now;
    return now.addDays(period == lastWeek ? -6 : -29);
}

Period periodOf(const SessionListFilter& filter) {
    if (!filter.from.isValid() && !filter.to.isValid())
        return anyTime;
    for (const Period period : {today, lastWeek, lastMonth})
        if (!filter.to.isValid() && filter.from == firstDayOf(period))
            return period;
    return chosen;
}

} // namespace

SessionFilterBar::SessionFilterBar(const Theme& theme, const catalogue::Catalogue& catalogue,
                                   const QString& language, QWidget* parent)
    : QWidget(parent) {
    auto* flow = new FlowLayout(theme.px(8), this);
    m_search = new QLineEdit;
    m_search->setObjectName(QStringLiteral("sessions.search"));
    m_search->setAccessibleName(tr("Search in the list"));
    m_search->setPlaceholderText(tr("Search: person, exercise, number"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(theme.px(230));
    m_search->installEventFilter(this);
    connect(m_search, &QLineEdit::textChanged, this, &SessionFilterBar::read);
    flow->addWidget(m_search);
    buildChoices(catalogue, language);
    buildPeriod(theme);
    m_commented = new QCheckBox(tr("Has comments"));
    m_commented->setObjectName(QStringLiteral("sessions.commented"));
    connect(m_commented, &QCheckBox::toggled, this, &SessionFilterBar::read);
    flow->addWidget(m_commented);
    m_archived = new QCheckBox(tr("Include archived"));
    m_archived->setObjectName(QStringLiteral("sessions.archived"));
    connect(m_archived, &QCheckBox::toggled, this, &SessionFilterBar::read);
    flow->addWidget(m_archived);
    m_clear = kit::button(theme, tr("Clear the filters"), "quiet");
    m_clear->setObjectName(QStringLiteral("sessions.clear"));
    connect(m_clear, &QPushButton::clicked, this, [this] {
        setFilter({});
        m_search->setFocus();
        emit changed(m_filter);
    });
    flow->addWidget(m_clear);
    setFilter({});
}

QComboBox* SessionFilterBar::choice(const QString& name, const QString& any, const QString& label) {
    auto* box = new QComboBox;
    box->setObjectName(QStringLiteral("sessions.") + name);
    box->setAccessibleName(label);
    box->addItem(any, QVariant());
    box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    connect(box, &QComboBox::currentIndexChanged, this, &SessionFilterBar::read);
    layout()->addWidget(box);
    return box;
}

void SessionFilterBar::buildChoices(const catalogue::Catalogue& catalogue, const QString& language) {
    m_person = choice(QStringLiteral("person"), tr("Everybody"), tr("Person"));
    m_exercise = choice(QStringLiteral("exercise"), tr("All exercises"), tr("Exercise"));
    m_level = choice(QStringLiteral("level"), tr("All levels"), tr("Level"));
    std::size_t levels = 0;
    for (const catalogue::Exercise& exercise : catalogue.exercises()) {
        m_exercise->addItem(QString::fromStdString(catalogue::textIn(exercise.title, language.toStdString())),
                            QString::fromStdString(exercise.id));
        levels = std::max(levels, exercise.levels.size());
    }
    for (int level = 1; level <= static_cast<int>(levels); ++level)
        m_level->addItem(tr("Level %1").arg(level), level);
    m_state = choice(QStringLiteral("state"), tr("All states"), tr("State"));
    using enum database::SessionState;
    for (const database::SessionState state :
         {running, completed, stopped, interrupted, incomplete, faulted, voided})
        m_state->addItem(SessionWords::state(state), static_cast<int>(state));
    m_outcome = choice(QStringLiteral("outcome"), tr("All results"), tr("Result"));
    for (const Outcome outcome : {Outcome::passed, Outcome::notPassed, Outcome::notScored, Outcome::practice})
        m_outcome->addItem(SessionWords::outcome(outcome), static_cast<int>(outcome));
    m_review = choice(QStringLiteral("review"), tr("Reviewed or not"), tr("Review"));
    m_review->addItem(tr("To review"), static_cast<int>(ReviewState::toReview));
    m_review->addItem(tr("Reviewed"), static_cast<int>(ReviewState::reviewed));
    m_device = choice(QStringLiteral("device"), tr("Force felt or only shown"), tr("Force"));
    m_device->addItem(tr("Force felt by the hand"), true);
    m_device->addItem(tr("Force only shown, not felt"), false);
    m_device->setToolTip(tr("Whether the device let the hand feel the force, or the screen only showed it, "
                            "as with mouse and keyboard"));
}

void SessionFilterBar::buildPeriod(const Theme& theme) {
    m_period = choice(QStringLiteral("period"), tr("Any time"), tr("When it was recorded"));
    m_period->setItemData(0, anyTime);
    m_period->addItem(tr("Today"), today);
    m_period->addItem(tr("Last 7 days"), lastWeek);
    m_period->addItem(tr("Last 30 days"), lastMonth);
    m_period->addItem(tr("Chosen days"), chosen);
    disconnect(m_period, &QComboBox::currentIndexChanged, this, nullptr);
    connect(m_period, &QComboBox::currentIndexChanged, this, &SessionFilterBar::choosePeriod);
    m_dates = new QWidget; // empty until "Chosen days" is selected
    auto* row = new QHBoxLayout(m_dates);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(8));
    m_dates->hide();
    layout()->addWidget(m_dates);
}

// The date fields are rarely needed and slow to create, so they are created only with "Chosen days".
void SessionFilterBar::makeDates() {
    if (m_from)
        return;
    m_showing = true;
    for (auto [member, name, label] :
         {std::tuple{&m_from, "from", tr("From this day")}, std::tuple{&m_to, "to", tr("To this day")}}) {
        auto* edit = new QDateEdit(QDate::currentDate());
        edit->setObjectName(QStringLiteral("sessions.") + QLatin1String(name));
        edit->setAccessibleName(label);
        edit->setToolTip(label);
        edit->setButtonSymbols(QAbstractSpinBox::NoButtons); // the arrow keys do the same
        connect(edit, &QDateEdit::dateChanged, this, &SessionFilterBar::read);
        m_dates->layout()->addWidget(edit);
        *member = edit;
    }
    m_showing = false;
}

void SessionFilterBar::choosePeriod() {
    if (m_showing)
        return;
    const auto period = static_cast<Period>(m_period->currentData().toInt());
    if (period == chosen) {
        makeDates();
        const QSignalBlocker quietFrom(m_from);
        const QSignalBlocker quietTo(m_to);
        m_from->setDate(m_filter.from.isValid() ? m_filter.from : QDate::currentDate().addDays(-29));
        m_to->setDate(m_filter.to.isValid() ? m_filter.to : QDate::currentDate());
    }
    showDates();
    read();
}

void SessionFilterBar::showDates() {
    m_dates->setVisible(m_period->currentData().toInt() == chosen);
    updateGeometry();
}

void SessionFilterBar::read() {
    if (m_showing)
        return;
    SessionListFilter filter;
    filter.text = m_search->text().trimmed();
    filter.person = m_person->currentData().toLongLong();
    filter.exercise = m_exercise->currentData().toString();
    filter.level = m_level->currentData().toInt();
    if (m_state->currentIndex() > 0)
        filter.state = static_cast<database::SessionState>(m_state->currentData().toInt());
    if (m_device->currentIndex() > 0)
        filter.felt = m_device->currentData().toBool();
    if (m_outcome->currentIndex() > 0)
        filter.outcome = static_cast<Outcome>(m_outcome->currentData().toInt());
    const auto period = static_cast<Period>(m_period->currentData().toInt());
    if (period == chosen) {
        filter.from = m_from->date();
        filter.to = m_to->date();
    } else if (period != anyTime) {
        filter.from = firstDayOf(period);
    }
    if (m_review->currentIndex() > 0)
        filter.review = static_cast<ReviewState>(m_review->currentData().toInt());
    filter.commented = m_commented->isChecked();
    filter.archived = m_archived->isChecked();
    m_clear->setEnabled(!filter.isEmpty());
    if (filter == m_filter)
        return;
    m_filter = filter;
    emit changed(m_filter);
}

void SessionFilterBar::setFilter(const SessionListFilter& filter) {
    m_filter = filter;
    m_showing = true;
    if (m_search->text().trimmed() != filter.text)
        m_search->setText(filter.text);
    select(m_person, filter.person != 0 ? QVariant(filter.person) : QVariant());
    select(m_exercise, filter.exercise.isEmpty() ? QVariant() : QVariant(filter.exercise));
    select(m_level, filter.level != 0 ? QVariant(filter.level) : QVariant());
    select(m_state, filter.state ? QVariant(static_cast<int>(*filter.state)) : QVariant());
    select(m_device, filter.felt ? QVariant(*filter.felt) : QVariant());
    select(m_outcome, filter.outcome ? QVariant(static_cast<int>(*filter.outcome)) : QVariant());
    select(m_review, filter.review ? QVariant(static_cast<int>(*filter.review)) : QVariant());
    m_commented->setChecked(filter.commented);
    select(m_period, periodOf(filter));
    if (periodOf(filter) == chosen) {
        makeDates();
        m_showing = true;
        m_from->setDate(filter.from.isValid() ? filter.from : filter.to);
        m_to->setDate(filter.to.isValid() ? filter.to : QDate::currentDate());
    }
    m_archived->setChecked(filter.archived);
    m_clear->setEnabled(!filter.isEmpty());
    m_showing = false;
    showDates();
}

void SessionFilterBar::setPeople(const std::vector<SessionRow>& rows) {
    std::map<qint64, QString> people;
    for (const SessionRow& row : rows)
        people.emplace(row.summary.person, row.person);
    std::vector<std::pair<QString, qint64>> byName;
    for (const auto& [id, name] : people)
        byName.emplace_back(name, id);
    std::sort(byName.begin(), byName.end(),
              [](const auto& a, const auto& b) { return a.first.localeAwareCompare(b.first) < 0; });
    m_showing = true;
    while (m_person->count() > 1)
        m_person->removeItem(m_person->count() - 1);
    for (const auto& [name, id] : byName)
        m_person->addItem(name, id);
    select(m_person, m_filter.person != 0 ? QVariant(m_filter.person) : QVariant());
    m_showing = false;
}

bool SessionFilterBar::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_search && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Down || key == Qt::Key_Return || key == Qt::Key_Enter) {
            emit leaveSearch();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace chiron::desktop
