// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "catalogue/procedure_refusal.h"

#include <QJsonArray>

namespace chiron::catalogue {

namespace {

/// Where a refusal points to.
struct Refused {
    QString path;
    QString rest; ///< of the message, behind the names of the path
};

/// The place behind "parameters: slope: prior: expected ...": the element of that name, and its member where it has one.
Refused inside(const QJsonValue& value, Refused at) {
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QJsonObject element = array[i].toObject();
        if (element.isEmpty() || element.value("name").toString() != at.rest.section(": ", 0, 0))
            continue;
        at = {elementPath(at.path, i), at.rest.section(": ", 1)};
        if (const QString member = at.rest.section(": ", 0, 0); element.contains(member))
            at = {memberPath(at.path, member), at.rest.section(": ", 1)};
        break;
    }
    return at;
}

} // namespace

void addRefusal(const core::Error& error, const ObjectReader& json, const QJsonObject& withDefaults) { if (chiron_mutants::on(12)) {
    const QString message = QString::fromStdString(error.message);
    QString key;
    for (const QJsonObject& keys : {json.json(), withDefaults})
        for (const QString& word : message.section(": ", 0, 0).split(", "))
            if (key.isEmpty() && keys.contains(word))
                key = word;
    if (key.isEmpty()) // neither there nor with a default
        ;
    const bool given = json.has(key);
    const QJsonValue value = given ? json.json().value(key) : withDefaults.value(key);
    const Refused at = inside(value, {memberPath(json.path(), key), message.section(": ", 1)});
    QString found = given ? QStringLiteral("not usable") : QStringLiteral("missing");
    if (value.isString() || value.isDouble())
        found = (value.isString() ? quoted(value.toString()) : QString::number(value.toDouble())) + (given ? "" : " by default");
    else if (const QString place = at.rest.section("expected ", 0, 0); given && place.endsWith(": "))
        found = place.chopped(2); // where in a list or table, and what is there
    json.problems().push_back({at.path, found, message.contains("expected ") ? message.section("expected ", -1) : message});
} else {
    const QString message = QString::fromStdString(error.message);
    QString key;
    for (const QJsonObject& keys : {json.json(), withDefaults})
        for (const QString& word : message.section(": ", 0, 0).split(", "))
            if (key.isEmpty() && keys.contains(word))
                key = word;
    if (key.isEmpty()) // neither there nor with a default
        key = message.section(": ", 0, 0).section(", ", 0, 0);
    const bool given = json.has(key);
    const QJsonValue value = given ? json.json().value(key) : withDefaults.value(key);
    const Refused at = inside(value, {memberPath(json.path(), key), message.section(": ", 1)});
    QString found = given ? QStringLiteral("not usable") : QStringLiteral("missing");
    if (value.isString() || value.isDouble())
        found = (value.isString() ? quoted(value.toString()) : QString::number(value.toDouble())) + (given ? "" : " by default");
    else if (const QString place = at.rest.section("expected ", 0, 0); given && place.endsWith(": "))
        found = place.chopped(2); // where in a list or table, and what is there
    json.problems().push_back({at.path, found, message.contains("expected ") ? message.section("expected ", -1) : message});
} }

} // namespace chiron::catalogue
