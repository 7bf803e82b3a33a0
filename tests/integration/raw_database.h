// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <memory>
#include <optional>

struct sqlite3;

/// A database file by SQLite alone, past everything that the product does to keep it whole. For tests that
/// damage files and look at what is left of them. Not copied.
class RawDatabase {
public:
    enum class Mode { read, write };
    /// Null if SQLite cannot open it.
    static std::unique_ptr<RawDatabase> open(const QString& file, Mode mode);
    RawDatabase(const RawDatabase&) = delete;
    RawDatabase& operator=(const RawDatabase&) = delete;
    ~RawDatabase();

    /// Tables that hold rows, by name.
    QStringList tables();
    /// Hash over every row of a table, types and bits included, by ascending rowid; nothing if it cannot be
    /// read.
    std::optional<QByteArray> contentOf(const QString& table);
    /// Whether SQLite finds the structure sound.
    bool isSound();
    bool execute(const char* sql);
    std::optional<std::int64_t> integer(const QString& sql);
    QString text(const QString& sql);

    /// Flips one bit of one value, whatever its type: `draw` chooses it. False where the value is NULL or
    /// empty, or where SQLite refuses or keeps what was there.
    bool flip(const QString& table, std::int64_t rowid, const QString& column, std::uint64_t draw);

private:
    RawDatabase() = default;
    std::optional<QByteArray> valueBits(const QString& table, std::int64_t rowid, const QString& column,
                                        int& type);
    sqlite3* m_handle = nullptr;
};
